#include "planners/pddl/pddl_task.hpp"

#include <algorithm>
#include <cctype>
#include <queue>
#include <stdexcept>

namespace conceptplan::testing {
namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("PDDL: " + what);
}

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  PddlExpression readAll() {
    PddlExpression expression = read();
    skip();
    require(at_ == text_.size(), "text after the end");
    return expression;
  }

 private:
  void skip() {
    while (at_ < text_.size() &&
           (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == ';')) {
      if (text_[at_] == ';') at_ = std::min(text_.find('\n', at_), text_.size() - 1);
      ++at_;
    }
  }

  PddlExpression read() {
    skip();
    require(at_ < text_.size(), "the text ends early");
    PddlExpression expression;
    if (text_[at_] != '(') {
      while (at_ < text_.size() && text_[at_] != '(' && text_[at_] != ')' && text_[at_] != ';' &&
             std::isspace(static_cast<unsigned char>(text_[at_])) == 0) {
        expression.word += text_[at_++];
      }
      require(!expression.word.empty(), "a parenthesis that nothing opened");
      return expression;
    }
    ++at_;
    for (skip(); at_ < text_.size() && text_[at_] != ')'; skip()) {
      expression.list.push_back(read());
    }
    require(at_ < text_.size(), "a parenthesis that nothing closes");
    ++at_;
    return expression;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

void checkName(const std::string& name) {
  require(!name.empty() && name[0] >= 'a' && name[0] <= 'z' &&
              std::all_of(name.begin(), name.end(),
                          [](unsigned char c) {
                            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' ||
                                   c == '_';
                          }),
          "\"" + name + "\" is no name");
}

/// "a b - t c - u" as {a, t}, {b, t}, {c, u}; from a position of a list on.
std::vector<std::pair<std::string, std::string>> typed(const PddlExpression& list,
                                                       std::size_t from) {
  std::vector<std::pair<std::string, std::string>> result;
  std::size_t untyped = 0;
  for (std::size_t i = from; i < list.list.size(); ++i) {
    if (list.list[i].word == "-") {
      require(i + 1 < list.list.size(), "a type is missing");
      for (; untyped < result.size(); ++untyped) result[untyped].second = list.list[i + 1].word;
      ++i;
    } else {
      result.emplace_back(list.list[i].word, "");
    }
  }
  require(untyped == result.size(), "an object without a type");
  return result;
}

/// The parts of (and ...), or the expression itself.
std::vector<PddlExpression> conjuncts(const PddlExpression& expression) {
  if (expression.head() != "and") return {expression};
  return {expression.list.begin() + 1, expression.list.end()};
}

std::string join(const PddlExpression& atom, const std::map<std::string, std::string>& binding) {
  std::string text;
  for (const PddlExpression& part : atom.list) {
    const auto bound = binding.find(part.word);
    text += (text.empty() ? "" : " ") + (bound == binding.end() ? part.word : bound->second);
  }
  return text;
}

}  // namespace

const std::string& PddlExpression::head() const {
  require(!list.empty() && !list.front().word.empty(), "a list without a first word");
  return list.front().word;
}

PddlTask::PddlTask(const std::string& domain, const std::string& problem) {
  readDomain(Reader(domain).readAll());
  readProblem(Reader(problem).readAll());
  for (const Schema& schema : schemas_) {
    Binding binding;
    ground(schema, binding);
  }
}

