#include <yaml-cpp/yaml.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "symbol_keys.hpp"

namespace conceptplan {
namespace {

void emitSymbols(YAML::Emitter& out, const GivenSymbols& given) {
  out << YAML::Flow << YAML::BeginMap;
  for (const Concept which : kConcepts) {
    out << YAML::Key << symbolKey(which) << YAML::Value;
    if (const auto* symbol = std::get_if<SymbolId>(&given[index(which)])) {
      out << static_cast<int>(*symbol);
    } else {
      out << YAML::Flow << std::get<std::vector<double>>(given[index(which)]);
    }
  }
  out << YAML::EndMap;
}

void emitPicture(YAML::Emitter& out, const std::string& stem) {
  const RgbdPaths paths = rgbdPaths(stem);
  out << YAML::Flow << YAML::BeginMap << YAML::Key << "rgb" << YAML::Value << paths.rgb.string()
      << YAML::Key << "depth" << YAML::Value << paths.depth.string() << YAML::Key << "mask"
      << YAML::Value << paths.mask.string() << YAML::EndMap;
}

void emitInput(YAML::Emitter& out, const Scenario& scenario) {
  if (const auto* symbols = std::get_if<SymbolInput>(&scenario.input)) {
    out << YAML::Key << "initial" << YAML::Value << YAML::BeginMap << YAML::Key << "symbols"
        << YAML::Value << YAML::BeginMap << YAML::Key << "objects" << YAML::Value << YAML::BeginSeq;
    for (const GivenSymbols& object : symbols->objects) emitSymbols(out, object);
    out << YAML::EndSeq << YAML::EndMap << YAML::EndMap;
    out << YAML::Key << "goal" << YAML::Value << YAML::BeginMap << YAML::Key << "symbols"
        << YAML::Value;
    if (scenario.targets.empty()) {
      emitSymbols(out, symbols->goal);
    } else {
      out << YAML::BeginSeq;
      for (const GivenSymbols& goal : symbols->goals) emitSymbols(out, goal);
      out << YAML::EndSeq;
    }
    out << YAML::EndMap;
    return;
  }
  out << YAML::Key << "initial" << YAML::Value;
  emitPicture(out, "initial");
  out << YAML::Key << "goal" << YAML::Value;
  emitPicture(out, "goal");
}

void emitPlanner(YAML::Emitter& out, const PlannerChoice& planner) {
  out << YAML::Key << "planner" << YAML::Value << YAML::Flow << YAML::BeginMap << YAML::Key
      << "name" << YAML::Value << planner.name;
  if (!planner.options.empty()) {
    out << YAML::Key << "options" << YAML::Value << YAML::Flow << planner.options;
  }
  out << YAML::Key << "top" << YAML::Value << planner.top << YAML::EndMap;
}

void emitRefinement(YAML::Emitter& out, const RefinementChoice& refine) {
  out << YAML::Key << "refine" << YAML::Value << YAML::Flow << YAML::BeginMap << YAML::Key
      << "clearance_m" << YAML::Value << refine.clearance_m;
  if (refine.algorithm) out << YAML::Key << "algorithm" << YAML::Value << *refine.algorithm;
  if (refine.max_evaluations) {
    out << YAML::Key << "max_evaluations" << YAML::Value << *refine.max_evaluations;
  }
  out << YAML::EndMap;
}

std::string scenarioText(const Scenario& scenario, bool has_reference) {
  YAML::Emitter out;
  out.SetDoublePrecision(12);
  out << YAML::BeginMap << YAML::Key << "conceptplan" << YAML::Value << 1;
  out << YAML::Key << "name" << YAML::Value << scenario.name;
  out << YAML::Key << "model" << YAML::Value << scenario.model;
  emitInput(out, scenario);
  if (scenario.target) {
    out << YAML::Key << "target" << YAML::Value << static_cast<int>(*scenario.target);
  }
  if (!scenario.targets.empty()) {
    const std::vector<int> targets(scenario.targets.begin(), scenario.targets.end());
    out << YAML::Key << "targets" << YAML::Value << YAML::Flow << targets;
  }
  emitPlanner(out, scenario.planner);
  if (scenario.refine) emitRefinement(out, *scenario.refine);
  out << YAML::Key << "render" << YAML::Value << scenario.render;
  if (has_reference) out << YAML::Key << "reference" << YAML::Value << "reference.yaml";
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace

void writeScenario(const std::filesystem::path& folder, const Scenario& scenario,
                   const std::optional<Reference>& reference) {
  createFolder(folder);
  if (const auto* pictures = std::get_if<PictureInput>(&scenario.input)) {
    writeRgbdImage(folder / "initial", pictures->initial);
    writeRgbdImage(folder / "goal", pictures->goal);
  }
  if (reference) writeReference(folder / "reference.yaml", *reference);
  writeFileAtomically(folder / "scenario.yaml", scenarioText(scenario, reference.has_value()));
}

}  // namespace conceptplan
