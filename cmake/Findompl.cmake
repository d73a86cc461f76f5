# OMPL by its own package configuration, with the target ompl::ompl also where that configuration
# has none (before 1.7). Its library alone is linked: what else it names there (Boost.Serialization,
# Boost.Filesystem, ODE) is for programs that use these themselves.
if(TARGET ompl::ompl)
  set(ompl_FOUND TRUE)
  return()
endif()
find_package(ompl ${ompl_FIND_VERSION} CONFIG QUIET)

if(ompl_FOUND AND NOT TARGET ompl::ompl)
  list(GET OMPL_LIBRARIES 0 ompl_library)
  add_library(ompl::ompl UNKNOWN IMPORTED)
  set_target_properties(ompl::ompl PROPERTIES
    IMPORTED_LOCATION ${ompl_library}
    INTERFACE_INCLUDE_DIRECTORIES "${OMPL_INCLUDE_DIRS}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ompl REQUIRED_VARS ompl_DIR VERSION_VAR ompl_VERSION)
