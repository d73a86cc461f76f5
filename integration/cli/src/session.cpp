#include "session.hpp"

namespace conceptplan::cli {

Json toJson(const std::vector<Fault>& faults) {
  Json list = Json::array();
  for (const Fault& fault : faults) {
    list.push_back({{"path", fault.path},
                    {"line", fault.line ? Json(*fault.line) : Json()},
                    {"column", fault.column ? Json(*fault.column) : Json()},
                    {"key", fault.key.empty() ? Json() : Json(fault.key)},
                    {"message", fault.message}});
  }
  return list;
}

}  // namespace conceptplan::cli
