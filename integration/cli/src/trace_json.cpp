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

Json rejectionJson(const Rejection& rejection, const Solution& solution) {
  const bool by_legality = rejection.cause == Invalidity::kNone;
  Json json{{"state", symbolsJson(rejection.state)},
            {"action", name(rejection.action)},
            {"cause", by_legality ? "legality" : name(rejection.cause)}};
  if (rejection.object) addObject(json, solution, *rejection.object);
  if (by_legality) {
    json["probability"] = rejection.value;
  } else if (rejection.cause != Invalidity::kCheckFailed) {
    json["depth_m"] = 0.0 - rejection.value;  // never -0
  }
  return json;
}

Json nearestJson(const Solution& solution) {
  const std::optional<Symbols>& nearest = solution.result.nearest;
  if (!nearest) return nullptr;
  const Symbols goal = mostProbable(solution.problem.goal);
  Json differs = Json::array();
  for (const Concept which : kConcepts) {
    if ((*nearest)[index(which)] != goal[index(which)]) differs.push_back(symbolKey(which));
  }
  return {{"symbols", symbolsJson(*nearest)}, {"differs_in", differs}};
}

}  // namespace

Json traceJson(const Solution& solution) {
  Json json{{"legality_threshold",
             solution.legality_threshold ? Json(*solution.legality_threshold) : Json()},
            {"rejections", Json::array()},
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
