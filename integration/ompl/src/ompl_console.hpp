#pragma once

namespace conceptplan {

/// While one lives, what OMPL says in this thread is not written; what it says in others goes to
/// the output handler of the program.
///
/// OMPL has one handler for the process, so ours stands in its place while one lives in any thread.
/// Then the handler that it replaced, and the one that `restorePreviousOutputHandler` would give,
/// are as before, unless the program has set one in between: that one stays, and ends the silence
/// until the last one alive is gone.
class OmplSilence {
 public:
  OmplSilence();
  ~OmplSilence();
  OmplSilence(const OmplSilence&) = delete;
  OmplSilence& operator=(const OmplSilence&) = delete;
};

}  // namespace conceptplan
