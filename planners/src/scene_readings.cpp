#include "scene_readings.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace conceptplan {
namespace {

/// For each TYPE symbol that effects take symbols from, the concepts that they take.
using SourceTypes = std::map<SymbolId, std::set<Concept>>;

SourceTypes sourceTypes(const SymbolicModel& model) {
  SourceTypes sources;
  for (const Action action : kActions) {
    for (const Concept which : kConcepts) {
      for (const ContextFeature& feature : model.transitions.effect(action, which).context) {
        if (feature.kind == ContextKind::kNearestSymbol) {
          sources[feature.type].insert(feature.which);
        } else if (feature.kind == ContextKind::kNearestOffset) {
          sources[feature.type];
        }
      }
    }
  }
  return sources;
}

struct ObjectReading {
  Symbols symbols{};
  double probability = 0;
};

bool moreProbable(const ObjectReading& a, const ObjectReading& b) {
  return a.probability > b.probability;
}

/// Each reading with each symbol of the concept in turn.
std::vector<ObjectReading> branched(const std::vector<ObjectReading>& readings, Concept which,
                                    const std::vector<double>& belief) {
  std::vector<ObjectReading> branches;
  for (const ObjectReading& reading : readings) {
    for (std::size_t symbol = 0; symbol < belief.size(); ++symbol) {
      ObjectReading branch = reading;
      branch.symbols[index(which)] = static_cast<SymbolId>(symbol);
      branch.probability *= belief[symbol];
      if (branch.probability > 0) branches.push_back(branch);
    }
  }
  return branches;
}

/// All readings of one object that may matter, by falling probability.
std::vector<ObjectReading> objectReadings(const SymbolBelief& belief, const SourceTypes& sources) {
  const std::vector<double>& types = belief[index(Concept::kType)];
  std::vector<ObjectReading> readings;
  std::optional<std::size_t> plain;  // the most probable type that is no source
  double plain_probability = 0;
  for (std::size_t type = 0; type < types.size(); ++type) {
    const auto source = sources.find(static_cast<SymbolId>(type));
    if (source == sources.end()) {
      if (!plain || types[type] > types[*plain]) plain = type;
      plain_probability += types[type];
      continue;
    }
    std::vector<ObjectReading> of_type{{mostProbable(belief), types[type]}};
    of_type.front().symbols[index(Concept::kType)] = static_cast<SymbolId>(type);
    for (const Concept which : source->second) {
      of_type = branched(of_type, which, belief[index(which)]);
    }
    readings.insert(readings.end(), of_type.begin(), of_type.end());
  }
  if (plain) {
    readings.push_back({mostProbable(belief), plain_probability});
    readings.back().symbols[index(Concept::kType)] = static_cast<SymbolId>(*plain);
  }
  for (const Concept which : {Concept::kPositionX, Concept::kPositionY}) {
    readings = branched(readings, which, belief[index(which)]);
  }
  std::stable_sort(readings.begin(), readings.end(), moreProbable);
  return readings;
}

std::vector<Symbols> mostProbableOthers(const SymbolicScene& scene) {
  std::vector<Symbols> others;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (i != scene.target) others.push_back(mostProbable(scene.objects[i]));
  }
  return others;
}

}  // namespace

std::vector<SceneReading> probableReadings(const SymbolicModel& model, const SymbolicScene& scene,
                                           const CompileOptions& options) {
  const SourceTypes sources = sourceTypes(model);
  std::vector<SceneReading> scenes{{{}, 1}};
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (i == scene.target) continue;
    std::vector<SceneReading> longer;
    for (const ObjectReading& reading : objectReadings(scene.objects[i], sources)) {
      for (const SceneReading& before : scenes) {
        SceneReading after = before;
        after.others.push_back(reading.symbols);
        after.share *= reading.probability;
        longer.push_back(std::move(after));
      }
    }
    std::stable_sort(
        longer.begin(), longer.end(),
        [](const SceneReading& a, const SceneReading& b) { return a.share > b.share; });
    // What an object adds scales all scenes of this length alike, so shares compare within it.
    const double least = options.min_reading * longer.front().share;
    std::erase_if(longer, [&](const SceneReading& entry) { return entry.share < least; });
    scenes = std::move(longer);
  }

  const std::vector<Symbols> first = mostProbableOthers(scene);
  const auto same = std::find_if(scenes.begin(), scenes.end(),
                                 [&](const SceneReading& entry) { return entry.others == first; });
  if (same != scenes.end()) {
    std::rotate(scenes.begin(), same, same + 1);
  } else {
    scenes.insert(scenes.begin(), {first, options.min_reading * scenes.front().share});
  }
  if (scenes.size() > options.max_readings) scenes.resize(options.max_readings);
  double sum = 0;
  for (const SceneReading& entry : scenes) sum += entry.share;
  for (SceneReading& entry : scenes) entry.share /= sum;
  return scenes;
}

}  // namespace conceptplan
