#pragma once

#include <string>

#include "session.hpp"

namespace conceptplan::cli {

/// How well a model reads the single objects of a set: `evaluate --concepts`.
int evaluateConceptSet(const std::string& folder, const std::string& model, Session& session);

}  // namespace conceptplan::cli
