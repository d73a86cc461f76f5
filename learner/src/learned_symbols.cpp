#include "conceptplan/learner/learned_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

/// Of one footprint: its supports and its height.
constexpr std::size_t kFootprintNumbers = Outline::kDirections + 1;

constexpr const char* kResidualKey = "pictures.most_residual";

std::string prefix(Concept which) { return "symbols." + std::string(name(which)) + "."; }

NamedTensor vectorOf(const std::vector<int>& numbers) {
  return {{static_cast<std::int64_t>(numbers.size())}, {numbers.begin(), numbers.end()}};
}

/// Reads tensors of one file and collects what is wrong with them.
class TensorReader {
 public:
  TensorReader(const NamedTensors& tensors, const std::filesystem::path& path)
      : tensors_(tensors), path_(path) {}

  const NamedTensor* find(const std::string& key, std::size_t dimensions) {
    const auto found = tensors_.find(key);
    if (found != tensors_.end() && found->second.shape.size() == dimensions) return &found->second;
    fault(key,
          "expected a tensor of " + std::to_string(dimensions) + " dimensions, found " +
              (found == tensors_.end() ? std::string("none")
                                       : "one of " + std::to_string(found->second.shape.size())));
    return nullptr;
  }

  std::vector<int> integers(const std::string& key, std::size_t count, int limit) {
    std::vector<int> numbers;
    if (const NamedTensor* tensor = find(key, 1))
      for (const float value : tensor->values)
        if (value >= 0 && value < static_cast<float>(limit) && value == std::floor(value))
          numbers.push_back(static_cast<int>(value));
    if (numbers.size() != count)
      fault(key, "expected " + std::to_string(count) + " whole numbers from 0 to " +
                     std::to_string(limit - 1));
    numbers.resize(count);
    return numbers;
  }

  void fault(const std::string& key, const std::string& message) {
    faults_.push_back({path_.string(), std::nullopt, std::nullopt, key, message});
  }

  void throwIfFaulty() {
    if (!faults_.empty()) throw InputError(std::move(faults_));
  }

 private:
  const NamedTensors& tensors_;
  const std::filesystem::path& path_;
  std::vector<Fault> faults_;
};

constexpr float kFarthestCentre = 1e6F;  // tokens have length 8; squares must not overflow
constexpr int kMostCells = 1000;         // columns or rows of a workbench

}  // namespace

std::array<std::vector<std::string>, kNumConcepts> symbolNames(
    const std::array<std::vector<int>, kNumConcepts>& values) {
  const SymbolGrounding standard = standardGrounding();
  std::array<std::vector<std::string>, kNumConcepts> names;
  for (const Concept which : kConcepts)
    for (const int value : values[index(which)])
      names[index(which)].push_back(standard.name(which, SymbolId{value}));
  return names;
}

NamedTensors tensorsOf(const LearnedSymbols& symbols) {
  NamedTensors tensors;
  for (const Concept which : kConcepts) {
    const SymbolClusters& clusters = symbols.symbolizer.clusters(which);
    const float* from = clusters.centers.data();
    tensors[prefix(which) + "centers"] = {{clusters.centers.rows(), clusters.centers.cols()},
                                          {from, from + clusters.centers.size()}};
    tensors[prefix(which) + "temperature"] = {{1}, {static_cast<float>(clusters.temperature)}};
    tensors[prefix(which) + "reach"] = {{1}, {static_cast<float>(clusters.reach)}};
    tensors[prefix(which) + "values"] = vectorOf(symbols.values[index(which)]);
  }
  const PictureResidual& most = symbols.most_residual;
  tensors[kResidualKey] = {{3},
                           {static_cast<float>(most.silhouette), static_cast<float>(most.depth_m),
                            static_cast<float>(most.color)}};
  tensors["grounding.columns"] = vectorOf(symbols.grounding.columns);
  tensors["grounding.rows"] = vectorOf(symbols.grounding.rows);
  NamedTensor& footprints = tensors["grounding.footprints"];
  const auto& table = symbols.grounding.footprints;
  footprints.shape = {static_cast<std::int64_t>(table.size()),
                      static_cast<std::int64_t>(table.front().size()),
                      static_cast<std::int64_t>(table.front().front().size()), kFootprintNumbers};
  for (const auto& of_type : table)
    for (const auto& of_size : of_type)
      for (const Footprint& footprint : of_size) {
        for (const double support_m : footprint.outline.support_m)
          footprints.values.push_back(static_cast<float>(support_m));
        footprints.values.push_back(static_cast<float>(footprint.height_m));
      }
  return tensors;
}

