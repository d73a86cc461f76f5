# The installed package: find_package(conceptplan COMPONENTS planners ...), the command, and what
# it reads.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/conceptplan)
set(model_dir ${CMAKE_INSTALL_DATADIR}/conceptplan/models)

get_property(components GLOBAL PROPERTY CONCEPTPLAN_COMPONENTS)
list(REMOVE_DUPLICATES components)
set(requirements "")
foreach(component IN LISTS components)
  install(EXPORT conceptplan-${component} NAMESPACE conceptplan:: DESTINATION ${package_dir}
          COMPONENT ${component})
  get_property(required GLOBAL PROPERTY CONCEPTPLAN_REQUIRES_${component})
  list(REMOVE_DUPLICATES required)
  list(REMOVE_ITEM required ${component})
  string(REPLACE ";" " " required "${required}")
  string(APPEND requirements "  set(requires_${component} ${required})\n")
endforeach()
string(REPLACE ";" " " components "${components}")

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/conceptplan-config.cmake.in
                              ${PROJECT_BINARY_DIR}/conceptplan-config.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS model_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/conceptplan-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/conceptplan-config.cmake
              ${PROJECT_BINARY_DIR}/conceptplan-config-version.cmake
        DESTINATION ${package_dir} COMPONENT domain)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindOpenCV.cmake ${PROJECT_SOURCE_DIR}/cmake/Findompl.cmake
        DESTINATION ${package_dir}/modules COMPONENT domain)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT domain)
install(DIRECTORY DESTINATION ${model_dir} COMPONENT domain)
install(DIRECTORY learner/models/ DESTINATION ${model_dir} COMPONENT learner OPTIONAL)
