#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "conceptplan/domain/camera.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/kmeans.hpp"
#include "conceptplan/learner/learned_symbols.hpp"
#include "conceptplan/learner/training/augmentation.hpp"
#include "token_measures.hpp"
#include "training_stages.hpp"

namespace conceptplan::training {
namespace {

/// Where an object stands and how large it is, measured from its depth picture.
struct Extent {
  Eigen::Vector2d p_WMiddle{0, 0};  ///< of the visible surface
  Outline outline;                  ///< of the visible surface, about its middle
  double height_m = 0;              ///< above the workbench
};

/// Share of varied validation objects that pass for learned, by each measure.
constexpr double kShareLearned = 0.999;

/// Objects of a dataset as the learner and the tape measure see them.
struct ObservedObjects {
  std::vector<EncoderInput> inputs;
  std::vector<Extent> extents;
  std::vector<ConceptValues> values;
};

Extent measure(const ObjectCrop& crop, const Camera& camera) {
  Extent extent;
  std::vector<Eigen::Vector2d> seen;
  for (int i = 0; i < ObjectCrop::kEdge * ObjectCrop::kEdge; ++i) {
    const auto pixel = static_cast<std::size_t>(i);
    if (crop.mask[pixel] == 0 || !(crop.depth_m[pixel] > 0)) continue;
    const Eigen::Vector2d at(crop.left + i % ObjectCrop::kEdge + 0.5,
                             crop.top + i / ObjectCrop::kEdge + 0.5);
    const Eigen::Vector3d p_W = camera.unproject(at, crop.depth_m[pixel]);
    seen.push_back(p_W.head<2>());
    extent.height_m = std::max(extent.height_m, p_W.z());
  }
  if (seen.empty()) return extent;
  Eigen::Vector2d low = seen.front(), high = seen.front();
  for (const Eigen::Vector2d& p_W : seen) low = low.cwiseMin(p_W), high = high.cwiseMax(p_W);
  extent.p_WMiddle = 0.5 * (low + high);
  for (std::size_t k = 0; k < Outline::kDirections; ++k)
    for (const Eigen::Vector2d& p_W : seen)
      extent.outline.support_m[k] =
          std::max(extent.outline.support_m[k], outlineDirection(k).dot(p_W - extent.p_WMiddle));
  return extent;
}

/// Up to `most` objects, evenly spread over the dataset.
ObservedObjects observe(const Run& run, const ConceptDataset& data, std::size_t most,
                        const std::string& what) {
  const Camera camera = standardCamera();
  const std::size_t count = std::min(most, data.size());
  ObservedObjects observed;
  for (std::size_t i = 0; i < count; ++i) {
    const ConceptSample sample = data.sample(i * data.size() / count);
    observed.inputs.push_back(encoderInput(sample.crop));
    observed.extents.push_back(measure(sample.crop, camera));
    observed.values.push_back(conceptValues(sample.object));
    if (i % 500 == 0) run.report({what, i, count, ""});
  }
  return observed;
}

/// The place of each symbol along one axis: the given cells, in the order of the symbols' mean
/// measured coordinate.
std::vector<int> orderAlong(const std::vector<Symbols>& symbols, Concept which, std::size_t count,
                            const std::vector<double>& coordinate) {
  std::vector<double> sum(count, 0), seen(count, 0);
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const std::size_t symbol = index(symbols[i][index(which)]);
    sum[symbol] += coordinate[i];
    seen[symbol] += 1;
  }
  std::vector<int> order(count), place(count);
  std::iota(order.begin(), order.end(), 0);
  const auto mean = [&](int symbol) {
    const auto s = static_cast<std::size_t>(symbol);
    return seen[s] > 0 ? sum[s] / seen[s] : std::numeric_limits<double>::infinity();
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return mean(a) < mean(b); });
  for (std::size_t i = 0; i < count; ++i)
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return place;
}

