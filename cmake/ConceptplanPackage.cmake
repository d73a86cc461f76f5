# The installed package: find_package(conceptplan COMPONENTS planners ...).
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/conceptplan)
get_property(components GLOBAL PROPERTY CONCEPTPLAN_COMPONENTS)
list(REMOVE_DUPLICATES components)
foreach(component IN LISTS components)
  install(EXPORT conceptplan-${component} NAMESPACE conceptplan:: DESTINATION ${package_dir}
          COMPONENT ${component})
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/conceptplan-config.cmake.in
                              ${PROJECT_BINARY_DIR}/conceptplan-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/conceptplan-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/conceptplan-config.cmake
              ${PROJECT_BINARY_DIR}/conceptplan-config-version.cmake
        DESTINATION ${package_dir} COMPONENT domain)
