# Disentanglement measures of any codes; no Torch.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)

conceptplan_library(disentanglement
  HEADERS
    include/conceptplan/learner/disentanglement/dci.hpp
    include/conceptplan/learner/disentanglement/disentanglement_scores.hpp
    include/conceptplan/learner/disentanglement/factor_codes.hpp
    include/conceptplan/learner/disentanglement/principal_axes.hpp
  SOURCES
    src/disentanglement/dci.cpp
    src/disentanglement/disentanglement_scores.cpp
    src/disentanglement/factor_codes.cpp
    src/disentanglement/fixed_factor_scores.cpp
    src/disentanglement/mutual_information_gap.cpp
  src/disentanglement/principal_axes.cpp
    src/disentanglement/quantile_bins.cpp
    src/disentanglement/random_forest.cpp
    src/disentanglement/separated_attribute_predictability.cpp
  PUBLIC Eigen3::Eigen)