/// The value that one in twenty exceeds, which may be misread. @pre there are values
double high(std::vector<double> values) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The prism around objects of the same TYPE, SIZE and ROTATION symbols, about the middle of their
/// cells, in which they stand right on average. What faces away from the camera, which looks along
/// y, is hidden in part: there the object is taken to reach as far as towards the camera.
Footprint footprintOf(const std::vector<Extent>& extents,
                      const std::vector<Eigen::Vector2d>& offsets) {
  Eigen::Vector2d offset(0, 0);
  for (const Eigen::Vector2d& one : offsets) offset += one / static_cast<double>(offsets.size());
  Footprint footprint;
  std::vector<double> values(extents.size());
  const auto highest = [&](auto measure_m) {
    std::transform(extents.begin(), extents.end(), values.begin(), measure_m);
    return std::max(1e-3, high(values));
  };
  auto& support_m = footprint.outline.support_m;
  for (std::size_t k = 0; k < Outline::kDirections; ++k)
    support_m[k] = highest([&](const Extent& extent) {
      return extent.outline.support_m[k] + outlineDirection(k).dot(offset);
    });
  for (std::size_t k = 1; k < Outline::kDirections / 2; ++k)
    support_m[k] = std::max(support_m[k], support_m[opposite(k)]);
  footprint.outline = tightened(footprint.outline);
  footprint.height_m = highest([](const Extent& extent) { return extent.height_m; });
  return footprint;
}

/// Of each TYPE, SIZE and ROTATION symbol; those never seen together take what surrounds all.
FootprintTable footprints(const std::vector<Symbols>& symbols, const std::vector<Extent>& extents,
                          const SymbolGrounding& cells, const ConceptCardinality& cardinality) {
  const std::size_t types = cardinality[index(Concept::kType)];
  const std::size_t sizes = cardinality[index(Concept::kSize)];
  const std::size_t rotations = cardinality[index(Concept::kRotation)];
  const Workbench workbench;
  std::vector<std::vector<Extent>> seen(types * sizes * rotations);
  std::vector<std::vector<Eigen::Vector2d>> offsets(seen.size());
  const auto at = [&](std::size_t type, std::size_t size, std::size_t rotation) {
    return (type * sizes + size) * rotations + rotation;
  };
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const std::size_t group =
        at(index(symbols[i][index(Concept::kType)]), index(symbols[i][index(Concept::kSize)]),
           index(symbols[i][index(Concept::kRotation)]));
    seen[group].push_back(extents[i]);
    offsets[group].push_back(extents[i].p_WMiddle - workbench.p_WCell(cells.cell(symbols[i])));
  }
  std::vector<Footprint> measured(seen.size());
  Footprint around;
  for (std::size_t group = 0; group < seen.size(); ++group) {
    if (seen[group].empty()) continue;
    measured[group] = footprintOf(seen[group], offsets[group]);
    around = {unionOf(around.outline, measured[group].outline),
              std::max(around.height_m, measured[group].height_m)};
  }
  FootprintTable table = uniformFootprints(cardinality, around);
  for (std::size_t type = 0; type < types; ++type)
    for (std::size_t size = 0; size < sizes; ++size)
      for (std::size_t rotation = 0; rotation < rotations; ++rotation) {
        const std::size_t group = at(type, size, rotation);
        if (!seen[group].empty()) table[type][size][rotation] = measured[group];
      }
  return table;
}

/// The value that most objects of each symbol show.
std::vector<int> valuesOf(const std::vector<Symbols>& symbols,
                          const std::vector<ConceptValues>& values, Concept which,
                          std::size_t count) {
  std::vector<std::vector<int>> votes(count,
                                      std::vector<int>(kConceptCardinality[index(which)], 0));
  for (std::size_t i = 0; i < symbols.size(); ++i)
    ++votes[index(symbols[i][index(which)])][values[i][index(which)]];
  std::vector<int> winners;
  for (const auto& of_symbol : votes)
    winners.push_back(
        static_cast<int>(std::max_element(of_symbol.begin(), of_symbol.end()) - of_symbol.begin()));
  return winners;
}

