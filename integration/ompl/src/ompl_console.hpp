#pragma once

namespace conceptplan {

/// While one lives, what OMPL says in this thread is not written; other threads are not concerned.
class OmplSilence {
 public:
  OmplSilence();
  ~OmplSilence();
  OmplSilence(const OmplSilence&) = delete;
  OmplSilence& operator=(const OmplSilence&) = delete;
};

}  // namespace conceptplan
