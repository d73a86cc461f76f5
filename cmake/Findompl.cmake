# OMPL by its own package configuration, with the target ompl::ompl also where that configuration
# has none (before 1.7). Its library alone is linked: what else it names there (Boost.Serialization,
# Boost.Filesystem, ODE) is for programs that use these themselves. So are folders of headers that are
# not there: Debian's package of 1.6 names those of the machine that it was built on.
if(TARGET ompl::ompl)
  set(ompl_FOUND TRUE)
  return()
endif()
# Without the version, which is compared below: OMPL's packages of another major version than the one
# asked for call themselves incompatible, and CMake would pass on to an older one without a word.
set(ompl_wanted ${ompl_FIND_VERSION})
unset(ompl_FIND_VERSION)
unset(ompl_FIND_VERSION_COMPLETE)
find_package(ompl CONFIG QUIET)
set(ompl_FIND_VERSION ${ompl_wanted})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ompl REQUIRED_VARS ompl_DIR VERSION_VAR ompl_VERSION)

if(ompl_FOUND AND NOT TARGET ompl::ompl)
  list(GET OMPL_LIBRARIES 0 ompl_library)
  set(ompl_headers ${OMPL_INCLUDE_DIRS})
  foreach(folder IN LISTS OMPL_INCLUDE_DIRS)
    if(NOT IS_DIRECTORY ${folder})
      list(REMOVE_ITEM ompl_headers ${folder})
    endif()
  endforeach()
  add_library(ompl::ompl UNKNOWN IMPORTED)
  set_target_properties(ompl::ompl PROPERTIES
    IMPORTED_LOCATION ${ompl_library}
    INTERFACE_INCLUDE_DIRECTORIES "${ompl_headers}")
endif()
