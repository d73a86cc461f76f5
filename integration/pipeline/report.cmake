# The report, a component of its own: it needs no Torch, so that a program which plans from symbols
# can write one too.
set(report_template ${CMAKE_CURRENT_SOURCE_DIR}/src/report_page.html)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${report_template})
file(READ ${report_template} report_page)
configure_file(src/report_page.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp @ONLY)

conceptplan_library(report
  HEADERS include/conceptplan/pipeline/object_name.hpp include/conceptplan/pipeline/report.hpp
  SOURCES src/object_name.cpp src/report.cpp src/report_failure.cpp src/report_map.cpp
          src/report_markup.cpp src/report_outline.cpp src/report_pictures.cpp
          src/report_rejections.cpp src/report_symbols.cpp src/report_tables.cpp
          ${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp
  PUBLIC conceptplan::planners)
