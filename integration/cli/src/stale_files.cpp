#include "stale_files.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <vector>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan::cli {
namespace {

/// The first number in a text; 0 if there is none.
std::size_t numberIn(const std::string& text) {
  std::size_t number = 0;
  const std::size_t digits = std::min(text.find_first_of("0123456789"), text.size());
  std::from_chars(text.data() + digits, text.data() + text.size(), number);
  return number;
}

[[noreturn]] void throwFault(const std::filesystem::path& path, const std::string& what,
                             const std::error_code& error) {
  throw InputError(
      {Fault{path.string(), {}, {}, "", "cannot be " + what + ": " + error.message()}});
}

}  // namespace

void removeStale(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::remove(file, error);
  if (error) throwFault(file, "removed", error);
}

void removeStale(const std::filesystem::path& folder, const NumberedName& name) {
  std::vector<std::filesystem::path> stale;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (const std::filesystem::directory_iterator end; !error && entry != end;
       entry.increment(error)) {
    const std::string file = entry->path().filename();
    const std::size_t number = numberIn(file);
    std::error_code unknown;  // what cannot be asked is no file of ours
    if (number > 0 && file == name(number) && entry->is_regular_file(unknown)) {
      stale.push_back(entry->path());
    }
  }
  if (error) throwFault(folder, "read", error);
  for (const std::filesystem::path& file : stale) removeStale(file);
}

}  // namespace conceptplan::cli
