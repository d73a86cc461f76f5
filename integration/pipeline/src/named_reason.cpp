#include "named_reason.hpp"

#include <charconv>
#include <string_view>
#include <vector>

#include "conceptplan/domain/listed.hpp"
#include "conceptplan/pipeline/solve.hpp"

namespace conceptplan {
namespace {

constexpr std::string_view kMeets = "meets object ";

std::string wayWithout(const std::string& objects) {
  return "without " + objects + " there would be a way";
}

}  // namespace

std::string namedReason(const PlanResult& result, std::span<const std::string> names) {
  std::vector<std::string> indices, named;
  for (const std::size_t object : result.blocking) {
    indices.push_back(std::to_string(object));
    named.push_back(names[object]);
  }
  const std::string told =
      wayWithout((indices.size() > 1 ? "objects " : "object ") + listed(indices));
  std::string reason = result.reason;
  const std::size_t at = reason.find(told);
  return at == std::string::npos ? reason
                                 : reason.replace(at, told.size(), wayWithout(listed(named)));
}

std::string namedReason(const std::string& reason, std::span<const std::string> names) {
  const std::size_t at = reason.find(kMeets);
  if (at == std::string::npos) return reason;
  std::size_t object = 0;
  const char* const end = reason.data() + reason.size();
  const auto read = std::from_chars(reason.data() + at + kMeets.size(), end, object);
  if (read.ec != std::errc{} || object >= names.size()) return reason;
  return reason.substr(0, at) + "meets " + names[object] + std::string(read.ptr, end);
}

}  // namespace conceptplan
