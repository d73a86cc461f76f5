conceptplan_library(transitions
  HEADERS include/conceptplan/learner/transitions/transition_estimation.hpp
  SOURCES
    src/transitions/effect_estimation.cpp
    src/transitions/legality_estimation.cpp
    src/transitions/step_table.cpp
    src/transitions/transition_estimation.cpp
  PUBLIC conceptplan::domain)