void PddlTask::readDomain(const PddlExpression& domain) {
  require(domain.head() == "define" && domain.list.at(1).head() == "domain", "no domain");
  checkName(domain.list.at(1).list.at(1).word);
  const std::vector<std::string> order{":requirements", ":types",     ":constants",
                                       ":predicates",   ":functions", ":action"};
  std::size_t last = 0;
  for (std::size_t i = 2; i < domain.list.size(); ++i) {
    const PddlExpression& section = domain.list[i];
    const auto place = std::find(order.begin(), order.end(), section.head());
    require(place != order.end(), "section " + section.head());
    const auto number = static_cast<std::size_t>(place - order.begin());
    require(number > last || i == 2 || section.head() == ":action", "sections out of order");
    last = number;
    if (section.head() == ":requirements") {
      const std::set<std::string> known{":strips", ":typing", ":action-costs",
                                        ":conditional-effects", ":probabilistic-effects"};
      for (std::size_t k = 1; k < section.list.size(); ++k) {
        require(known.contains(section.list[k].word), "requirement " + section.list[k].word);
        requirements_.insert(section.list[k].word);
      }
    } else if (section.head() == ":types") {
      for (std::size_t k = 1; k < section.list.size(); ++k) types_.insert(section.list[k].word);
    } else if (section.head() == ":constants") {
      declareObjects(section);
    } else if (section.head() == ":action") {
      readAction(section);
    } else {
      const bool functions = section.head() == ":functions";
      require(!functions || requirements_.contains(":action-costs"), "functions not required");
      for (std::size_t k = 1; k < section.list.size(); ++k) {
        if (functions && section.list[k].word == "-") {
          require(section.list.at(++k).word == "number", "functions are numbers");
          continue;
        }
        Words argument_types;
        for (const auto& [variable, type] : typed(section.list[k], 1)) {
          require(types_.contains(type), "type " + type);
          argument_types.push_back(type);
        }
        checkName(section.list[k].head());
        const bool fresh = (functions ? functions_ : predicates_)
                               .emplace(section.list[k].head(), argument_types)
                               .second;
        require(fresh, section.list[k].head() + " declared twice");
      }
    }
  }
  require(types_.empty() || requirements_.contains(":typing"), "types not required");
}

void PddlTask::readAction(const PddlExpression& action) {
  require(action.list.size() == 8 && action.list[2].word == ":parameters" &&
              action.list[4].word == ":precondition" && action.list[6].word == ":effect",
          "an action of another form");
  Schema schema;
  schema.name = action.list[1].word;
  checkName(schema.name);
  for (const auto& [name, type] : typed(action.list[3], 0)) {
    require(name.starts_with("?") && types_.contains(type), "parameter " + name);
    schema.parameters.push_back({name, type});
  }
  schema.conditions = conjuncts(action.list[5]);
  for (const PddlExpression& atom : schema.conditions) {
    checkAtom(atom, schema.parameters, predicates_);
  }
  schema.effect = action.list[7];
  checkEffect(schema.effect, schema.parameters);
  schemas_.push_back(std::move(schema));
}

void PddlTask::checkAtom(const PddlExpression& atom, const std::vector<Parameter>& variables,
                         const std::map<std::string, Words>& declared) const {
  const auto found = declared.find(atom.head());
  require(found != declared.end(), atom.head() + " is not declared");
  require(atom.list.size() == found->second.size() + 1, "arguments of " + atom.head());
  for (std::size_t i = 1; i < atom.list.size(); ++i) {
    const std::string& word = atom.list[i].word;
    std::string type;
    if (word.starts_with("?")) {
      for (const Parameter& variable : variables) {
        if (variable.name == word) type = variable.type;
      }
    } else if (objects_.contains(word)) {
      type = objects_.at(word);
    }
    require(type == found->second[i - 1], word + " in " + atom.head());
  }
}

void PddlTask::checkEffect(const PddlExpression& effect, const std::vector<Parameter>& variables) {
  if (effect.head() == "and") {
    for (std::size_t i = 1; i < effect.list.size(); ++i) checkEffect(effect.list[i], variables);
  } else if (effect.head() == "not") {
    checkEffect(effect.list.at(1), variables);
  } else if (effect.head() == "increase") {
    require(effect.list.at(1).head() == "total-cost", "only the total cost increases");
    if (effect.list.at(2).word.empty()) checkAtom(effect.list[2], variables, functions_);
  } else if (effect.head() == "when") {
    require(requirements_.contains(":conditional-effects"), "when not required");
    for (const PddlExpression& atom : conjuncts(effect.list.at(1))) {
      checkAtom(atom, variables, predicates_);
    }
    checkEffect(effect.list.at(2), variables);
  } else if (effect.head() == "probabilistic") {
    require(requirements_.contains(":probabilistic-effects"), "probabilistic not required");
    double sum = 0;
    for (std::size_t i = 1; i < effect.list.size(); i += 2) {
      sum += std::stod(effect.list[i].word);
      checkEffect(effect.list.at(i + 1), variables);
    }
    require(sum <= 1 + 1e-12, "probabilities above one");
  } else {
    checkAtom(effect, variables, predicates_);
    changing_.insert(effect.head());
  }
}

