#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A model that uses every part of the format.
SymbolicModel fullModel() {
  SymbolicModel model = testing::tinyModel();
  model.grounding.names[index(Concept::kColor)] = {"red", "b\"lue"};
  model.evidence.steps = {1, 2, 3, 4, 5, 6, 7};
  model.evidence.transitions[1][4].add(2, 1, 2);
  model.evidence.legality[0] = {
      {{{ContextKind::kNearestOffset, Concept::kType, SymbolId{1}}}, {{25, {3, 4}}}}};
  return model;
}

std::string replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

std::vector<Fault> faultsOf(const std::string& json) {
  try {
    parseSymbolicModel(json, "model.json");
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

TEST(SymbolicModelFile, RoundTripsThroughText) {
  const SymbolicModel model = fullModel();
  EXPECT_EQ(parseSymbolicModel(toJson(model), "x"), model);
}

TEST(SymbolicModelFile, RoundTripsThroughAFile) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / "conceptplan_model_round_trip.json";
  writeSymbolicModel(path, fullModel());
  EXPECT_EQ(readSymbolicModel(path), fullModel());
  std::filesystem::remove(path);
}

TEST(SymbolicModelFile, AMissingFileIsAnInputError) {
  EXPECT_THROW(readSymbolicModel("/nowhere/symbols.json"), InputError);
}

TEST(SymbolicModelFile, ATruncatedFileIsTold) {
  const std::string json = toJson(fullModel());
  const std::vector<Fault> faults = faultsOf(json.substr(0, json.size() / 2));
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_THAT(faults[0].text(), HasSubstr("expected a JSON document"));
  EXPECT_GT(faults[0].line.value_or(0), 1);
}

TEST(SymbolicModelFile, TheLineOfBrokenSyntaxIsTold) {
  const std::vector<Fault> faults = faultsOf("{\n \"format\": \"x\",\n ?\n}");
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_EQ(faults[0].line, 3);
  EXPECT_EQ(faults[0].column, 2);
}

TEST(SymbolicModelFile, AnotherVersionIsTold) {
  const std::vector<Fault> faults =
      faultsOf(replaced(toJson(fullModel()), "\"version\": 2", "\"version\": 7"));
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_EQ(faults[0].text(), "model.json: version: expected 2, found 7");
}

TEST(SymbolicModelFile, AllFaultsComeTogether) {
  std::string json = toJson(fullModel());
  json = replaced(json, "\"own_symbol\"", "\"own_smybol\"");
  json = replaced(json, "\"stays\": 1.0", "\"stays\": \"one\"");
  json = replaced(json, "\"support_m\"", "\"support\"");
  const std::vector<Fault> faults = faultsOf(json);
  std::string text;
  for (const Fault& fault : faults) text += fault.text() + "\n";
  EXPECT_THAT(text, HasSubstr("grounding.footprints[0][0][0].support_m: missing"));
  EXPECT_THAT(text, HasSubstr(".stays: expected a number, found string"));
  EXPECT_THAT(text, HasSubstr("found \"own_smybol\""));
}

TEST(SymbolicModelFile, ARowThatIsNoDistributionIsTold) {
  const std::vector<Fault> faults = faultsOf(replaced(toJson(fullModel()), "0.8", "0.9"));
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_THAT(faults[0].text(), HasSubstr("a row sums to 1.1"));
}

TEST(SymbolicModelFile, PartsOfAnotherKindAreTold) {
  EXPECT_THAT(faultsOf("[]"), SizeIs(1));
  std::string json = toJson(fullModel());
  json = json.substr(0, json.find("\"actions\"")) + "\"actions\": 5}";
  EXPECT_THAT(faultsOf(json), ::testing::Not(IsEmpty()));
}

}  // namespace
}  // namespace conceptplan
