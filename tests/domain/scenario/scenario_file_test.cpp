#include "conceptplan/domain/scenario/scenario_file.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "domain/scenario/sample_scenario.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kSymbols =
    "{type: 1, position_x: 0, position_y: 2, rotation: 3, color: 4, size: 0}";

/// A folder with a valid scenario in pictures of two objects, whose text tests then replace.
class ScenarioFile : public testing::Test {
 protected:
  ScenarioFile() { writeScenario(folder_.path(), pictureScenario(2), std::nullopt); }

  std::string faultsOfText(const std::string& text) const {
    const auto path = folder_.write("scenario.yaml", text);
    return faultsOf([&] { readScenario(path); });
  }

  const TemporaryFolder folder_;
  const std::string pictures_ =
      "initial: {rgb: initial.rgb.png, depth: initial.depth.png, mask: initial.mask.png}\n"
      "goal: {rgb: goal.rgb.png, depth: goal.depth.png, mask: goal.mask.png}\n";
  const std::string head_ = "conceptplan: 1\nname: sample\n";
};

TEST_F(ScenarioFile, RoundTripInPictures) {
  Scenario written = pictureScenario(2);
  written.model = "other";
  written.target = 2;
  written.planner = {"bfs", {{"symbols", "hard"}}, 3};
  written.refine = {0.01, "mma", 500};
  written.render = false;
  const auto folder = folder_ / "again";
  writeScenario(folder, written, sampleReference());
  const Scenario read = readScenario(folder);
  EXPECT_EQ(read.name, "sample");
  EXPECT_EQ(read.model, "other");
  EXPECT_EQ(read.target, 2);
  EXPECT_EQ(read.planner.name, "bfs");
  EXPECT_EQ(read.planner.options, written.planner.options);
  EXPECT_EQ(read.planner.top, 3);
  EXPECT_EQ(read.refine, written.refine);
  EXPECT_FALSE(read.render);
  EXPECT_EQ(read.reference, folder / "reference.yaml");
  EXPECT_EQ(std::get<PictureInput>(read.input).goal.mask, sampleFrame(2).mask);
  EXPECT_EQ(read.positions.at("name").line, 2);
}

TEST_F(ScenarioFile, RoundTripInSymbols) {
  Scenario written;
  written.name = "symbols";
  GivenSymbols given;
  given.fill(SymbolId{1});
  given[index(Concept::kColor)] = std::vector<double>{0.25, 0.75};
  written.input = SymbolInput{{given, given}, given};
  written.target = 2;
  writeScenario(folder_ / "symbols", written, std::nullopt);
  const Scenario read = readScenario(folder_ / "symbols");
  const auto& input = std::get<SymbolInput>(read.input);
  EXPECT_EQ(input.objects.size(), 2u);
  EXPECT_EQ(input.goal, given);
}

TEST_F(ScenarioFile, DefaultsHold) {
  folder_.write("scenario.yaml", head_ + pictures_);
  const Scenario read = readScenario(folder_.path());
  EXPECT_EQ(read.model, "default");
  EXPECT_EQ(read.target, std::nullopt);
  EXPECT_EQ(read.planner.name, "belief");
  EXPECT_EQ(read.planner.top, 5);
  EXPECT_EQ(read.refine, std::nullopt);
  EXPECT_TRUE(read.render);
  EXPECT_EQ(read.reference, std::nullopt);
}

TEST_F(ScenarioFile, UnknownKeysAreNamedWithAHint) {
  const std::string faults =
      faultsOfText(head_ + pictures_ + "taget: 1\nplanner: {nam: bfs}\nzzz: 1\n");
  EXPECT_THAT(faults, HasSubstr("scenario.yaml:5:1: taget: unknown key; did you mean \"target\"?"));
  EXPECT_THAT(faults, HasSubstr(":6:11: planner.nam: unknown key; did you mean \"name\"?"));
  EXPECT_THAT(faults, HasSubstr(":7:1: zzz: unknown key\n"));
}

TEST_F(ScenarioFile, WrongTypesAreNamed) {
  const std::string faults = faultsOfText(head_ + pictures_ +
                                          "target: one\nplanner: {top: 0, options: [1]}\n"
                                          "refine: {clearance_m: much}\nrender: 3\nmodel: [a]\n");
  EXPECT_THAT(faults, HasSubstr(":5:9: target: expected a whole number in [1, 255], found "
                                "\"one\""));
  EXPECT_THAT(faults, HasSubstr("planner.top: expected a whole number in [1, 1000], found \"0\""));
  EXPECT_THAT(faults, HasSubstr("planner.options: expected a map of keys, found a list"));
  EXPECT_THAT(faults, HasSubstr("refine.clearance_m: expected a number in [0, 1], found "
                                "\"much\""));
  EXPECT_THAT(faults, HasSubstr("render: expected true or false, found \"3\""));
  EXPECT_THAT(faults, HasSubstr("model: expected text, found a list"));
}

