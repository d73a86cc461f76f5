#include "option_range.hpp"

#include <stdexcept>
#include <string>

namespace conceptplan {

void checkOptionRange(const char* option, double value, double least, double most) {
  if (!(value >= least && value <= most)) {
    throw std::invalid_argument(std::string(option) + " is " + std::to_string(value) +
                                ", expected a number in [" + std::to_string(least) + ", " +
                                std::to_string(most) + "]");
  }
}

}  // namespace conceptplan
