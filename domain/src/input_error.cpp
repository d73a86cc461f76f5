#include "conceptplan/domain/input_error.hpp"

#include <utility>

namespace conceptplan {
namespace {

std::string joined(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += fault.text();
  }
  return text.empty() ? "the input is wrong" : text;
}

}  // namespace

std::string Fault::text() const {
  std::string text = path;
  if (line) text += ':' + std::to_string(*line);
  if (line && column) text += ':' + std::to_string(*column);
  if (!key.empty()) text += (text.empty() ? "" : ": ") + key;
  if (!message.empty()) text += (text.empty() ? "" : ": ") + message;
  return text;
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

}  // namespace conceptplan