std::vector<Symbols> nearestSymbols(const Symbolizer& symbolizer,
                                    const std::vector<Tokens>& tokens) {
  std::vector<Symbols> symbols;
  for (const Tokens& one : tokens) symbols.push_back(symbolizer.nearest(one));
  return symbols;
}

/// The validation objects with the variations of training: parts hidden, light changed.
std::vector<EncoderInput> varied(const std::vector<EncoderInput>& inputs,
                                 const AugmentationOptions& options, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<EncoderInput> result;
  for (const EncoderInput& input : inputs)
    result.push_back(augmented(input.planes, input.location,
                               inputs[generator() % inputs.size()].planes, options, generator));
  return result;
}

/// What all but few pictures of learned objects keep below, each measure by itself.
PictureResidual mostResidual(const ConceptLearner& learner,
                             const std::vector<EncoderInput>& inputs) {
  const std::vector<DrawnObject> drawn = learner.draw(learner.encode(inputs));
  Eigen::MatrixXd residuals(static_cast<Eigen::Index>(inputs.size()), 3);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const PictureResidual one = pictureResidual(inputs[i], drawn[i]);
    residuals.row(static_cast<Eigen::Index>(i)) << one.silhouette, one.depth_m, one.color;
  }
  const auto most = [&](Eigen::Index measure) {
    return quantile(residuals.col(measure), kShareLearned);
  };
  return {most(0), most(1), most(2)};
}

/// Fits temperatures and reaches, and adds accuracy and calibration on validation to the measures.
void calibrate(std::array<SymbolClusters, kNumConcepts>& clusters, const std::vector<Tokens>& plain,
               const std::vector<Tokens>& changed, const std::vector<ConceptValues>& truth,
               const std::array<std::vector<int>, kNumConcepts>& values, ModelManifest& manifest) {
  std::vector<bool> all_right(plain.size(), true);
  for (const Concept which : kConcepts) {
    const std::size_t k = index(which);
    const auto row = static_cast<Eigen::Index>(k);
    const auto symbol_of = [&](int value) {
      const auto at = std::find(values[k].begin(), values[k].end(), value);
      return at == values[k].end() ? std::optional<SymbolId>()
                                   : SymbolId{static_cast<std::int32_t>(at - values[k].begin())};
    };
    std::vector<Eigen::VectorXd> rows;
    std::vector<SymbolId> right;
    double correct = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const auto symbol = symbol_of(truth[i][k]);
      Eigen::Index nearest = 0;
      squaredDistances(clusters[k], plain[i].row(row)).minCoeff(&nearest);
      const bool ok = symbol && index(*symbol) == static_cast<std::size_t>(nearest);
      correct += ok ? 1 : 0;
      all_right[i] = all_right[i] && ok;
      if (!symbol) continue;
      rows.push_back(squaredDistances(clusters[k], changed[i].row(row)));
      right.push_back(*symbol);
    }
    Eigen::MatrixXd distances(static_cast<Eigen::Index>(rows.size()), clusters[k].centers.rows());
    for (std::size_t i = 0; i < rows.size(); ++i)
      distances.row(static_cast<Eigen::Index>(i)) = rows[i];
    const Calibration calibration = conceptplan::calibrate(distances, right, kShareLearned);
    clusters[k].temperature = calibration.temperature;
    clusters[k].reach = calibration.reach;
    const std::string concept_name(name(which));
    manifest.measures["validation/accuracy/" + concept_name] =
        correct / static_cast<double>(plain.size());
    manifest.measures["validation/calibration_error/" + concept_name] = calibration.error;
  }
  manifest.measures["validation/accuracy/all"] =
      static_cast<double>(std::count(all_right.begin(), all_right.end(), true)) /
      static_cast<double>(plain.size());
}

}  // namespace

