#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/json_depth.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"

namespace conceptplan {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "conceptplan symbolic model";

constexpr std::array<std::string_view, 3> kKindNames{"own_symbol", "nearest_symbol",
                                                     "nearest_offset"};

Json featureJson(const ContextFeature& feature) {
  Json json{{"kind", kKindNames[static_cast<std::size_t>(feature.kind)]}};
  if (feature.kind != ContextKind::kNearestOffset) json["concept"] = name(feature.which);
  if (feature.kind != ContextKind::kOwnSymbol) json["type"] = index(feature.type);
  return json;
}

Json contextJson(const std::vector<ContextFeature>& context) {
  Json json = Json::array();
  for (const ContextFeature& feature : context) json.push_back(featureJson(feature));
  return json;
}

Json rowsJson(const std::map<std::size_t, std::vector<double>>& rows) {
  Json json = Json::array();
  for (const auto& [value, row] : rows) json.push_back({{"value", value}, {"row", row}});
  return json;
}

Json countsJson(const ContextCounts& counts) {
  return {{"context", contextJson(counts.context)}, {"rows", rowsJson(counts.rows)}};
}

Json groundingJson(const SymbolGrounding& grounding) {
  Json footprints = Json::array();
  for (const auto& type : grounding.footprints) {
    Json& of_type = footprints.emplace_back(Json::array());
    for (const auto& size : type) {
      Json& of_size = of_type.emplace_back(Json::array());
      for (const Footprint& footprint : size) {
        of_size.push_back(
            {{"support_m", footprint.outline.support_m}, {"height_m", footprint.height_m}});
      }
    }
  }
  Json names = Json::object();
  for (const Concept which : kConcepts) {
    names[std::string(name(which))] = grounding.names[index(which)];
  }
  return {{"columns", grounding.columns},
          {"rows", grounding.rows},
          {"footprints", footprints},
          {"names", names}};
}

Json actionJson(const SymbolicModel& model, Action action) {
  Json effects = Json::object();
  for (const Concept which : kConcepts) {
    const Effect& effect = model.transitions.effect(action, which);
    effects[std::string(name(which))] = {
        {"context", contextJson(effect.context)},
        {"stays", effect.stays},
        {"probabilities", rowsJson(effect.rows)},
        {"counts", countsJson(model.evidence.transitions[index(action)][index(which)])}};
  }
  Json factors = Json::array();
  for (const LegalityFactor& factor : model.legality.factors(action)) {
    factors.push_back({{"context", featureJson(factor.context)}, {"share", factor.share}});
  }
  Json counts = Json::array();
  for (const ContextCounts& table : model.evidence.legality[index(action)]) {
    counts.push_back(countsJson(table));
  }
  return {{"steps", model.evidence.steps[index(action)]},
          {"effects", effects},
          {"legality", factors},
          {"legality_counts", counts}};
}

/// Reads values out of a JSON document and collects what is wrong with them. Every reader returns
/// some value of its type, so that reading goes on after a fault.
class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  void fault(const std::string& key, const std::string& message) {
    faults_.push_back({path_, {}, {}, key, message});
  }

  /// @throws InputError if there is any fault.
  void finish() const {
    if (!faults_.empty()) throw InputError(faults_);
  }

  const Json& member(const Json& parent, const std::string& key, const std::string& child) {
    static const Json kAbsent;
    if (!expect(parent, parent.is_object(), key, "an object")) return kAbsent;
    const auto found = parent.find(child);
    if (found != parent.end()) return *found;
    fault(joinedKey(key, child), "missing");
    return kAbsent;
  }

  double number(const Json& json, const std::string& key, double least) {
    if (!expect(json, json.is_number(), key, "a number")) return least;
    const auto value = json.get<double>();
    if (value < least) {
      fault(key, "expected a number >= " + std::to_string(least) + ", found " + json.dump());
    }
    return value;
  }

