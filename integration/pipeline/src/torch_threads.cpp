#include "torch_threads.hpp"

#include <ATen/Parallel.h>

#include <algorithm>

namespace conceptplan {

TorchThreads::TorchThreads(int threads) : before_(at::get_num_threads()) {
  at::set_num_threads(std::max(1, threads));
}

TorchThreads::~TorchThreads() { at::set_num_threads(before_); }

}  // namespace conceptplan
