#include <gmock/gmock.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/pipeline/model_manifest.hpp"
#include "domain/files/temporary_folder.hpp"
#include "integration/cli/command_runner.hpp"
#include "planners/learned_world.hpp"
#include "planners/pddl/pddl_task.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A model whose networks have learned nothing, but whose symbolic model is a good one: plans from
/// symbols are right, those from pictures are not.
class ModelCommands : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    root_ = std::filesystem::path(::testing::TempDir()) /
            ("conceptplan-model-commands-" + std::to_string(::getpid()));
    std::filesystem::remove_all(root_);
    const std::vector<std::string> train{"train", "all",       "--data", data(),     "--model",
                                         model(), "--profile", "smoke",  "--resume", "--json"};
    interrupted_ = runInterrupted(
        train, [] { return std::filesystem::exists(root_ / "data/concepts-train"); });
    trained_ = runCommand(train);
    if (trained_.exit_code != 0) return;
    std::filesystem::create_directories(root_ / "as-trained");
    std::filesystem::copy(model(), root_ / "as-trained/model");
    const ModelManifest manifest = readModelManifest(model());
    writeSymbolicModel(root_ / "model" / kTransitionsFile, conceptplan::testing::learnedModel());
    writeModelManifest(model(), manifest);
    for (const char* level : {"3", "4"}) {
      runCommand({"generate", "scenarios", "--level", level, "--count", "3", "--symbols-only",
                  "--model", model(), "--out", scenarios()});
    }
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(root_); }

  void SetUp() override { ASSERT_EQ(trained_.exit_code, 0) << trained_.error; }

  static std::string data() { return (root_ / "data").string(); }
  static std::string model() { return (root_ / "model").string(); }
  static std::string scenarios() { return (root_ / "scenarios").string(); }

  static std::vector<json> lines(const std::filesystem::path& file) {
    std::vector<json> results;
    std::istringstream text(readFile(file));
    for (std::string line; std::getline(text, line);) results.push_back(json::parse(line));
    return results;
  }

  /// The file without what clocks decide.
  static std::string timeless(const std::filesystem::path& file) {
    std::string text;
    for (json& result : lines(file)) {
      result.erase("times_ms");
      text += result.dump() + "\n";
    }
    return text;
  }

  const TemporaryFolder folder_;
  static inline std::filesystem::path root_;
  static inline CommandResult interrupted_;
  static inline CommandResult trained_;
};

TEST_F(ModelCommands, TrainingGoesOnAfterAnInterrupt) {
  EXPECT_EQ(interrupted_.exit_code, 130) << interrupted_.error;
  EXPECT_THAT(interrupted_.error, HasSubstr("interrupted; what was finished is kept"));
  EXPECT_EQ(json::parse(interrupted_.out)["error"]["kind"], "interrupted");
  EXPECT_TRUE(json::parse(trained_.out).contains("measures"));
}

TEST_F(ModelCommands, TellsOfSymbolsThatMayBeMergedOrSplitValues) {
  EXPECT_THAT(trained_.error, HasSubstr("warning: symbols of "));
  const json answer = json::parse(runCommand({"inspect", "model", model(), "--json"}).out);
  const std::string shown = runCommand({"inspect", "model", model()}).out;
  for (const json& entry : answer["concepts"]) {
    const std::string warning = "warning: symbols of " + entry["name"].get<std::string>();
    EXPECT_EQ(shown.find(warning) != std::string::npos, entry["suspicious_clusters"].get<bool>());
  }
}

