#pragma once

#include "choice_option.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan::cli {

// Options that several commands share.

inline CLI::Option* addSplit(CLI::App& command, Split& split, const std::string& summary) {
  return addChoice(command, "--split", split, {"train", "validation", "test"}, splitNamed, summary);
}

inline CLI::Option* addObjects(CLI::App& command, ObjectSet& objects) {
  return addChoice(command, "--objects", objects, {"seen", "unseen"}, objectSetNamed,
                   "Types of target and obstacles; seen if left out");
}

inline CLI::Option* addDomain(CLI::App& command, RenderDomain& domain) {
  return addChoice(command, "--domain", domain, {"standard", "shifted"}, renderDomainNamed,
                   "How pictures are taken; standard if left out");
}

}  // namespace conceptplan::cli
