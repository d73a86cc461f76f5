#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conceptplan/pipeline/solve.hpp"
#include "result_log.hpp"

namespace conceptplan::cli {

/// The name of a scenario in results: its folder, or its file if that is not scenario.yaml.
std::string resultName(const std::filesystem::path& file);

/// One result as docs/command.md describes it.
Json resultJson(const ResultKey& key, const Solution& solution);

/// The result of a scenario that could not be read: status "invalid_input", the faults as reason.
Json invalidInputJson(const ResultKey& key, const InputError& error);

/// The result of a failure of the program itself: status "failed".
Json failedJson(const ResultKey& key, const std::string& reason);

/// The actions of a plan of a result, joined by spaces; "3:move_left" where there are several
/// targets and it moves object 3.
std::string actionsText(const Json& plan);

/// Results as CSV with a heading: of the plans only the best, its actions joined by spaces.
std::string toCsv(const std::vector<Json>& results);

/// Results as a table for a person.
TextTable toTable(const std::vector<Json>& results);

/// The code of a `solve` with these results.
int exitCodeOf(const std::vector<Json>& results);

}  // namespace conceptplan::cli