TEST_F(ModelCommands, TrainsAgainOnlyIfAsked) {
  const CommandResult refused = runCommand(
      {"train", "all", "--data", data(), "--model", model(), "--profile", "smoke", "--seed", "0"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.error, HasSubstr("go on with --resume, or begin again with --anew"));
  EXPECT_EQ(runCommand({"train", "all", "--data", data(), "--model", model(), "--resume", "--anew"})
                .exit_code,
            2);
}

TEST_F(ModelCommands, TrainTellsItsStageAndTheTimeLeftOfAll) {
  EXPECT_THAT(trained_.error, HasSubstr("stage 1 of 4: data: concepts-train  "));
  EXPECT_THAT(trained_.error, HasSubstr(" left in all"));
}

TEST_F(ModelCommands, KilledAtAnyMomentTrainingGoesOnToTheSameModel) {
  const std::filesystem::path killed = root_ / "killed";
  const std::vector<std::string> train{"train",     "all",
                                       "--data",    (killed / "data").string(),
                                       "--model",   (killed / "model").string(),
                                       "--profile", "smoke",
                                       "--resume"};
  for (const char* moment :
       {"data/concepts-train/concepts-00001.bin", "model/concepts.checkpoint",
        "model/manifest.json", "data/tasks-train/images/level3-000000/00.rgb.png",
        "model/vict.checkpoint"}) {
    const CommandResult result =
        runKilled(train, [&] { return std::filesystem::exists(killed / moment); });
    EXPECT_EQ(result.exit_code, 128 + SIGKILL) << moment << result.error;
  }
  const CommandResult ended = runCommand(train);
  ASSERT_EQ(ended.exit_code, 0) << ended.error;
  for (const char* file :
       {"manifest.json", kConceptsFile, kSymbolsFile, kTransitionsFile, kVictFile}) {
    EXPECT_EQ(readFile(killed / "model" / file), readFile(root_ / "as-trained/model" / file))
        << file;
  }
  for (const char* stage : {"concepts", "vict"}) {
    EXPECT_FALSE(std::filesystem::exists(killed / "model" / (std::string(stage) + ".checkpoint")));
  }
}

TEST_F(ModelCommands, TrainNamesUnknownStagesAndProfiles) {
  const CommandResult stage = runCommand({"train", "concept", "--data", "d", "--model", "m"});
  EXPECT_EQ(stage.exit_code, 2);
  EXPECT_THAT(stage.error, HasSubstr("did you mean \"concepts\"?"));
  const CommandResult profile =
      runCommand({"train", "all", "--data", "d", "--model", "m", "--profile", "smok"});
  EXPECT_EQ(profile.exit_code, 2);
  EXPECT_THAT(profile.error, HasSubstr("did you mean \"smoke\"?"));
}

TEST_F(ModelCommands, InspectModelHasTheStableNames) {
  const CommandResult result = runCommand({"inspect", "model", model(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const json answer = json::parse(result.out);
  for (const char* key :
       {"name", "format", "concepts", "actions", "measures", "parameters", "bytes"}) {
    EXPECT_TRUE(answer.contains(key)) << key;
  }
  ASSERT_EQ(answer["concepts"].size(), 6u);
  EXPECT_EQ(answer["concepts"][0]["name"], "TYPE");
  EXPECT_EQ(answer["concepts"][0]["values"].size(), 8u);
  EXPECT_TRUE(answer["concepts"][0]["accuracy"].is_number());
  ASSERT_EQ(answer["actions"].size(), 7u);
  EXPECT_THAT(answer["actions"][6]["does"].get<std::string>(), HasSubstr("COLOR"));
  for (const char* measure : {"dci", "mig", "sap", "factor_vae", "beta_vae"}) {
    EXPECT_TRUE(answer["measures"][measure].is_number()) << measure;
  }
  EXPECT_EQ(answer["measures"]["split"], "validation");
  EXPECT_GT(answer["bytes"], 1000);
  EXPECT_THAT(runCommand({"inspect", "model", model()}).out, HasSubstr("change_color"));
}

TEST_F(ModelCommands, SolvesFromSymbolsAtAnyNumberOfJobs) {
  const auto one = root_ / "one.jsonl";
  const auto two = root_ / "two.jsonl";
  const CommandResult result =
      runCommand({"solve", scenarios(), "--jobs", "1", "--out", one.string()});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("level4-0003"));
  EXPECT_EQ(runCommand({"solve", scenarios(), "--jobs", "3", "--out", two.string()}).exit_code, 0);
  EXPECT_EQ(timeless(one), timeless(two));
  const std::vector<json> results = lines(one);
  ASSERT_EQ(results.size(), 6u);
  for (const json& solved : results) {
    EXPECT_EQ(solved["status"], "solved");
    EXPECT_EQ(solved["evaluation"]["top1"], true) << solved;
    EXPECT_EQ(solved["plans"].size(), 5u);
  }
  EXPECT_THAT(results[0]["scenario"].get<std::string>(), ::testing::EndsWith("level3-0001"));
}

TEST_F(ModelCommands, SeveralPlannersAndCsv) {
  const auto out = root_ / "results.csv";
  const CommandResult result =
      runCommand({"solve", scenarios() + "/level3-0001", "--planners", "bfs,belief", "--format",
                  "csv", "--out", out.string(), "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const json answer = json::parse(result.out);
  ASSERT_EQ(answer["results"].size(), 2u);
  EXPECT_EQ(answer["results"][0]["planner"], "bfs");
  EXPECT_EQ(answer["results"][1]["planner"], "belief");
  EXPECT_THAT(readFile(out), HasSubstr("level3-0001,bfs,0,solved,"));
}

TEST_F(ModelCommands, ResumeSolvesOnlyWhatIsMissing) {
  const auto whole = root_ / "whole.jsonl";
  const auto part = root_ / "part.jsonl";
  ASSERT_EQ(runCommand({"solve", scenarios(), "--out", whole.string()}).exit_code, 0);
  const std::string text = readFile(whole);
  writeFileAtomically(part, text.substr(0, text.find('\n') + 40));  // one result and a torn one
  EXPECT_EQ(runCommand({"solve", scenarios(), "--out", part.string(), "--resume"}).exit_code, 0);
  EXPECT_EQ(timeless(part), timeless(whole));
  EXPECT_EQ(lines(part)[0], lines(whole)[0]);
  EXPECT_NE(lines(part)[1]["times_ms"], lines(whole)[1]["times_ms"]);
}

TEST_F(ModelCommands, AnInterruptedSolveKeepsItsResults) {
  const std::string many = (root_ / "many").string();
  ASSERT_EQ(runCommand({"generate", "scenarios", "--level", "4", "--count", "40", "--symbols-only",
                        "--model", model(), "--out", many})
                .exit_code,
            0);
  const auto out = root_ / "interrupted.jsonl";
  const std::vector<std::string> solve{"solve",    many,    "--jobs",    "1",
                                       "--resume", "--out", out.string()};
  const CommandResult result = runInterrupted(
      solve, [&] { return std::filesystem::exists(out) && std::filesystem::file_size(out) > 0; });
  ASSERT_EQ(result.exit_code, 130) << result.error;
  const std::vector<json> kept = lines(out);
  EXPECT_THAT(kept, Not(IsEmpty()));
  EXPECT_LT(kept.size(), 40u);
  EXPECT_EQ(runCommand(solve).exit_code, 0);
  const std::vector<json> all = lines(out);
  ASSERT_EQ(all.size(), 40u);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(all[i], kept[i]);
}

TEST_F(ModelCommands, InfeasibleExits1AndInvalid2) {
  const std::string mixed = (root_ / "mixed").string();
  ASSERT_EQ(runCommand({"generate", "scenarios", "--infeasible", "--symbols-only", "--model",
                        model(), "--out", mixed})
                .exit_code,
            0);
  const CommandResult infeasible = runCommand({"solve", mixed, "--json"});
  EXPECT_EQ(infeasible.exit_code, 1) << infeasible.error;
  const json result = json::parse(infeasible.out)["results"][0];
  EXPECT_FALSE(result.contains("trace"));
  EXPECT_EQ(result["status"], "infeasible");
  EXPECT_TRUE(result["evaluation"].is_null());
  EXPECT_THAT(result["reason"].get<std::string>(), Not(IsEmpty()));

  std::filesystem::create_directories(root_ / "mixed/wrong");
  writeFileAtomically(root_ / "mixed/wrong/scenario.yaml", "conceptplan: 1\nnam: x\n");
  const CommandResult both = runCommand({"solve", mixed, "--json"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.error, HasSubstr("scenario.yaml:2:1: nam: unknown key; did you mean \"name\"?"));
  const json results = json::parse(both.out)["results"];
  EXPECT_EQ(results[0]["status"], "infeasible");
  EXPECT_EQ(results[1]["status"], "invalid_input");
}

TEST_F(ModelCommands, AWrongPlannerOfTheCommandIsNotBlamedOnTheScenario) {
  const CommandResult result =
      runCommand({"plan", scenarios() + "/level3-0001", "--planner", "beleif"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("--planner: planner.name: unknown planner \"beleif\""));
  EXPECT_THAT(result.error, ::testing::Not(HasSubstr("scenario.yaml")));
}

TEST_F(ModelCommands, WrongCallsOfSolveAreNamed) {
  const CommandResult planner =
      runCommand({"solve", scenarios(), "--planners", "beleif,bfs,astarr"});
  EXPECT_EQ(planner.exit_code, 2);
  EXPECT_THAT(planner.error, HasSubstr("unknown planner \"beleif\"; did you mean \"belief\"?"));
  EXPECT_THAT(planner.error, HasSubstr("unknown planner \"astarr\""));
  EXPECT_EQ(runCommand({"solve", scenarios(), "--resume"}).exit_code, 2);
  EXPECT_EQ(runCommand({"solve", (root_ / "nowhere").string()}).exit_code, 2);
  EXPECT_EQ(runCommand({"solve", scenarios(), "--out", "/proc/none/r.jsonl"}).exit_code, 2);
}

TEST_F(ModelCommands, PlanWritesResultAndReport) {
  const auto out = root_ / "planned";
  const std::string scenario = scenarios() + "/level4-0001";
  const CommandResult result = runCommand({"plan", scenario, "--out", out.string()});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("in the simulator the best plan reaches the goal"));
  const json written = json::parse(readFile(out / "result.json"));
  EXPECT_EQ(written["scenario"], scenario);
  EXPECT_EQ(written["planner"], "belief");
  EXPECT_THAT(readFile(out / "report.html"), HasSubstr("</html>"));
  EXPECT_EQ(runCommand({"plan", scenarios()}).exit_code, 2);
}

TEST_F(ModelCommands, PlanRefinesWhereTheScenarioAsksForIt) {
  const auto folder = root_ / "refined-scenario";
  std::filesystem::copy(scenarios() + "/level4-0001", folder);
  const std::string yaml = readFile(folder / "scenario.yaml");
  writeFileAtomically(folder / "scenario.yaml", yaml + "refine: {clearance_m: 0.01}\n");
  const auto out = root_ / "refined";
  const CommandResult result = runCommand({"plan", folder.string(), "--out", out.string()});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("mm clear"));
  const json refinement = json::parse(readFile(out / "result.json"))["refinement"];
  const json motion = json::parse(readFile(out / "trajectory.json"));
  EXPECT_EQ(motion["length_m"], refinement["length_m"]);
  EXPECT_EQ(motion["clearance_m"], refinement["clearance_m"]);
  EXPECT_THAT(readFile(out / "trajectory.csv"), HasSubstr("time_s,x_m,y_m,heading_rad,lift_m"));
  EXPECT_THAT(readFile(out / "report.html"), HasSubstr("class=\"motion"));
}

TEST_F(ModelCommands, PlanReadsPicturesAndPredictsFrames) {
  const std::string folder = (root_ / "pictures").string();
  ASSERT_EQ(
      runCommand({"generate", "scenarios", "--level", "1", "--model", model(), "--out", folder})
          .exit_code,
      0);
  const auto out = root_ / "planned-pictures";
  const CommandResult result = runCommand(
      {"plan", folder + "/level1-0001", "--planner", "bfs", "--out", out.string(), "--json"});
  EXPECT_LE(result.exit_code, 1) << result.error;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["planner"], "bfs");
  EXPECT_GT(answer["times_ms"]["perceive"], 0);
  std::size_t frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    frames += entry.path().extension() == ".png" ? 1 : 0;
  }
  EXPECT_EQ(frames, answer["plans"].empty() ? 0u : answer["plans"][0]["length"].get<std::size_t>());
}

TEST_F(ModelCommands, ExportedPddlIsSolvedByOthersAndTheirPlanChecked) {
  const std::string scenario = scenarios() + "/level4-0001";
  const std::string out = (root_ / "pddl").string();
  const CommandResult made = runCommand({"export", "pddl", scenario, "--out", out, "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.error;
  const json files = json::parse(made.out);
  const conceptplan::testing::PddlTask task(readFile(files["domain"].get<std::string>()),
                                            readFile(files["problem"].get<std::string>()));
  const auto solution = task.solve();
  ASSERT_TRUE(solution);
  std::string text;
  for (const std::string& step : solution->steps) text += step + "\n";
  const auto plan = folder_.write(
      "sas_plan", text + "; cost = " + std::to_string(solution->cost) + " (general cost)\n");
  const CommandResult right = runCommand({"validate", "--plan", plan.string(), scenario, "--json"});
  EXPECT_EQ(right.exit_code, 0) << right.error;
  const json answer = json::parse(right.out);
  EXPECT_EQ(answer["ok"], true);
  EXPECT_EQ(answer["cost"], solution->cost);
  EXPECT_EQ(answer["stated_cost"], solution->cost);
  EXPECT_EQ(answer["steps"], solution->steps.size());
  EXPECT_TRUE(answer["failure"].is_null());

  ASSERT_EQ(runCommand({"export", "ppddl", scenario, "--out", out}).exit_code, 0);
  const conceptplan::testing::PddlTask process(readFile(root_ / "pddl/domain.ppddl"),
                                               readFile(root_ / "pddl/problem.ppddl"));
  EXPECT_FALSE(process.steps(process.initial()).empty());
}

TEST_F(ModelCommands, ExportedPlansAreRightAndSpoiledOnesNamed) {
  const std::string scenario = scenarios() + "/level3-0002";
  const std::string out = (root_ / "plans").string();
  const CommandResult made =
      runCommand({"export", "plan", scenario, "--planner", "dijkstra", "--out", out, "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.error;
  const json plans = json::parse(made.out)["plans"];
  ASSERT_EQ(plans.size(), 5u);
  for (const json& plan : plans) {
    const CommandResult checked =
        runCommand({"validate", "--plan", plan["file"].get<std::string>(), scenario});
    EXPECT_EQ(checked.exit_code, 0) << checked.error;
    EXPECT_THAT(checked.out, HasSubstr("reaches the goal"));
    EXPECT_THAT(checked.out, HasSubstr("cost " + plan["cost"].dump()));
  }
  const std::string best = readFile(root_ / "plans/plan.1");
  const auto spoiled = folder_.write("spoiled", "; by hand\n" + best + best);
  const CommandResult fails = runCommand({"validate", "--plan", spoiled.string(), scenario});
  EXPECT_EQ(fails.exit_code, 2);  // the cost is stated twice
  EXPECT_THAT(fails.error, HasSubstr("the cost is stated twice"));
  const auto early = folder_.write("early", "(move_left color-0)\n");
  const CommandResult wrong = runCommand({"validate", "--plan", early.string(), scenario});
  EXPECT_EQ(wrong.exit_code, 1) << wrong.error;
  EXPECT_THAT(wrong.error, HasSubstr(early.string() + ":1: step 1, move_left: "));
  const auto empty = folder_.write("empty", "");
  EXPECT_THAT(runCommand({"validate", "--plan", empty.string(), scenario}).error,
              HasSubstr("the goal is not reached"));
  const auto broken = folder_.write("broken", "(mov_left)\nrotate\n");
  const CommandResult faults = runCommand({"validate", "--plan", broken.string(), scenario});
  EXPECT_EQ(faults.exit_code, 2);
  EXPECT_THAT(faults.error, HasSubstr(broken.string() + ":1:2: unknown action \"mov_left\""));
  EXPECT_THAT(faults.error, HasSubstr(broken.string() + ":2:1: expected (ACTION"));
  EXPECT_EQ(runCommand({"validate", "--plan", early.string(), scenario, scenario}).exit_code, 2);
  EXPECT_EQ(runCommand({"validate", scenario, "--model", model()}).exit_code, 2);
}

TEST_F(ModelCommands, OmplLogsComeFromSolveAndFromItsResults) {
  const auto log = root_ / "direct.log";
  const CommandResult direct = runCommand({"solve", scenarios(), "--planners", "belief,bfs",
                                           "--format", "ompl-log", "--out", log.string()});
  EXPECT_EQ(direct.exit_code, 0) << direct.error;
  EXPECT_THAT(readFile(log), HasSubstr("\nExperiment direct\n"));
  EXPECT_THAT(readFile(log), HasSubstr("\n2 planners\nbelief\n"));
  const auto results = root_ / "for-log.jsonl";
  ASSERT_EQ(runCommand({"solve", scenarios(), "--out", results.string()}).exit_code, 0);
  const auto exported = root_ / "exported.log";
  const CommandResult made =
      runCommand({"export", "ompl-log", results.string(), "--out", exported.string()});
  EXPECT_EQ(made.exit_code, 0) << made.error;
  EXPECT_THAT(readFile(exported), HasSubstr("\n1 planners\nbelief\n"));
  EXPECT_THAT(readFile(exported), HasSubstr("\n6 runs\n1; "));
  const auto nothing = folder_.write("nothing.jsonl", "");
  EXPECT_EQ(
      runCommand({"export", "ompl-log", nothing.string(), "--out", exported.string()}).exit_code,
      2);
  EXPECT_EQ(runCommand({"solve", scenarios(), "--format", "ompl-log"}).exit_code, 2);
}

TEST_F(ModelCommands, FastDownwardIsNamedWhereItIsMissing) {
  const CommandResult result =
      runCommand({"plan", scenarios() + "/level3-0001", "--planner", "fast-downward"});
  if (result.exit_code == 0) GTEST_SKIP() << "fast-downward is installed";
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("planner \"fast-downward\" needs the program fast-downward "
                                      "or fast-downward.py on the PATH"));
}

TEST_F(ModelCommands, EvaluateHasTheStableNames) {
  const std::string tasks = (root_ / "tasks").string();
  ASSERT_EQ(runCommand({"generate", "tasks", "--level", "1,2", "--count", "2", "--split", "test",
                        "--frames", "ends", "--out", tasks})
                .exit_code,
            0);
  const CommandResult result = runCommand(
      {"evaluate", "--tasks", tasks, "--model", model(), "--planners", "belief,bfs", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const json rows = json::parse(result.out)["rows"];
  ASSERT_EQ(rows.size(), 4u);
  for (const json& row : rows) {
    for (const char* key : {"learner", "planner", "set", "level", "tasks", "asacc_top1",
                            "asacc_top5", "ase", "fsd", "failures"}) {
      EXPECT_TRUE(row.contains(key)) << key;
    }
    EXPECT_EQ(row["tasks"], 2);
  }
  EXPECT_EQ(runCommand({"evaluate", "--tasks", tasks, "--planners", "bsf"}).exit_code, 2);
  EXPECT_EQ(runCommand({"evaluate", "--tasks", folder_.path().string()}).exit_code, 2);
}

TEST_F(ModelCommands, EvaluateConceptsHasTheStableNames) {
  const CommandResult result = runCommand(
      {"evaluate", "--concepts", data() + "/concepts-validation", "--model", model(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["set"], "validation/standard");
  ASSERT_EQ(answer["concepts"].size(), 6u);
  EXPECT_EQ(answer["concepts"][5]["name"], "SIZE");
  EXPECT_TRUE(answer["concepts"][5]["calibration_error"].is_number());
  EXPECT_LE(answer["all_right"], answer["concepts"][0]["accuracy"]);
  for (const char* measure : {"dci", "mig", "sap", "factor_vae", "beta_vae"}) {
    EXPECT_TRUE(answer["measures"][measure].is_number()) << measure;
  }
  EXPECT_EQ(runCommand({"evaluate", "--model", model()}).exit_code, 2);
  EXPECT_EQ(runCommand({"evaluate", "--concepts", "a", "--tasks", "b"}).exit_code, 2);
}

TEST_F(ModelCommands, InspectFiguresWritesTheFour) {
  const CommandResult result =
      runCommand({"inspect", "figures", model(), "--data", data() + "/concepts-validation", "--out",
                  (folder_ / "figures").string(), "--pictures", "60"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  for (const char* figure : {"substitution-grid", "token-changes", "displacements", "clusters"}) {
    EXPECT_THAT(readFile(folder_ / "figures" / (std::string(figure) + ".svg")),
                HasSubstr("</svg>"));
  }
}

TEST_F(ModelCommands, AFlippedByteInTheModelIsNamed) {
  const auto broken = folder_ / "model";
  std::filesystem::copy(model(), broken, std::filesystem::copy_options::recursive);
  std::string bytes = readFile(broken / kVictFile);
  bytes[bytes.size() / 2] ^= 1;
  writeFileAtomically(broken / kVictFile, bytes);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"plan", scenarios() + "/level3-0001", "--model", broken.string()},
        std::vector<std::string>{"inspect", "model", broken.string()}}) {
    const CommandResult result = runCommand(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.error, HasSubstr(kVictFile));
  }
}

TEST_F(ModelCommands, ValidateChecksTheModelAndItsSymbols) {
  EXPECT_EQ(runCommand({"validate", scenarios()}).exit_code, 0);
  const std::string text = readFile(root_ / "scenarios/level3-0001/scenario.yaml");
  folder_.write("reference.yaml", readFile(root_ / "scenarios/level3-0001/reference.yaml"));
  std::string no_model = text;
  no_model.replace(no_model.find(model()), model().size(), "absent-model");
  const auto path = folder_.write("scenario.yaml", no_model);
  const CommandResult result = runCommand({"validate", path.string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("scenario.yaml:3:1: model: "));
  std::string beyond = text;
  const std::size_t symbol = beyond.find("rotation: ") + 10;
  beyond.replace(symbol, 1, "7");
  folder_.write("scenario.yaml", beyond);
  const CommandResult symbols = runCommand({"validate", path.string()});
  EXPECT_EQ(symbols.exit_code, 2);
  EXPECT_THAT(symbols.error, HasSubstr("rotation: expected a symbol of the model, in [0, 4), found "
                                       "7"));
}

}  // namespace
}  // namespace conceptplan::cli