TEST_F(ScenarioFile, RefinementHasItsDefaultsAndFaults) {
  folder_.write("scenario.yaml", head_ + pictures_ + "refine: {clearance_m: 0.02}\n");
  EXPECT_EQ(readScenario(folder_.path()).refine, RefinementChoice{0.02});
  const std::string faults = faultsOfText(
      head_ + pictures_ + "refine: {algorithm: [mma], max_evaluations: 0, algoritm: mma}\n");
  EXPECT_THAT(faults, HasSubstr("refine.clearance_m: the key is missing"));
  EXPECT_THAT(faults, HasSubstr("refine.algorithm: expected text, found a list"));
  EXPECT_THAT(faults, HasSubstr("refine.max_evaluations: expected a whole number in [1, 1000000], "
                                "found \"0\""));
  EXPECT_THAT(faults, HasSubstr("refine.algoritm: unknown key; did you mean \"algorithm\"?"));
}

TEST_F(ScenarioFile, QuotedNumbersAreText) {
  EXPECT_THAT(faultsOfText(head_ + pictures_ + "target: \"1\"\n"),
              HasSubstr("target: expected a whole number"));
}

TEST_F(ScenarioFile, VersionAndNameAreRequired) {
  EXPECT_THAT(faultsOfText("conceptplan: 2\n" + pictures_),
              testing::AllOf(HasSubstr(":1:14: conceptplan: expected a whole number in [1, 1]"),
                             HasSubstr("name: the key is missing")));
  EXPECT_THAT(faultsOfText("name: x\n" + pictures_), HasSubstr("conceptplan: the key is missing"));
  EXPECT_THAT(faultsOfText(head_), testing::AllOf(HasSubstr("initial: the key is missing"),
                                                  HasSubstr("goal: the key is missing")));
}

TEST_F(ScenarioFile, RepeatedKeyIsNamedWithItsFirstLine) {
  EXPECT_THAT(faultsOfText(head_ + pictures_ + "name: again\n"),
              HasSubstr(":5:1: name: the key is given twice; first at line 2"));
}

TEST_F(ScenarioFile, MalformedYamlHasItsLine) {
  EXPECT_THAT(faultsOfText(head_ + "initial: {rgb: a\n"),
              testing::ContainsRegex("scenario.yaml:[0-9]+:[0-9]+: malformed YAML"));
  EXPECT_THAT(faultsOfText("- a\n- b\n"), HasSubstr("expected a map of keys, found a list"));
  EXPECT_THAT(faultsOfText(""), HasSubstr("expected a map of keys, found nothing"));
  EXPECT_THAT(faultsOfText(std::string(200000, '[')), HasSubstr("malformed YAML"));
}

TEST_F(ScenarioFile, FaultsOfTheCallersCheckComeWithTheOthers) {
  const auto path =
      folder_.write("scenario.yaml", head_ + pictures_ + "planner: {name: odd}\nzzz: 1\n");
  const std::string faults = faultsOf([&] {
    readScenario(path, [](const Scenario& scenario) {
      return std::vector{scenario.fault("planner.name", scenario.planner.name + " is unknown")};
    });
  });
  EXPECT_THAT(faults, HasSubstr("scenario.yaml:6:1: zzz: unknown key"));
  EXPECT_THAT(faults, HasSubstr("scenario.yaml:5:11: planner.name: odd is unknown"));
}

TEST_F(ScenarioFile, MissingScenarioIsNamed) {
  EXPECT_THAT(faultsOf([&] { readScenario(folder_ / "absent"); }), HasSubstr("file not found"));
}

TEST_F(ScenarioFile, AllPictureFaultsComeTogetherAtTheirKeys) {
  std::filesystem::remove(folder_ / "initial.rgb.png");
  const std::string depth = readFile(folder_ / "initial.depth.png");
  folder_.write("initial.depth.png", depth.substr(0, depth.size() - 5));
  RgbdImage small{8, 8, std::vector<std::uint8_t>(192), std::vector<float>(64),
                  std::vector<std::uint8_t>(64, 1)};
  writeRgbdImage(folder_ / "small", small);
  const std::string faults = faultsOfText(
      head_ +
      "initial: {rgb: initial.rgb.png, depth: initial.depth.png, mask: initial.mask.png}\n"
      "goal: {rgb: goal.rgb.png, depth: goal.depth.png, mask: small.mask.png}\n"
      "reference: absent.yaml\ntarget: 0\n");
  EXPECT_THAT(faults, HasSubstr(":3:16: initial.rgb: "));
  EXPECT_THAT(faults, HasSubstr("initial.rgb.png: file not found"));
  EXPECT_THAT(faults, HasSubstr("initial.depth.png: truncated PNG"));
  EXPECT_THAT(faults, HasSubstr("goal.mask: "));
  EXPECT_THAT(faults, HasSubstr("expected the size of the RGB picture, 384 x 256, found 8 x 8"));
  EXPECT_THAT(faults, HasSubstr("reference: file not found"));
  EXPECT_THAT(faults, HasSubstr("target: expected a whole number in [1, 255]"));
}