  std::size_t whole(const Json& json, const std::string& key) {
    if (!expect(json, json.is_number_unsigned(), key, "a whole number >= 0")) return 0;
    return json.get<std::size_t>();
  }

  int smallWhole(const Json& json, const std::string& key) {
    const std::size_t value = whole(json, key);
    if (value > 1'000'000) fault(key, "expected at most 1000000, found " + std::to_string(value));
    return static_cast<int>(std::min<std::size_t>(value, 1'000'000));
  }

  std::string text(const Json& json, const std::string& key) {
    return expect(json, json.is_string(), key, "a text") ? json.get<std::string>() : "";
  }

  template <typename Element>
  auto list(const Json& json, const std::string& key, const Element& element) {
    std::vector<decltype(element(json, key))> values;
    if (!expect(json, json.is_array(), key, "a list")) return values;
    std::size_t i = 0;
    for (const Json& entry : json) {
      values.push_back(element(entry, key + "[" + std::to_string(i++) + "]"));
    }
    return values;
  }

  std::vector<double> numbers(const Json& json, const std::string& key) {
    return list(json, key, [this](const Json& entry, const std::string& entry_key) {
      return number(entry, entry_key, 0);
    });
  }

  static std::string joinedKey(const std::string& key, const std::string& child) {
    return key.empty() ? child : key + "." + child;
  }

 private:
  bool expect(const Json& json, bool fits, const std::string& key, const char* expected) {
    // A missing member is null here and has been told of already.
    if (!fits && !json.is_null()) {
      fault(key, std::string("expected ") + expected + ", found " + json.type_name());
    }
    return fits;
  }

  std::string path_;
  std::vector<Fault> faults_;
};

ContextFeature readFeature(Reader& reader, const Json& json, const std::string& key,
                           const ConceptCardinality& cardinality) {
  ContextFeature feature;
  const std::string kind = reader.text(reader.member(json, key, "kind"), key + ".kind");
  const auto known = std::find(kKindNames.begin(), kKindNames.end(), kind);
  if (known == kKindNames.end()) {
    reader.fault(key + ".kind",
                 "expected own_symbol, nearest_symbol or nearest_offset, found \"" + kind + "\"");
    return feature;
  }
  feature.kind = static_cast<ContextKind>(known - kKindNames.begin());
  if (feature.kind != ContextKind::kNearestOffset) {
    const std::string which = reader.text(reader.member(json, key, "concept"), key + ".concept");
    if (const auto named = conceptNamed(which)) {
      feature.which = *named;
    } else {
      reader.fault(key + ".concept", "no such concept: \"" + which + "\"");
    }
  }
  if (feature.kind != ContextKind::kOwnSymbol) {
    const std::size_t type = reader.whole(reader.member(json, key, "type"), key + ".type");
    if (type >= cardinality[index(Concept::kType)]) {
      reader.fault(key + ".type", "expected a TYPE symbol below " +
                                      std::to_string(cardinality[index(Concept::kType)]) +
                                      ", found " + std::to_string(type));
    }
    feature.type = static_cast<SymbolId>(type);
  }
  return feature;
}

std::vector<ContextFeature> readContext(Reader& reader, const Json& json, const std::string& key,
                                        const ConceptCardinality& cardinality) {
  return reader.list(json, key, [&](const Json& entry, const std::string& entry_key) {
    return readFeature(reader, entry, entry_key, cardinality);
  });
}

std::map<std::size_t, std::vector<double>> readRows(Reader& reader, const Json& json,
                                                    const std::string& key) {
  std::map<std::size_t, std::vector<double>> rows;
  reader.list(json, key, [&](const Json& entry, const std::string& entry_key) {
    const std::size_t value =
        reader.whole(reader.member(entry, entry_key, "value"), entry_key + ".value");
    rows[value] = reader.numbers(reader.member(entry, entry_key, "row"), entry_key + ".row");
    return value;
  });
  return rows;
}

