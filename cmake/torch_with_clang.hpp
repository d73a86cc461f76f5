#pragma once

#include <algorithm>
#include <memory>
#include <string>

// Included before all else where Clang compiles what includes Torch. Torch 1.13 has a class that
// holds a vector of a class declared later (pytorch#97689). Clang instantiates the vector's members
// on the spot wherever they are constexpr, as those of libstdc++ are from C++20 on; here they are
// not.
#if defined(__clang__) && defined(__GLIBCXX__)
// Clang refuses to define what <algorithm> has declared as constexpr, the fill of a vector<bool>,
// without it. Under another name it passes; std::fill of a vector<bool> would not link.
#define __fill_a1 __fill_bits
#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR
#include <vector>
#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR constexpr
#undef __fill_a1
#endif
