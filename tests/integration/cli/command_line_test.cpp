#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "integration/cli/command_runner.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(CommandLine, NoCommandIsAWrongCall) {
  const CommandResult result = runCommand({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("a command is missing; there are "));
  EXPECT_THAT(result.out, IsEmpty());
}

TEST(CommandLine, UnknownCommandsAreNamedWithAHint) {
  const CommandResult result = runCommand({"plannrs"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("unknown command \"plannrs\"; did you mean \"planners\"?"));
  const CommandResult nested = runCommand({"generate", "taks"});
  EXPECT_EQ(nested.exit_code, 2);
  EXPECT_THAT(nested.error, HasSubstr("unknown command \"taks\"; did you mean \"tasks\"?"));
}

TEST(CommandLine, UnknownOptionsAreNamedWithAHint) {
  const CommandResult result = runCommand({"validate", "--jsn", "x"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("unknown option --jsn; did you mean \"--json\"?"));
  const CommandResult beside_missing = runCommand({"generate", "tasks", "--levl=3"});
  EXPECT_EQ(beside_missing.exit_code, 2);
  EXPECT_THAT(beside_missing.error, HasSubstr("unknown option --levl; did you mean \"--level\"?"));
}

TEST(CommandLine, MissingAndWrongValuesAreNamed) {
  const CommandResult missing = runCommand({"validate"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.error, HasSubstr("SCENARIO is required"));
  const CommandResult level = runCommand({"generate", "tasks", "--level", "9", "--out", "x"});
  EXPECT_EQ(level.exit_code, 2);
  EXPECT_THAT(level.error, HasSubstr("--level: expected a whole number in [1, 4], found \"9\""));
  const CommandResult split = runCommand({"generate", "tasks", "--split", "tets", "--out", "x"});
  EXPECT_EQ(split.exit_code, 2);
  EXPECT_THAT(split.error, HasSubstr("expected train|validation|test, found \"tets\"; did you mean "
                                     "\"test\"?"));
  const CommandResult jobs = runCommand({"planners", "--jobs", "0"});
  EXPECT_EQ(jobs.exit_code, 2);
  EXPECT_THAT(jobs.error, HasSubstr("--jobs"));
}

TEST(CommandLine, WhatIsNoNumberInTheRangeIsRefused) {
  struct Wrong {
    std::vector<std::string> option;
    const char* message;
  };
  for (const Wrong& wrong :
       {Wrong{{"--timeout", "nan"},
              "--timeout: expected a number in [0.001, 1e+06], found \"nan\""},
        Wrong{{"--timeout", "inf"},
              "--timeout: expected a number in [0.001, 1e+06], found \"inf\""},
        Wrong{{"--timeout", "5s"}, "--timeout: expected a number in [0.001, 1e+06], found \"5s\""},
        Wrong{{"--expansions", "1.5"},
              "--expansions: expected a whole number in [1, 2000000000], found \"1.5\""},
        Wrong{{"--seed", "-1"},
              "--seed: expected a whole number in [0, 18446744073709551615], found \"-1\""}}) {
    std::vector<std::string> call{"solve", "x"};
    call.insert(call.end(), wrong.option.begin(), wrong.option.end());
    const CommandResult result = runCommand(call);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.error, HasSubstr(wrong.message));
  }
  const CommandResult threshold =
      runCommand({"export", "pddl", "x", "--out", "y", "--legality-threshold", "nan"});
  EXPECT_EQ(threshold.exit_code, 2);
  EXPECT_THAT(threshold.error,
              HasSubstr("--legality-threshold: expected a number in [0, 1], found \"nan\""));
  EXPECT_EQ(runCommand({"planners", "--seed", "18446744073709551615"}).exit_code, 0);
}

TEST(CommandLine, JsonCarriesTheErrorOfAWrongCall) {
  const CommandResult result = runCommand({"validate", "--json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(json::parse(result.out)["error"]["kind"], "call");
}

TEST(CommandLine, VersionIsPrinted) {
  const CommandResult result = runCommand({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, testing::MatchesRegex("conceptplan [0-9.]+\n"));
}

class EachCommand : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(EachCommand, HelpHasAnExampleAndTheCommonOptions) {
  std::vector<std::string> arguments = GetParam();
  std::string name = "conceptplan";
  for (const std::string& word : arguments) name += " " + word;
  arguments.push_back("--help");
  const CommandResult result = runCommand(arguments);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("Example:\n  " + name));
  for (const char* option : {"--json", "--quiet", "--seed", "--jobs"}) {
    EXPECT_THAT(result.out, HasSubstr(option));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, EachCommand,
    testing::Values(std::vector<std::string>{"generate", "concepts"},
                    std::vector<std::string>{"generate", "tasks"},
                    std::vector<std::string>{"generate", "scenarios"},
                    std::vector<std::string>{"generate", "images"},
                    std::vector<std::string>{"train"}, std::vector<std::string>{"plan"},
                    std::vector<std::string>{"solve"}, std::vector<std::string>{"evaluate"},
                    std::vector<std::string>{"inspect", "model"},
                    std::vector<std::string>{"validate"}, std::vector<std::string>{"planners"},
                    std::vector<std::string>{"inspect", "dataset"},
                    std::vector<std::string>{"inspect", "scenario"},
                    std::vector<std::string>{"doctor"}));

TEST(Planners, JsonHasTheStableNames) {
  const CommandResult result = runCommand({"planners", "--json"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.error, IsEmpty());
  const json planners = json::parse(result.out);
  ASSERT_GE(planners.size(), 2u);
  for (const json& planner : planners) {
    for (const char* key : {"name", "summary", "source", "guarantees", "options"}) {
      EXPECT_TRUE(planner.contains(key)) << key;
    }
    for (const json& option : planner["options"]) {
      for (const char* key : {"name", "type", "default", "range", "summary"}) {
        EXPECT_TRUE(option.contains(key)) << key;
      }
    }
  }
}

TEST(Planners, TextNamesTheDefaultPlanner) {
  EXPECT_THAT(runCommand({"planners"}).out, HasSubstr("belief"));
}

TEST(Doctor, JsonNamesEveryCheck) {
  const CommandResult result = runCommand({"doctor", "--json"});
  const json answer = json::parse(result.out);
  EXPECT_EQ(result.exit_code, answer["ok"] ? 0 : 2);
  std::vector<std::string> names;
  for (const json& check : answer["checks"]) {
    names.push_back(check["name"]);
    EXPECT_TRUE(check["ok"].is_boolean());
    EXPECT_THAT(check["found"].get<std::string>(), Not(IsEmpty()));
    EXPECT_TRUE(check["ok"] || !check["advice"].get<std::string>().empty()) << check;
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"Torch", "OpenCV", "Embree", "FCL", "NLopt", "Eigen",
                                            "yaml-cpp", "BLAS", "threads"}));
}

}  // namespace
}  // namespace conceptplan::cli