ContextCounts readCounts(Reader& reader, const Json& json, const std::string& key,
                         const ConceptCardinality& cardinality) {
  return {readContext(reader, reader.member(json, key, "context"), key + ".context", cardinality),
          readRows(reader, reader.member(json, key, "rows"), key + ".rows")};
}

Footprint readFootprint(Reader& reader, const Json& json, const std::string& key) {
  Footprint footprint;
  const std::string support_key = key + ".support_m";
  const std::vector<double> support_m =
      reader.numbers(reader.member(json, key, "support_m"), support_key);
  if (support_m.size() == Outline::kDirections) {
    std::copy(support_m.begin(), support_m.end(), footprint.outline.support_m.begin());
  } else {
    reader.fault(support_key, "expected " + std::to_string(Outline::kDirections) +
                                  " numbers, found " + std::to_string(support_m.size()));
  }
  footprint.height_m = reader.number(reader.member(json, key, "height_m"), key + ".height_m", 0);
  return footprint;
}

SymbolGrounding readGrounding(Reader& reader, const Json& json,
                              const ConceptCardinality& cardinality) {
  const std::string key = "grounding";
  const auto cell = [&](const Json& entry, const std::string& entry_key) {
    return reader.smallWhole(entry, entry_key);
  };
  SymbolGrounding grounding;
  grounding.columns = reader.list(reader.member(json, key, "columns"), key + ".columns", cell);
  grounding.rows = reader.list(reader.member(json, key, "rows"), key + ".rows", cell);
  grounding.footprints = reader.list(
      reader.member(json, key, "footprints"), key + ".footprints",
      [&](const Json& type, const std::string& type_key) {
        return reader.list(type, type_key, [&](const Json& size, const std::string& size_key) {
          return reader.list(size, size_key, [&](const Json& entry, const std::string& entry_key) {
            return readFootprint(reader, entry, entry_key);
          });
        });
      });
  const Json& names = reader.member(json, key, "names");
  for (const Concept which : kConcepts) {
    const std::string child(name(which));
    grounding.names[index(which)] =
        reader.list(reader.member(names, key + ".names", child), key + ".names." + child,
                    [&](const Json& entry, const std::string& entry_key) {
                      return reader.text(entry, entry_key);
                    });
  }
  for (const std::string& fault : grounding.faults(cardinality)) reader.fault(key, fault);
  return grounding;
}

void readEffects(Reader& reader, const Json& json, const std::string& key, Action action,
                 const ConceptCardinality& cardinality, EffectTable& effects,
                 ModelEvidence& evidence) {
  for (const Concept which : kConcepts) {
    const std::string child(name(which));
    const std::string place = key + "." + child;
    const Json& entry = reader.member(json, key, child);
    Effect& effect = effects[index(action)][index(which)];
    effect.context = readContext(reader, reader.member(entry, place, "context"), place + ".context",
                                 cardinality);
    effect.stays = reader.number(reader.member(entry, place, "stays"), place + ".stays", 0);
    effect.rows =
        readRows(reader, reader.member(entry, place, "probabilities"), place + ".probabilities");
    evidence.transitions[index(action)][index(which)] =
        readCounts(reader, reader.member(entry, place, "counts"), place + ".counts", cardinality);
  }
}

void readAction(Reader& reader, const Json& json, Action action,
                const ConceptCardinality& cardinality, EffectTable& effects,
                LegalityTable& legality, ModelEvidence& evidence) {
  const std::string key = "actions." + std::string(name(action));
  evidence.steps[index(action)] =
      reader.number(reader.member(json, key, "steps"), key + ".steps", 0);
  readEffects(reader, reader.member(json, key, "effects"), key + ".effects", action, cardinality,
              effects, evidence);
  legality[index(action)] =
      reader.list(reader.member(json, key, "legality"), key + ".legality",
                  [&](const Json& entry, const std::string& place) {
                    return LegalityFactor{
                        readFeature(reader, reader.member(entry, place, "context"),
                                    place + ".context", cardinality),
                        reader.numbers(reader.member(entry, place, "share"), place + ".share")};
                  });
  evidence.legality[index(action)] =
      reader.list(reader.member(json, key, "legality_counts"), key + ".legality_counts",
                  [&](const Json& entry, const std::string& place) {
                    return readCounts(reader, entry, place, cardinality);
                  });
}