TEST_F(ScenarioFile, FramesOfAnotherSizeAreRefused) {
  RgbdImage small{8, 8, std::vector<std::uint8_t>(192), std::vector<float>(64),
                  std::vector<std::uint8_t>(64, 1)};
  writeRgbdImage(folder_ / "initial", small);
  EXPECT_THAT(faultsOfText(head_ + pictures_),
              HasSubstr("expected a frame of 384 x 256, found 8 x 8"));
}

TEST_F(ScenarioFile, TargetMustBeInBothMasks) {
  writeRgbdImage(folder_ / "goal", sampleFrame(1));
  const std::string faults = faultsOfText(head_ + pictures_ + "target: 2\n");
  EXPECT_THAT(faults, HasSubstr(":5:9: target: instance 2 is not in the goal mask, which shows "
                                "the objects 1"));
  EXPECT_THAT(faults, Not(HasSubstr("initial mask")));
}

TEST_F(ScenarioFile, EmptyMaskIsRefused) {
  writeRgbdImage(folder_ / "goal", sampleFrame(0));
  EXPECT_THAT(faultsOfText(head_ + pictures_), HasSubstr("no object: every pixel is 0"));
}

TEST_F(ScenarioFile, MissingPictureKeysAreNamed) {
  EXPECT_THAT(faultsOfText(head_ + "initial: {rgb: initial.rgb.png}\ngoal: 3\n"),
              HasSubstr("goal: expected a map of keys, found \"3\""));
  EXPECT_THAT(faultsOfText(head_ + "initial: {}\n" + pictures_.substr(pictures_.find("goal"))),
              testing::AllOf(HasSubstr("initial.rgb: the key is missing"),
                             HasSubstr("initial.depth: the key is missing"),
                             HasSubstr("initial.mask: the key is missing")));
}

TEST_F(ScenarioFile, SymbolFaultsComeTogether) {
  const std::string faults = faultsOfText(
      head_ +
      "initial:\n"
      "  symbols:\n"
      "    objects:\n"
      "      - {type: -1, position_x: a, position_y: [0.5, 0.4], rotation: 0, color: 0, size: 0}\n"
      "      - {type: 1, position_x: 0, position_y: [0.5, 1.5], rotation: 0, colour: 0, size: 0}\n"
      "goal: {symbols: " +
      kSymbols + "}\n");
  EXPECT_THAT(faults, HasSubstr(":6:16: initial.symbols.objects[0].type: expected a symbol's "
                                "number"));
  EXPECT_THAT(faults, HasSubstr("objects[0].position_x: expected a symbol's number"));
  EXPECT_THAT(faults, HasSubstr("objects[0].position_y: expected a symbol's number, or a list of "
                                "probabilities that sum to 1; found the sum 0.9"));
  EXPECT_THAT(faults, HasSubstr("objects[1].position_y"));
  EXPECT_THAT(faults, HasSubstr("objects[1].colour: unknown key; did you mean \"color\"?"));
  EXPECT_THAT(faults, HasSubstr("objects[1].color: the key is missing"));
  EXPECT_THAT(faults, HasSubstr("target: the key is missing: with symbols and 2 objects"));
}

TEST_F(ScenarioFile, PicturesAndSymbolsDoNotMix) {
  const std::string goal = pictures_.substr(pictures_.find("goal"));
  const std::string symbols = "initial: {symbols: {objects: [" + kSymbols + "]}";
  EXPECT_THAT(faultsOfText(head_ + symbols + "}\n" + goal),
              HasSubstr("initial and goal must both be given in pictures, or both in symbols"));
  EXPECT_THAT(faultsOfText(head_ + symbols + ", rgb: a.png}\ngoal: {symbols: " + kSymbols + "}\n"),
              HasSubstr("initial.rgb: a picture cannot stand beside symbols"));
  EXPECT_THAT(faultsOfText(
                  head_ + "initial: {symbols: {objects: []}}\ngoal: {symbols: " + kSymbols + "}\n"),
              HasSubstr("expected a list of 1 to 255 objects, found a list of 0"));
}

