#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "domain/scenario/sample_scenario.hpp"
#include "integration/cli/command_runner.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A folder with a valid scenario in pictures, whose parts the tests spoil.
class ValidateCommand : public testing::Test {
 protected:
  ValidateCommand() {
    writeScenario(folder_.path(), pictureScenario(2), sampleReference());
    text_ = readFile(folder_ / "scenario.yaml");
  }

  CommandResult validateText(const std::string& text) const {
    folder_.write("scenario.yaml", text);
    return runCommand({"validate", folder_.path().string()});
  }

  std::string replaced(const std::string& from, const std::string& to) const {
    std::string text = text_;
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from << " is not in\n" << text;
    return text.replace(position, from.size(), to);
  }

  const TemporaryFolder folder_;
  std::string text_;
};

TEST_F(ValidateCommand, AllFaultsComeTogether) {
  std::filesystem::remove(folder_ / "initial.depth.png");
  const std::string mask = readFile(folder_ / "goal.mask.png");
  folder_.write("goal.mask.png", mask.substr(0, mask.size() - 20));
  const CommandResult result = validateText(replaced("render: true", "render: maybe\ncolour: red"));
  EXPECT_EQ(result.exit_code, 2);
  const std::string file = (folder_ / "scenario.yaml").string();
  EXPECT_THAT(result.error, HasSubstr(file + ":4:"));
  EXPECT_THAT(result.error, HasSubstr("initial.depth.png: file not found"));
  EXPECT_THAT(result.error, HasSubstr("goal.mask.png: truncated PNG"));
  EXPECT_THAT(result.error, HasSubstr("render: expected true or false, found \"maybe\""));
  EXPECT_THAT(result.error, HasSubstr("colour: unknown key"));
}

TEST_F(ValidateCommand, UnknownPlannerAndOptionsHaveTheirLine) {
  const CommandResult result = validateText(replaced("name: belief", "name: beleif"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, testing::ContainsRegex("scenario.yaml:7:[0-9]+: planner.name: "));
  EXPECT_THAT(result.error, HasSubstr("did you mean \"belief\"?"));
  const CommandResult option =
      validateText(replaced("name: belief", "name: belief, options: {legality_treshold: 0.1}"));
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_THAT(option.error, HasSubstr("planner.options.legality_treshold"));
  EXPECT_THAT(option.error, HasSubstr("scenario.yaml:7:"));
}

TEST_F(ValidateCommand, AnUnknownAlgorithmOfTheRefinementHasItsLine) {
  const CommandResult result =
      validateText(text_ + "refine: {clearance_m: 0.01, algorithm: slqsp}\n");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error,
              testing::ContainsRegex("scenario.yaml:[0-9]+:[0-9]+: refine.algorithm: "));
  EXPECT_THAT(result.error, HasSubstr("expected one of slsqp | mma | ccsaq | cobyla, found "
                                      "\"slqsp\"; did you mean \"slsqp\"?"));
  const CommandResult known =
      validateText(text_ + "refine: {clearance_m: 0.01, algorithm: ccsaq, max_evaluations: 50}\n");
  EXPECT_THAT(known.error, testing::Not(HasSubstr("refine")));
}

TEST_F(ValidateCommand, TargetOutsideTheMaskIsNamed) {
  const CommandResult result = validateText(replaced("target: 1", "target: 9"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("scenario.yaml:6:9: target: instance 9 is not in the initial "
                                      "mask, which shows the objects 1, 2"));
}

TEST_F(ValidateCommand, BrokenReferenceIsNamedWithItsOwnLine) {
  folder_.write("reference.yaml", "conceptplan: 1\nlevel: 7\n");
  const CommandResult result = validateText(text_);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("reference.yaml:2:8: level: expected a whole number"));
}

TEST_F(ValidateCommand, JsonListsEveryFaultAndNothingElse) {
  folder_.write("scenario.yaml", replaced("target: 1", "target: one"));
  const CommandResult result = runCommand({"validate", folder_.path().string(), "--json"});
  EXPECT_EQ(result.exit_code, 2);
  const json answer = json::parse(result.out);
  EXPECT_FALSE(answer["ok"]);
  const json fault = answer["scenarios"][0]["faults"][0];
  EXPECT_EQ(fault["line"], 6);
  EXPECT_EQ(fault["column"], 9);
  EXPECT_EQ(fault["key"], "target");
}

TEST_F(ValidateCommand, MissingPathIsNamedAndOthersAreStillChecked) {
  folder_.write("scenario.yaml", replaced("goal:", "nam: x\ngoal:"));
  const CommandResult result =
      runCommand({"validate", (folder_ / "absent").string(), folder_.path().string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("absent: no such file or folder"));
  EXPECT_THAT(result.error, HasSubstr("scenario.yaml:5:1: nam: unknown key"));
}

}  // namespace
}  // namespace conceptplan::cli
