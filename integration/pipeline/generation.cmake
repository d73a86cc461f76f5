# Generation of datasets, a component of its own: it needs no Torch.
find_package(Threads REQUIRED)

conceptplan_library(generation
  HEADERS include/conceptplan/pipeline/generation.hpp
  SOURCES src/generation.cpp
  PUBLIC conceptplan::domain
  PRIVATE conceptplan::rendering Threads::Threads)