ConceptCardinality readCardinality(Reader& reader, const Json& document) {
  const Json& json = reader.member(document, "", "cardinality");
  ConceptCardinality cardinality{};
  for (const Concept which : kConcepts) {
    const std::string child(name(which));
    const std::string key = "cardinality." + child;
    cardinality[index(which)] = reader.whole(reader.member(json, "cardinality", child), key);
    if (cardinality[index(which)] == 0 || cardinality[index(which)] > 1000) {
      reader.fault(key, "expected a number in [1, 1000]");
    }
  }
  return cardinality;
}

Json parsed(std::string_view text, const std::string& path) {
  if (nestsTooDeep(text)) throw InputError({{path, {}, {}, "", "is nested too deeply"}});
  try {
    return Json::parse(text);
  } catch (const Json::out_of_range&) {
    throw InputError({{path, {}, {}, "", "holds a number beyond the range of numbers"}});
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, error.byte > 0 ? error.byte - 1 : 0);
    const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 == 0
    throw InputError({{path, line, static_cast<int>(before.size() - line_start) + 1, "",
                       "expected a JSON document; it breaks off or is damaged here"}});
  }
}

}  // namespace

std::string toJson(const SymbolicModel& model) {
  Json cardinality = Json::object();
  for (const Concept which : kConcepts) {
    cardinality[std::string(name(which))] = model.cardinality()[index(which)];
  }
  Json actions = Json::object();
  for (const Action action : kActions) {
    actions[std::string(name(action))] = actionJson(model, action);
  }
  const Json document{{"format", kFormat},
                      {"version", kSymbolicModelVersion},
                      {"cardinality", cardinality},
                      {"grounding", groundingJson(model.grounding)},
                      {"actions", actions}};
  return document.dump(1) + "\n";
}

SymbolicModel parseSymbolicModel(std::string_view json, const std::filesystem::path& path) {
  const Json document = parsed(json, path.string());
  Reader reader(path.string());
  if (!document.is_object()) {
    reader.fault("", "expected a JSON object, found " + std::string(document.type_name()));
    reader.finish();
  }
  const std::string format = reader.text(reader.member(document, "", "format"), "format");
  if (format != kFormat) {
    reader.fault("format", "expected \"" + std::string(kFormat) + "\", found \"" + format + "\"");
  }
  const std::size_t version = reader.whole(reader.member(document, "", "version"), "version");
  if (version != kSymbolicModelVersion) {
    reader.fault("version", "expected " + std::to_string(kSymbolicModelVersion) + ", found " +
                                std::to_string(version));
  }
  const ConceptCardinality cardinality = readCardinality(reader, document);
  reader.finish();  // without them nothing else can be judged

  SymbolGrounding grounding =
      readGrounding(reader, reader.member(document, "", "grounding"), cardinality);
  EffectTable effects;
  LegalityTable legality;
  ModelEvidence evidence;
  const Json& actions = reader.member(document, "", "actions");
  for (const Action action : kActions) {
    readAction(reader, reader.member(actions, "actions", std::string(name(action))), action,
               cardinality, effects, legality, evidence);
  }
  reader.finish();
  try {
    return {std::move(grounding), TransitionModel(cardinality, std::move(effects)),
            ActionLegality(cardinality, std::move(legality)), std::move(evidence)};
  } catch (const std::invalid_argument& error) {
    throw InputError({{path.string(), {}, {}, "actions", error.what()}});
  }
}

void writeSymbolicModel(const std::filesystem::path& path, const SymbolicModel& model) {
  writeFileAtomically(path, toJson(model));
}

SymbolicModel readSymbolicModel(const std::filesystem::path& path) {
  return parseSymbolicModel(readFile(path), path);
}

}  // namespace conceptplan
