#include "commands.hpp"
#include "conceptplan/pipeline/all_planners.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

int listPlanners(Session& session) {
  const PlannerRegistry registry = allPlanners();
  session.console.printJson(Json::parse(toJson(registry)));
  for (const PlannerEntry& entry : registry.entries()) {
    session.console.print(entry.name + "  " + entry.summary);
    session.console.print("  source: " + entry.source);
    for (const std::string& guarantee : entry.guarantees) {
      session.console.print("  guarantee: " + guarantee);
    }
    TextTable options;
    for (const PlannerOption& option : entry.options) {
      options.push_back({"  " + option.name, option.typeName(), option.range(),
                         "default " + option.standard, option.summary});
    }
    session.console.print(options);
  }
  return kDone;
}

}  // namespace

void addPlannersCommand(CommandLine& line) {
  line.add("planners", "List the planners, what each guarantees and its options",
           "conceptplan planners", listPlanners);
}

}  // namespace conceptplan::cli
