#include "conceptplan/domain/symbol_key.hpp"

#include <algorithm>
#include <cctype>

namespace conceptplan {

std::string symbolKey(Concept which) {
  std::string key(name(which));
  std::transform(key.begin(), key.end(), key.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return key;
}

}  // namespace conceptplan
