#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace conceptplan::cli {

// A command that writes several files first removes those of its last run, all before it writes the
// first one: what an interrupt leaves is then of one run.

/// The name of the file of that number, from 1.
using NumberedName = std::function<std::string(std::size_t number)>;

/// Removes a file if it is there. @throws InputError if that is impossible.
void removeStale(const std::filesystem::path& file);

/// The same of all files of a folder that have the name of some number; whatever else is there
/// stays.
void removeStale(const std::filesystem::path& folder, const NumberedName& name);

}  // namespace conceptplan::cli
