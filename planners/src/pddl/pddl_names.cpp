#include "pddl_names.hpp"

namespace conceptplan {
namespace {

bool isLetter(char letter) { return letter >= 'a' && letter <= 'z'; }

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

std::string pddlName(std::string_view text) {
  std::string name = lowerCase(text);
  for (char& letter : name) {
    const bool digit = letter >= '0' && letter <= '9';
    if (!isLetter(letter) && !digit && letter != '_') letter = '-';
  }
  return name.empty() || !isLetter(name.front()) ? "p-" + name : name;
}

std::string typeName(Concept which) { return lowerCase(name(which)); }

std::string objectName(Concept which, SymbolId symbol) {
  return typeName(which) + "-" + std::to_string(index(symbol));
}

std::string targetAtom(Concept which, const std::string& value) {
  return "(target_" + typeName(which) + " " + value + ")";
}

std::string targetFact(Concept which, SymbolId symbol) {
  return targetAtom(which, objectName(which, symbol));
}

}  // namespace conceptplan
