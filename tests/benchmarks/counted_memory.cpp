#include "benchmarks/counted_memory.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

std::size_t allocated = 0;
std::size_t most_allocated = 0;

}  // namespace

// The other forms of operator new and delete call these.

void* operator new(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  allocated += malloc_usable_size(memory);
  most_allocated = std::max(most_allocated, allocated);
  return memory;
}

void operator delete(void* memory) noexcept {
  allocated -= malloc_usable_size(memory);  // 0 for nothing
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace conceptplan::testing {

CountedMemory::CountedMemory() : before_(allocated) { most_allocated = allocated; }

double CountedMemory::peak_MB() const {
  return static_cast<double>(most_allocated - before_) / 1e6;
}

double CountedMemory::held_MB() const { return static_cast<double>(allocated - before_) / 1e6; }

}  // namespace conceptplan::testing
