#pragma once

namespace conceptplan {

/// Sets the number of threads of Torch's operations for a while, and puts it back.
class TorchThreads {
 public:
  explicit TorchThreads(int threads);
  ~TorchThreads();
  TorchThreads(const TorchThreads&) = delete;
  TorchThreads& operator=(const TorchThreads&) = delete;

 private:
  int before_;
};

}  // namespace conceptplan
