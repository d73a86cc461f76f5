#include "result_json.hpp"

#include <gmock/gmock.h>

namespace conceptplan::cli {
namespace {

using testing::HasSubstr;

const ResultKey kKey{"scenarios/level3-0001", "belief", 3};

Solution solved(std::vector<ActionSequence> plans) {
  Solution solution;
  solution.result.status = PlanStatus::kSolved;
  for (ActionSequence& actions : plans) {
    Plan plan;
    plan.probability = 0.5;
    plan.cost = 0.25;
    plan.actions = std::move(actions);
    solution.result.plans.push_back(plan);
  }
  solution.result.statistics = {10, 20, 30};
  return solution;
}

Solution judged(std::optional<Failure> failure) {
  Solution solution = solved({{Action::kMoveBack, Action::kChangeColor}});
  solution.evaluation = Evaluation{{failure, {}, 1.5}, true};
  if (!failure) solution.evaluation->best.efficiency = 0.75;
  return solution;
}

Solution infeasible() {
  Solution solution;
  solution.result.status = PlanStatus::kInfeasible;
  solution.result.reason = "shut in";
  return solution;
}

TEST(ResultJson, ScenariosAreNamedByTheirFolder) {
  EXPECT_EQ(resultName("scenarios//level3-0001/scenario.yaml"), "scenarios/level3-0001");
  EXPECT_EQ(resultName("mine/other.yaml"), "mine/other.yaml");
  EXPECT_EQ(resultName("scenario.yaml"), "scenario.yaml");
}

TEST(ResultJson, HasTheStableNamesInOrder) {
  const Json json = resultJson(kKey, solved({{Action::kMoveFront}}));
  std::string names;
  for (const auto& [name, value] : json.items()) names += name + " ";
  EXPECT_EQ(
      names,
      "scenario planner seed status reason plans evaluation doubts times_ms statistics refinement "
      "trace version ");
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["plans"][0].dump(),
            R"({"actions":["move_front"],"probability":0.5,"cost":0.25,"length":1})");
  EXPECT_EQ(json["statistics"].dump(), R"({"expanded":10,"generated":20,"validity_checks":30})");
  EXPECT_TRUE(json["evaluation"].is_null());
  EXPECT_TRUE(json["refinement"].is_null());
  for (const char* part : {"perceive", "compile", "search", "refine", "render", "total"}) {
    EXPECT_TRUE(json["times_ms"].contains(part));
  }
}

TEST(ResultJson, RefinementTellsItsMeasures) {
  Solution solution = solved({{Action::kMoveFront}});
  Trajectory::ControlPoints points = Trajectory::ControlPoints::Zero(4, 3);
  solution.refinement = RefinementResult{Trajectory(points, 1), 0.5, 0.25, true, "shut in"};
  solution.times.refine_ms = 2;
  const Json json = resultJson(kKey, solution);
  EXPECT_EQ(json["refinement"].dump(),
            R"({"length_m":0.5,"clearance_m":0.25,"fell_back":true,"reason":"shut in"})");
  EXPECT_EQ(json["times_ms"]["refine"], 2);
}

TEST(ResultJson, TraceTellsWhatRuledStepsOut) {
  Solution solution = infeasible();
  solution.instances = {4, 7};
  solution.names = {"Cup 4", "object 7"};
  solution.legality_threshold = 0.02;
  const Symbols state{SymbolId{1}, SymbolId{2}, SymbolId{3}, SymbolId{0}, SymbolId{5}, SymbolId{2}};
  solution.result.rejections = {
      {state, Action::kMoveLeft, Invalidity::kNone, std::nullopt, 0.25},
      {state, Action::kMoveFront, Invalidity::kCollision, 1, -0.125},
      {state, Action::kMoveRight, Invalidity::kWorkbenchEdge, std::nullopt, 0},
      {state, Action::kMoveBack, Invalidity::kCheckFailed, std::nullopt, 0}};
  solution.result.blocking = {1};
  solution.result.nearest = {state};
  solution.problem.goal = certain(state, kConceptCardinality);
  std::swap(solution.problem.goal[index(Concept::kColor)][5],
            solution.problem.goal[index(Concept::kColor)][0]);
  const std::string symbols =
      R"({"type":1,"position_x":2,"position_y":3,"rotation":0,"color":5,"size":2})";
  const Json trace = resultJson(kKey, solution)["trace"];
  EXPECT_EQ(trace["legality_threshold"], 0.02);
  EXPECT_EQ(trace["rejections"].dump(),
            R"([{"state":)" + symbols +
                R"(,"action":"move_left","cause":"legality","probability":0.25},{"state":)" +
                symbols + R"(,"action":"move_front","cause":"collision","object":7,)" +
                R"("name":"object 7","depth_m":0.125},{"state":)" + symbols +
                R"(,"action":"move_right","cause":"workbench_edge","depth_m":0.0},{"state":)" +
                symbols + R"(,"action":"move_back","cause":"check_failed"}])");
  EXPECT_EQ(trace["blocking"].dump(), R"([{"object":7,"name":"object 7"}])");
  EXPECT_EQ(trace["nearest"].dump(), R"({"symbols":)" + symbols + R"(,"differs_in":["color"]})");
  EXPECT_TRUE(trace["expansions"].is_null());
  EXPECT_TRUE(failedJson(kKey, "bug")["trace"].is_null());

  solution.result.ruled_out = RejectionTally{
      3,
      {{Invalidity::kNone, std::nullopt, 4, 0.25, 0.5}, {Invalidity::kCollision, 1, 2, -0.5, 0}}};
  EXPECT_EQ(
      resultJson(kKey, solution)["trace"]["expansions"].dump(),
      R"({"states":3,"ruled_out":[{"cause":"legality","steps":4,"probability":[0.25,0.5]},)"
      R"({"cause":"collision","object":7,"name":"object 7","steps":2,"depth_m":[0.0,0.5]}]})");
}

TEST(ResultJson, TraceTellsOfEachOfSeveralTargets) {
  Solution solution = infeasible();
  solution.instances = {4, 7};
  solution.names = {"Cup 4", "Pot 7"};
  const Symbols state{};
  Symbols goal = state;
  goal[index(Concept::kSize)] = SymbolId{1};
  solution.targets = {{1, certain(goal, kConceptCardinality)},
                      {0, certain(state, kConceptCardinality)}};
  solution.result.nearest = {state, state};
  solution.result.rejections = {{state, Action::kMoveLeft, Invalidity::kCollision, 0, -0.125, 1}};
  const Json trace = resultJson(kKey, solution)["trace"];
  EXPECT_EQ(trace["rejections"][0]["moved"], 7);
  EXPECT_EQ(trace["rejections"][0]["moved_name"], "Pot 7");
  EXPECT_EQ(trace["rejections"][0]["name"], "Cup 4");
  ASSERT_EQ(trace["nearest"].size(), 2u);
  EXPECT_EQ(trace["nearest"][0]["object"], 7);
  EXPECT_EQ(trace["nearest"][0]["differs_in"].dump(), R"(["size"])");
  EXPECT_EQ(trace["nearest"][1]["name"], "Cup 4");
  EXPECT_TRUE(trace["nearest"][1]["differs_in"].empty());
}

TEST(ResultJson, EvaluationTellsSuccessOrItsCause) {
  const Json wrong = resultJson(kKey, judged(Failure::kOffWorkbench))["evaluation"];
  EXPECT_EQ(wrong.dump(), R"({"top1":false,"top5":true,"efficiency":null,"final_distance":1.5,)"
                          R"("failure":"off_workbench"})");
  const Json right = resultJson(kKey, judged(std::nullopt))["evaluation"];
  EXPECT_EQ(right["top1"], true);
  EXPECT_EQ(right["efficiency"], 0.75);
  EXPECT_TRUE(right["failure"].is_null());
}

TEST(ResultJson, ExitCodesFollowTheWorstResult) {
  const Json good = resultJson(kKey, solved({{}}));
  const Json none = resultJson(kKey, infeasible());
  EXPECT_EQ(none["status"], "infeasible");
  EXPECT_EQ(none["reason"], "shut in");
  const Json invalid = invalidInputJson(kKey, InputError({Fault{"a.yaml", 3, 1, "k", "bad"}}));
  EXPECT_EQ(invalid["reason"], "a.yaml:3:1: k: bad");
  EXPECT_EQ(exitCodeOf({good}), 0);
  EXPECT_EQ(exitCodeOf({good, none}), 1);
  EXPECT_EQ(exitCodeOf({none, invalid, good}), 2);
  EXPECT_EQ(exitCodeOf({invalid, failedJson(kKey, "bug")}), 3);
}

TEST(ResultJson, CsvQuotesWhatNeedsIt) {
  const ResultKey odd{"a,\"b\"", "belief", 0};
  const std::string csv =
      toCsv({resultJson(odd, solved({{Action::kMoveFront, Action::kChangeColor}})),
             failedJson(kKey, "bug")});
  EXPECT_THAT(csv, testing::StartsWith("scenario,planner,seed,status,length,"));
  EXPECT_THAT(csv,
              HasSubstr("\"a,\"\"b\"\"\",belief,0,solved,2,0.5,0.25,move_front change_color,,"));
  EXPECT_THAT(csv, HasSubstr("scenarios/level3-0001,belief,3,failed,,,,,"));
}

TEST(ResultJson, TableNamesTheScenarioAndTheVerdict) {
  const TextTable table =
      toTable({resultJson(kKey, judged(std::nullopt)), resultJson(kKey, judged(Failure::kNoDyer)),
               resultJson(kKey, infeasible())});
  EXPECT_EQ(table[1][0], "level3-0001");
  EXPECT_EQ(table[1][5], "right");
  EXPECT_EQ(table[1][7], "move_back change_color");
  EXPECT_EQ(table[2][5], "no_dyer");
  EXPECT_EQ(table[3][2], "infeasible");
  EXPECT_EQ(table[3][5], "-");
}

TEST(ResultJson, PlansOfSeveralTargetsSayWhatEachActionMoves) {
  Solution solution = solved({{Action::kMoveFront, Action::kMoveLeft}});
  solution.targets.resize(2);
  solution.instances = {4, 7, 9};
  solution.result.plans[0].moved = {2, 0};
  const Json json = resultJson(kKey, solution);
  EXPECT_EQ(json["plans"][0]["objects"].dump(), "[9,4]");
  EXPECT_EQ(actionsText(json["plans"][0]), "9:move_front 4:move_left");
  EXPECT_THAT(toCsv({json}), HasSubstr("9:move_front 4:move_left"));
}

}  // namespace
}  // namespace conceptplan::cli