void PddlTask::declareObjects(const PddlExpression& section) {
  for (const auto& [name, type] : typed(section, 1)) {
    checkName(name);
    require(types_.contains(type), "type " + type);
    require(objects_.emplace(name, type).second, name + " declared twice");
  }
}

void PddlTask::readProblem(const PddlExpression& problem) {
  require(problem.head() == "define" && problem.list.at(1).head() == "problem", "no problem");
  for (std::size_t i = 2; i < problem.list.size(); ++i) {
    const PddlExpression& section = problem.list[i];
    if (section.head() == ":objects") {
      declareObjects(section);
    } else if (section.head() == ":init") {
      for (std::size_t k = 1; k < section.list.size(); ++k) {
        const PddlExpression& fact = section.list[k];
        if (fact.head() == "=") {
          checkAtom(fact.list.at(1), {}, functions_);
          const std::string& number = fact.list.at(2).word;
          require(number.find_first_not_of("0123456789") == std::string::npos, "cost " + number);
          require(values_.emplace(join(fact.list[1], {}), std::stoll(number)).second, "two values");
        } else {
          checkAtom(fact, {}, predicates_);
          require(facts_.insert(join(fact, {})).second, "a fact twice");
        }
      }
    } else if (section.head() == ":goal") {
      goal_ = conjuncts(section.list.at(1));
      for (const PddlExpression& atom : goal_) checkAtom(atom, {}, predicates_);
    } else if (section.head() == ":metric") {
      require(section.list.at(1).word == "minimize" && section.list.at(2).head() == "total-cost" &&
                  values_.contains("total-cost"),
              "another metric");
    } else {
      require(section.head() == ":domain", "section " + section.head());
    }
  }
}

void PddlTask::ground(const Schema& schema, Binding& binding) {
  for (const PddlExpression& atom : schema.conditions) {
    const bool whole = std::all_of(
        atom.list.begin() + 1, atom.list.end(), [&binding](const PddlExpression& argument) {
          return !argument.word.starts_with("?") || binding.contains(argument.word);
        });
    if (whole && !changing_.contains(atom.head()) && !facts_.contains(join(atom, binding))) return;
  }
  if (binding.size() == schema.parameters.size()) {
    GroundAction action{&schema, binding, {}};
    for (const PddlExpression& atom : schema.conditions) {
      if (changing_.contains(atom.head())) action.conditions.push_back(join(atom, binding));
    }
    actions_.push_back(std::move(action));
    return;
  }
  const Parameter& next = schema.parameters[binding.size()];
  require(!binding.contains(next.name), "parameter " + next.name + " twice");
  for (const auto& [object, type] : objects_) {
    if (type != next.type) continue;
    binding[next.name] = object;
    ground(schema, binding);
    binding.erase(next.name);
  }
}

PddlTask::State PddlTask::initial() const {
  State state;
  for (const std::string& fact : facts_) {
    if (changing_.contains(fact.substr(0, fact.find(' ')))) state.insert(fact);
  }
  return state;
}

bool PddlTask::isGoal(const State& state) const {
  return std::all_of(goal_.begin(), goal_.end(), [&](const PddlExpression& atom) {
    const std::string fact = join(atom, {});
    return changing_.contains(atom.head()) ? state.contains(fact) : facts_.contains(fact);
  });
}

