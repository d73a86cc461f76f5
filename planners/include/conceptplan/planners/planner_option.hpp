#pragma once

#include <map>
#include <string>
#include <vector>

namespace conceptplan {

/// Values of options as text, by name: what a scenario file or a command line holds.
using OptionTexts = std::map<std::string, std::string>;

enum class OptionType { kNumber, kInteger, kChoice };

/// One option of a planner.
struct PlannerOption {
  std::string name;
  OptionType type = OptionType::kNumber;
  std::string standard;              ///< the value if none is given, as text
  double least = 0;                  ///< for numbers
  double most = 0;                   ///< for numbers
  std::vector<std::string> choices;  ///< for kChoice
  std::string summary;

  /// A number in [least, most].
  static PlannerOption number(std::string name, std::string standard, double least, double most,
                              std::string summary);
  /// An integer in [least, most].
  static PlannerOption integer(std::string name, std::string standard, double least, double most,
                               std::string summary);
  /// One of the choices, which are at least one; the first if none is given.
  static PlannerOption choice(std::string name, std::vector<std::string> choices,
                              std::string summary);

  /// What planners share: legality_threshold, 0.01 unless given.
  static PlannerOption legalityThreshold();
  /// The same: step_discount in [least, 0.5], 0.01 unless given.
  static PlannerOption stepDiscount(double least = 0);

  /// "number", "integer" or "choice".
  std::string typeName() const;
  /// "[0, 1]" or "soft | hard".
  std::string range() const;
};

/// Checked values of all options of one planner.
class OptionValues {
 public:
  /// @param path stands in the faults.
  /// @throws InputError with every unknown name, wrong type and value out of range; key is
  /// "planner.options.NAME".
  OptionValues(const std::vector<PlannerOption>& options, const OptionTexts& texts,
               const std::string& path);

  double number(const std::string& name) const;
  const std::string& choice(const std::string& name) const;

 private:
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> choices_;
};

}  // namespace conceptplan