std::vector<Work> symbolWork() {
  return {{"data: concepts-train", 0.8},
          {"data: concepts-validation", 0.1},
          {"reading concepts-train", 0.2},
          {"symbols", 0.1},
          {"reading concepts-validation", 0.2}};
}

bool makeSymbols(const Run& run, ModelManifest& manifest) {
  const auto train_data = conceptData(run, Split::kTrain);
  if (!train_data) return false;
  const auto validation_data = conceptData(run, Split::kValidation);
  if (!validation_data) return false;
  const auto path = run.options.model / kConceptsFile;
  const ConceptLearner learner(decodeTensors(readFile(path), path), manifest.encoder, path);

  const ObservedObjects train =
      observe(run, *train_data, run.profile.symbol_images, "reading concepts-train");
  const std::vector<Tokens> train_tokens = learner.encode(train.inputs);
  if (run.cancelled()) return false;
  std::array<SymbolClusters, kNumConcepts> clusters;
  for (const Concept which : kConcepts) {
    run.report({"symbols", index(which), kNumConcepts, ""});
    KMeansOptions options;
    options.seed = run.options.seed;
    KMeansResult result =
        kMeans(tokensOf(train_tokens, which), kConceptCardinality[index(which)], options);
    manifest.measures["train/suspicious_clusters/" + std::string(name(which))] =
        result.suspicious ? 1 : 0;
    if (result.suspicious) {
      run.log(nlohmann::ordered_json{
          {"stage", "symbols"}, {"concept", name(which)}, {"doubt", result.reason}}
                  .dump());
      run.warn("symbols of " + std::string(name(which)) +
               " may be merged or split values: " + result.reason);
    }
    clusters[index(which)].centers = std::move(result.centers);
  }

  const ObservedObjects validation =
      observe(run, *validation_data, run.profile.validation_images, "reading concepts-validation");
  const std::vector<Tokens> plain = learner.encode(validation.inputs);
  const std::vector<Tokens> changed = learner.encode(
      varied(validation.inputs, run.profile.concepts.augmentation, run.options.seed));
  const Symbolizer provisional(clusters);
  const std::vector<Symbols> train_symbols = nearestSymbols(provisional, train_tokens);
  const std::vector<Symbols> validation_symbols = nearestSymbols(provisional, plain);
  std::array<std::vector<int>, kNumConcepts> values;
  for (const Concept which : kConcepts)
    values[index(which)] =
        valuesOf(validation_symbols, validation.values, which, kConceptCardinality[index(which)]);
  calibrate(clusters, plain, changed, validation.values, values, manifest);
  // Nothing hidden: what hides an object in a frame is known there.
  AugmentationOptions unhidden = run.profile.concepts.augmentation;
  unhidden.occlusion = 0;
  const PictureResidual most_residual =
      mostResidual(learner, varied(validation.inputs, unhidden, run.options.seed));
  addTokenScores(tokenScores(plain, validation.values, run.options.seed), "validation",
                 manifest.measures);

  SymbolGrounding grounding;
  std::vector<double> x, y;
  for (const Extent& extent : train.extents)
    x.push_back(extent.p_WMiddle.x()), y.push_back(extent.p_WMiddle.y());
  const auto cardinality = provisional.cardinality();
  grounding.columns =
      orderAlong(train_symbols, Concept::kPositionX, cardinality[index(Concept::kPositionX)], x);
  grounding.rows =
      orderAlong(train_symbols, Concept::kPositionY, cardinality[index(Concept::kPositionY)], y);
  grounding.footprints = footprints(train_symbols, train.extents, grounding, cardinality);
  grounding.names = symbolNames(values);
  writeFileAtomically(run.options.model / kSymbolsFile,
                      encodeTensors(tensorsOf(LearnedSymbols{Symbolizer(std::move(clusters)),
                                                             grounding, values, most_residual}),
                                    TensorPrecision::kFloat32));
  return true;
}

}  // namespace conceptplan::training