TEST_F(ScenarioFile, FindsScenariosByFileFolderAndParent) {
  writeScenario(folder_ / "set/b", pictureScenario(1), std::nullopt);
  writeScenario(folder_ / "set/a", pictureScenario(1), std::nullopt);
  using Paths = std::vector<std::filesystem::path>;
  EXPECT_EQ(findScenarios(folder_.path()), Paths{folder_ / "scenario.yaml"});
  EXPECT_EQ(findScenarios(folder_ / "scenario.yaml"), Paths{folder_ / "scenario.yaml"});
  EXPECT_EQ(findScenarios(folder_ / "set"),
            (Paths{folder_ / "set/a/scenario.yaml", folder_ / "set/b/scenario.yaml"}));
  std::filesystem::create_directory(folder_ / "empty");
  EXPECT_THAT(faultsOf([&] { findScenarios(folder_ / "empty"); }),
              HasSubstr("no scenario.yaml in the folder or in its sub-folders"));
  EXPECT_THAT(faultsOf([&] { findScenarios(folder_ / "absent"); }),
              HasSubstr("no such file or folder"));
}

TEST_F(ScenarioFile, RoundTripOfSeveralTargets) {
  Scenario written = pictureScenario(3);
  written.target.reset();
  written.targets = {3, 1};
  writeScenario(folder_ / "pictures", written, std::nullopt);
  EXPECT_EQ(readScenario(folder_ / "pictures").targets, written.targets);
  GivenSymbols given;
  given.fill(SymbolId{1});
  GivenSymbols goal = given;
  goal[index(Concept::kColor)] = std::vector<double>{0.25, 0.75};
  written.input = SymbolInput{{given, given, given}, {}, {given, goal}};
  writeScenario(folder_ / "symbols", written, std::nullopt);
  const Scenario read = readScenario(folder_ / "symbols");
  EXPECT_EQ(read.targets, written.targets);
  EXPECT_EQ(std::get<SymbolInput>(read.input).goals, (std::vector<GivenSymbols>{given, goal}));
}

TEST_F(ScenarioFile, SeveralTargetsHaveAPlannerOfTheirOwn) {
  folder_.write("scenario.yaml", head_ + pictures_ + "targets: [1, 2]\n");
  EXPECT_EQ(readScenario(folder_.path()).planner.name, "astar");
  folder_.write("scenario.yaml", head_ + pictures_ + "targets: [1, 2]\nplanner: {name: greedy}\n");
  EXPECT_EQ(readScenario(folder_.path()).planner.name, "greedy");
}

TEST_F(ScenarioFile, FaultsOfSeveralTargetsAreNamed) {
  EXPECT_THAT(faultsOfText(head_ + pictures_ + "targets: [1]\n"),
              HasSubstr(":5:10: targets: expected a list of at least 2 instance ids, found a list "
                        "of 1"));
  EXPECT_THAT(faultsOfText(head_ + pictures_ + "targets: 1\n"), HasSubstr("found \"1\""));
  const std::string faults = faultsOfText(
      head_ + pictures_ + "targets: [1, 1, 0, 9]\ntarget: 1\nrefine: {clearance_m: 0.01}\n");
  EXPECT_THAT(faults, HasSubstr(":5:14: targets: instance 1 is given twice"));
  EXPECT_THAT(faults,
              HasSubstr(":5:17: targets: expected an instance id in [1, 255], found \"0\""));
  EXPECT_THAT(faults, HasSubstr("targets: instance 9 is not in the initial mask"));
  EXPECT_THAT(faults, HasSubstr(":6:9: target: cannot stand beside targets"));
  EXPECT_THAT(faults, HasSubstr("refine: a plan for several targets cannot be refined"));
}

TEST_F(ScenarioFile, SeveralTargetsInSymbolsHaveAGoalEach) {
  const std::string initial =
      "initial: {symbols: {objects: [" + kSymbols + ", " + kSymbols + "]}}\ntargets: [1, 2]\n";
  EXPECT_THAT(faultsOfText(head_ + initial + "goal: {symbols: " + kSymbols + "}\n"),
              HasSubstr("goal.symbols: expected a list with what each of the 2 targets should "
                        "become, found a map"));
  EXPECT_THAT(faultsOfText(head_ + initial + "goal: {symbols: [" + kSymbols + "]}\n"),
              HasSubstr("found a list of 1"));
  EXPECT_THAT(faultsOfText(head_ + initial + "goal: {symbols: [" + kSymbols + ", {type: 1}]}\n"),
              HasSubstr("goal.symbols[1].color: the key is missing"));
  EXPECT_THAT(
      faultsOfText(head_ + "initial: {symbols: {objects: [" + kSymbols +
                   "]}}\ntargets: [1, 2]\ngoal: {symbols: [" + kSymbols + ", " + kSymbols + "]}\n"),
      HasSubstr("targets: expected objects in [1, 1], found 2"));
}

}  // namespace
}  // namespace conceptplan
