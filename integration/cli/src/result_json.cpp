#include "result_json.hpp"

#include <algorithm>

#include "exit_code.hpp"
#include "trace_json.hpp"

namespace conceptplan::cli {
namespace {

Json planJson(const Plan& plan, const Solution& solution) {
  Json actions = Json::array();
  for (const Action action : plan.actions) actions.push_back(name(action));
  Json json{{"actions", actions},
            {"probability", plan.probability},
            {"cost", plan.cost},
            {"length", plan.actions.size()}};
  if (!solution.targets.empty()) {
    json["objects"] = Json::array();
    for (const std::size_t moved : plan.moved) json["objects"].push_back(solution.instances[moved]);
  }
  return json;
}

Json timesJson(const StageTimes& times) {
  return {{"perceive", times.perceive_ms}, {"compile", times.compile_ms},
          {"search", times.search_ms},     {"refine", times.refine_ms},
          {"render", times.render_ms},     {"total", times.total_ms}};
}

Json statisticsJson(const SearchStatistics& statistics) {
  return {{"expanded", statistics.expanded},
          {"generated", statistics.generated},
          {"validity_checks", statistics.validity_checks}};
}

Json evaluationJson(const std::optional<Evaluation>& evaluation) {
  if (!evaluation) return nullptr;
  const Judgement& best = evaluation->best;
  return {{"top1", best.succeeded()},
          {"top5", evaluation->top5},
          {"efficiency", best.efficiency ? Json(*best.efficiency) : Json()},
          {"final_distance", best.final_distance},
          {"failure", best.failure ? Json(name(*best.failure)) : Json()}};
}

Json refinementJson(const std::optional<RefinementResult>& refinement) {
  if (!refinement) return nullptr;
  return {{"length_m", refinement->length_m},
          {"clearance_m", refinement->clearance_m},
          {"fell_back", refinement->fell_back},
          {"reason", refinement->reason}};
}

Json makeResult(const ResultKey& key, const std::string& status, const std::string& reason) {
  return {{"scenario", key.scenario},
          {"planner", key.planner},
          {"seed", key.seed},
          {"status", status},
          {"reason", reason},
          {"plans", Json::array()},
          {"evaluation", nullptr},
          {"doubts", Json::array()},
          {"times_ms", timesJson({})},
          {"statistics", statisticsJson({})},
          {"refinement", nullptr},
          {"trace", nullptr},
          {"version", CONCEPTPLAN_VERSION}};
}

std::string bestActionsText(const Json& result) {
  return result["plans"].empty() ? "" : actionsText(result["plans"][0]);
}

/// A field for CSV: quoted where it holds a separator.
std::string csvField(const Json& value) {
  std::string text = value.is_null()     ? ""
                     : value.is_string() ? value.get<std::string>()
                                         : value.dump();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

Json fieldOf(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) ? object[key] : Json();
}

}  // namespace

std::string resultName(const std::filesystem::path& file) {
  const bool usual = file.filename() == "scenario.yaml" && file.has_parent_path();
  return (usual ? file.parent_path() : file).lexically_normal().string();
}

std::string actionsText(const Json& plan) {
  std::string text;
  for (std::size_t i = 0; i < plan["actions"].size(); ++i) {
    if (i > 0) text += " ";
    if (plan.contains("objects")) text += plan["objects"][i].dump() + ":";
    text += plan["actions"][i].get<std::string>();
  }
  return text;
}

Json resultJson(const ResultKey& key, const Solution& solution) {
  const PlanResult& result = solution.result;
  Json json = makeResult(key, std::string(name(result.status)), result.reason);
  for (const Plan& plan : result.plans) json["plans"].push_back(planJson(plan, solution));
  json["evaluation"] = evaluationJson(solution.evaluation);
  json["doubts"] = solution.doubts;
  json["times_ms"] = timesJson(solution.times);
  json["statistics"] = statisticsJson(result.statistics);
  json["refinement"] = refinementJson(solution.refinement);
  json["trace"] = traceJson(solution);
  return json;
}

Json invalidInputJson(const ResultKey& key, const InputError& error) {
  std::string reason;
  for (const Fault& fault : error.faults()) reason += (reason.empty() ? "" : "\n") + fault.text();
  return makeResult(key, "invalid_input", reason);
}

Json failedJson(const ResultKey& key, const std::string& reason) {
  return makeResult(key, "failed", reason);
}

std::string toCsv(const std::vector<Json>& results) {
  std::string text =
      "scenario,planner,seed,status,length,probability,cost,actions,top1,top5,efficiency,"
      "final_distance,failure,expanded,generated,validity_checks,total_ms\n";
  for (const Json& result : results) {
    const Json best = result["plans"].empty() ? Json() : result["plans"][0];
    const Json& evaluation = result["evaluation"];
    const Json& statistics = result["statistics"];
    const std::vector<Json> fields{result["scenario"],
                                   result["planner"],
                                   result["seed"],
                                   result["status"],
                                   fieldOf(best, "length"),
                                   fieldOf(best, "probability"),
                                   fieldOf(best, "cost"),
                                   bestActionsText(result),
                                   fieldOf(evaluation, "top1"),
                                   fieldOf(evaluation, "top5"),
                                   fieldOf(evaluation, "efficiency"),
                                   fieldOf(evaluation, "final_distance"),
                                   fieldOf(evaluation, "failure"),
                                   statistics["expanded"],
                                   statistics["generated"],
                                   statistics["validity_checks"],
                                   result["times_ms"]["total"]};
    for (std::size_t i = 0; i < fields.size(); ++i) text += (i ? "," : "") + csvField(fields[i]);
    text += "\n";
  }
  return text;
}

TextTable toTable(const std::vector<Json>& results) {
  TextTable table{
      {"scenario", "planner", "status", "length", "probability", "judged", "ms", "best plan"}};
  for (const Json& result : results) {
    const bool has_plan = !result["plans"].empty();
    const Json& evaluation = result["evaluation"];
    std::string judged = "-";
    if (evaluation.is_object()) {
      judged = evaluation["top1"].get<bool>() ? "right" : evaluation["failure"].get<std::string>();
    }
    table.push_back({std::filesystem::path(result["scenario"].get<std::string>()).filename(),
                     result["planner"], result["status"],
                     has_plan ? result["plans"][0]["length"].dump() : "-",
                     has_plan ? decimal(result["plans"][0]["probability"], 3) : "-", judged,
                     decimal(result["times_ms"]["total"], 0), bestActionsText(result)});
  }
  return table;
}

int exitCodeOf(const std::vector<Json>& results) {
  const auto any = [&results](const char* status) {
    return std::any_of(results.begin(), results.end(),
                       [status](const Json& result) { return result["status"] == status; });
  };
  if (any("failed")) return kInternalFailure;
  if (any("invalid_input")) return kWrongInput;
  const bool solved = std::all_of(results.begin(), results.end(),
                                  [](const Json& result) { return result["status"] == "solved"; });
  return solved ? kDone : kNoPlan;
}

}  // namespace conceptplan::cli
