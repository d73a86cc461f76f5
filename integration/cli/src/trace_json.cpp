#include "trace_json.hpp"

#include "conceptplan/domain/symbol_key.hpp"

namespace conceptplan::cli {
namespace {

Json symbolsJson(const Symbols& symbols) {
  Json json = Json::object();
  for (const Concept which : kConcepts) json[symbolKey(which)] = index(symbols[index(which)]);
  return json;
}

void addObject(Json& json, const Solution& solution, std::size_t object) {
  json["object"] = solution.instances[object];
  json["name"] = solution.names[object];
}

std::string_view causeName(Invalidity cause) {
  return cause == Invalidity::kNone ? "legality" : name(cause);
}

double depth(double clearance_m) { return 0.0 - clearance_m; }  // never -0

Json rejectionJson(const Rejection& rejection, const Solution& solution) {
  const bool by_legality = rejection.cause == Invalidity::kNone;
  Json json{{"state", symbolsJson(rejection.state)},
            {"action", name(rejection.action)},
            {"cause", causeName(rejection.cause)}};
  if (rejection.moved) {
    json["moved"] = solution.instances[*rejection.moved];
    json["moved_name"] = solution.names[*rejection.moved];
  }
  if (rejection.object) addObject(json, solution, *rejection.object);
  if (by_legality) {
    json["probability"] = rejection.value;
  } else if (rejection.cause != Invalidity::kCheckFailed) {
    json["depth_m"] = depth(rejection.value);
  }
  return json;
}

/// Over the whole search; null where that is not known.
Json expansionsJson(const Solution& solution) {
  if (!solution.result.ruled_out) return nullptr;
  Json json{{"states", solution.result.ruled_out->states}, {"ruled_out", Json::array()}};
  for (const RejectionCount& count : solution.result.ruled_out->counts) {
    Json entry{{"cause", causeName(count.cause)}};
    if (count.object) addObject(entry, solution, *count.object);
    entry["steps"] = count.steps;
    if (count.cause == Invalidity::kNone) {
      entry["probability"] = {count.least, count.greatest};
    } else if (count.cause != Invalidity::kCheckFailed) {
      entry["depth_m"] = {depth(count.greatest), depth(count.least)};
    }
    json["ruled_out"].push_back(entry);
  }
  return json;
}

void addNearest(Json& json, const Symbols& nearest, const SymbolBelief& goal_belief) {
  const Symbols goal = mostProbable(goal_belief);
  Json differs = Json::array();
  for (const Concept which : kConcepts) {
    if (nearest[index(which)] != goal[index(which)]) differs.push_back(symbolKey(which));
  }
  json["symbols"] = symbolsJson(nearest);
  json["differs_in"] = differs;
}

/// Of the target, or a list of all of several.
Json nearestJson(const Solution& solution) {
  const std::vector<Symbols>& nearest = solution.result.nearest;
  if (nearest.empty()) return nullptr;
  if (solution.targets.empty()) {
    Json json = Json::object();
    addNearest(json, nearest.front(), solution.problem.goal);
    return json;
  }
  Json list = Json::array();
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    Json& json = list.emplace_back(Json::object());
    addObject(json, solution, solution.targets[i].object);
    addNearest(json, nearest[i], solution.targets[i].goal);
  }
  return list;
}

}  // namespace

Json traceJson(const Solution& solution) {
  Json json{{"legality_threshold",
             solution.legality_threshold ? Json(*solution.legality_threshold) : Json()},
            {"rejections", Json::array()},
            {"expansions", expansionsJson(solution)},
            {"blocking", Json::array()},
            {"nearest", nearestJson(solution)}};
  for (const Rejection& rejection : solution.result.rejections) {
    json["rejections"].push_back(rejectionJson(rejection, solution));
  }
  for (const std::size_t object : solution.result.blocking) {
    addObject(json["blocking"].emplace_back(Json::object()), solution, object);
  }
  return json;
}

}  // namespace conceptplan::cli