LearnedSymbols learnedSymbolsFrom(const NamedTensors& tensors, const std::filesystem::path& path) {
  TensorReader reader(tensors, path);
  std::array<SymbolClusters, kNumConcepts> clusters;
  std::array<std::vector<int>, kNumConcepts> values;
  std::array<std::size_t, kNumConcepts> cardinality{};
  for (const Concept which : kConcepts) {
    const std::size_t k = index(which);
    const NamedTensor* centers = reader.find(prefix(which) + "centers", 2);
    const NamedTensor* temperature = reader.find(prefix(which) + "temperature", 1);
    const NamedTensor* reach = reader.find(prefix(which) + "reach", 1);
    if (centers == nullptr || temperature == nullptr || reach == nullptr) continue;
    if (centers->shape[0] < 1 || centers->shape[1] != TokenMatrix::ColsAtCompileTime ||
        temperature->values.size() != 1 || reach->values.size() != 1) {
      reader.fault(prefix(which) + "centers",
                   "expected [n, 64] centres, one temperature and one reach");
      continue;
    }
    cardinality[k] = static_cast<std::size_t>(centers->shape[0]);
    clusters[k].centers = Eigen::Map<const TokenMatrix>(centers->values.data(), centers->shape[0],
                                                        TokenMatrix::ColsAtCompileTime);
    clusters[k].temperature = temperature->values.front();
    clusters[k].reach = reach->values.front();
    if (!(clusters[k].centers.cwiseAbs().maxCoeff() <= kFarthestCentre))
      reader.fault(prefix(which) + "centers", "expected numbers from -1e6 to 1e6");
    if (!(clusters[k].reach > 0))
      reader.fault(prefix(which) + "reach", "expected a positive number");
    if (!(clusters[k].temperature > 0))
      reader.fault(prefix(which) + "temperature", "expected a positive number");
    values[k] = reader.integers(prefix(which) + "values", cardinality[k],
                                static_cast<int>(kConceptCardinality[k]));
  }
  PictureResidual most;
  if (const NamedTensor* residual = reader.find(kResidualKey, 1)) {
    const std::vector<float>& limits = residual->values;
    if (limits.size() == 3 &&
        std::ranges::all_of(limits, [](float limit) { return limit > 0 && std::isfinite(limit); }))
      most = {limits[0], limits[1], limits[2]};
    else
      reader.fault(kResidualKey, "expected three positive numbers");
  }
  SymbolGrounding grounding;
  grounding.columns =
      reader.integers("grounding.columns", cardinality[index(Concept::kPositionX)], kMostCells);
  grounding.rows =
      reader.integers("grounding.rows", cardinality[index(Concept::kPositionY)], kMostCells);
  const std::size_t types = cardinality[index(Concept::kType)];
  const std::size_t sizes = cardinality[index(Concept::kSize)];
  const std::size_t rotations = cardinality[index(Concept::kRotation)];
  const NamedTensor* footprints = reader.find("grounding.footprints", 4);
  if (footprints != nullptr &&
      footprints->values.size() == types * sizes * rotations * kFootprintNumbers) {
    const float* from = footprints->values.data();
    grounding.footprints = uniformFootprints(cardinality, {});
    for (auto& of_type : grounding.footprints)
      for (auto& of_size : of_type)
        for (Footprint& footprint : of_size) {
          std::copy_n(from, Outline::kDirections, footprint.outline.support_m.begin());
          footprint.height_m = from[Outline::kDirections];
          from += kFootprintNumbers;
        }
  } else if (footprints != nullptr) {
    reader.fault("grounding.footprints", "expected [types, sizes, rotations, 17]");
  }
  reader.throwIfFaulty();
  grounding.names = symbolNames(values);
  for (const std::string& message : grounding.faults(cardinality))
    reader.fault("grounding", message);
  reader.throwIfFaulty();
  return {Symbolizer(std::move(clusters)), std::move(grounding), std::move(values), most};
}

}  // namespace conceptplan