std::vector<PddlTask::Change> PddlTask::changes(const PddlExpression& effect,
                                                const Binding& binding, const State& state) const {
  if (effect.head() == "and") {
    std::vector<Change> all(1);
    for (std::size_t i = 1; i < effect.list.size(); ++i) {
      std::vector<Change> product;
      for (const Change& more : changes(effect.list[i], binding, state)) {
        for (Change change : all) {
          change.added.insert(more.added.begin(), more.added.end());
          change.deleted.insert(more.deleted.begin(), more.deleted.end());
          change.probability *= more.probability;
          product.push_back(std::move(change));
        }
      }
      all = std::move(product);
    }
    return all;
  }
  if (effect.head() == "not") return {{{}, {join(effect.list[1], binding)}}};
  if (effect.head() == "increase") return {{}};
  if (effect.head() == "when") {
    for (const PddlExpression& atom : conjuncts(effect.list[1])) {
      require(changing_.contains(atom.head()), "a condition on what never changes");
      if (!state.contains(join(atom, binding))) return {{}};
    }
    return changes(effect.list[2], binding, state);
  }
  if (effect.head() == "probabilistic") {
    std::vector<Change> all;
    double rest = 1;
    for (std::size_t i = 1; i < effect.list.size(); i += 2) {
      const double probability = std::stod(effect.list[i].word);
      rest -= probability;
      for (Change change : changes(effect.list[i + 1], binding, state)) {
        change.probability *= probability;
        all.push_back(std::move(change));
      }
    }
    if (rest > 1e-12) all.push_back({{}, {}, rest});
    return all;
  }
  return {{{join(effect, binding)}, {}}};
}

std::int64_t PddlTask::costOf(const PddlExpression& effect, const Binding& binding) const {
  if (effect.head() == "and") {
    std::int64_t sum = 0;
    for (std::size_t i = 1; i < effect.list.size(); ++i) sum += costOf(effect.list[i], binding);
    return sum;
  }
  if (effect.head() != "increase") return 0;
  const PddlExpression& value = effect.list[2];
  return value.word.empty() ? values_.at(join(value, binding)) : std::stoll(value.word);
}

std::vector<PddlTask::Step> PddlTask::steps(const State& state) const {
  std::vector<Step> steps;
  for (const GroundAction& action : actions_) {
    const bool applicable =
        std::all_of(action.conditions.begin(), action.conditions.end(),
                    [&state](const std::string& fact) { return state.contains(fact); });
    if (!applicable) continue;
    Step step;
    step.text = "(" + action.schema->name;
    for (const Parameter& parameter : action.schema->parameters) {
      step.text += " " + action.binding.at(parameter.name);
    }
    step.text += ")";
    std::map<State, double> outcomes;
    for (const Change& change : changes(action.schema->effect, action.binding, state)) {
      State next = state;
      for (const std::string& fact : change.deleted) next.erase(fact);
      next.insert(change.added.begin(), change.added.end());
      outcomes[next] += change.probability;
    }
    for (const auto& [next, probability] : outcomes) step.outcomes.push_back({next, probability});
    step.cost = costOf(action.schema->effect, action.binding);
    steps.push_back(std::move(step));
  }
  return steps;
}

std::optional<PddlTask::Solution> PddlTask::solve() const {
  struct Reached {
    std::int64_t cost;
    State from;
    std::string step;
  };
  std::map<State, Reached> reached{{initial(), {0, {}, ""}}};
  std::priority_queue<std::pair<std::int64_t, State>, std::vector<std::pair<std::int64_t, State>>,
                      std::greater<>>
      open;
  open.emplace(0, initial());
  Solution solution;
  while (!open.empty()) {
    const auto [cost, state] = open.top();
    open.pop();
    if (cost > reached.at(state).cost) continue;
    if (isGoal(state)) {
      solution.cost = cost;
      for (State at = state; at != initial(); at = reached.at(at).from) {
        solution.steps.insert(solution.steps.begin(), reached.at(at).step);
      }
      return solution;
    }
    ++solution.expanded;
    for (const Step& step : steps(state)) {
      require(step.outcomes.size() == 1, "several outcomes");
      const State& next = step.outcomes.front().state;
      const auto [found, fresh] =
          reached.try_emplace(next, Reached{cost + step.cost, state, step.text});
      if (!fresh && found->second.cost <= cost + step.cost) continue;
      found->second = {cost + step.cost, state, step.text};
      open.emplace(cost + step.cost, next);
    }
  }
  return std::nullopt;
}

}  // namespace conceptplan::testing
