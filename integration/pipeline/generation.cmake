# Generation of datasets, a component of its own: it needs no Torch.
find_package(Threads REQUIRED)

conceptplan_library(generation
  HEADERS include/conceptplan/pipeline/generation.hpp
          include/conceptplan/pipeline/parallel_work.hpp
  SOURCES src/generation.cpp src/parallel_work.cpp
  PUBLIC conceptplan::domain
  PRIVATE conceptplan::rendering Threads::Threads)
