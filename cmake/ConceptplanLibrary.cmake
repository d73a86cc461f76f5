# conceptplan_library(NAME HEADERS ... SOURCES ... [PUBLIC ...] [PRIVATE ...])
#
# A static library conceptplan_NAME with the alias conceptplan::NAME, its public headers below
# `include/` of the calling folder, installed and exported as the component NAME.
function(conceptplan_library name)
  cmake_parse_arguments(ARG "" "" "HEADERS;SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target conceptplan_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(conceptplan::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${ARG_HEADERS})
  target_include_directories(${target} PRIVATE src)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  conceptplan_compile_options(${target})
  install(TARGETS ${target} EXPORT conceptplan-${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${name})
  set_property(GLOBAL APPEND PROPERTY CONCEPTPLAN_COMPONENTS ${name})
  # The components that the package loads before this one.
  foreach(library IN LISTS ARG_PUBLIC ARG_PRIVATE)
    if(library MATCHES "^conceptplan::(.+)")
      set_property(GLOBAL APPEND PROPERTY CONCEPTPLAN_REQUIRES_${name} ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()

# Warnings and sanitizers, on every target of ours.
function(conceptplan_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  # GCC 12 reports overlapping copies within std::string that cannot be (GCC bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(CONCEPTPLAN_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CONCEPTPLAN_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${CONCEPTPLAN_SANITIZE}
                                             -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${CONCEPTPLAN_SANITIZE})
  endif()
endfunction()
