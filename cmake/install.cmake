# `cmake --install` gives the program, the library for find_package(mote), scenarios and plots.

include(CMakePackageConfigHelpers)

install(TARGETS mote_program)
install(DIRECTORY scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/mote)
install(PROGRAMS scripts/plot scripts/plot-compare scripts/plot-study DESTINATION ${CMAKE_INSTALL_DATADIR}/mote)
install(DIRECTORY scripts/run_plots scripts/compare_plots scripts/study_plots DESTINATION ${CMAKE_INSTALL_DATADIR}/mote FILES_MATCHING PATTERN "*.py")
install(FILES ${PROJECT_BINARY_DIR}/generated/mote/scenario/version.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mote/scenario)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mote)
install(EXPORT mote NAMESPACE mote:: FILE moteTargets.cmake DESTINATION ${package})
configure_package_config_file(cmake/moteConfig.cmake.in moteConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(moteConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/moteConfig.cmake ${PROJECT_BINARY_DIR}/moteConfigVersion.cmake
              cmake/FindHYPRE.cmake
        DESTINATION ${package})

# The same share/mote beside bin/ in the build folder, so that the program finds it there too.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/mote)
foreach(shared IN ITEMS scenarios scripts/plot scripts/plot-compare scripts/plot-study scripts/run_plots
                      scripts/compare_plots scripts/study_plots)
  cmake_path(GET shared FILENAME name)
  if(NOT EXISTS ${PROJECT_BINARY_DIR}/share/mote/${name})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${shared} ${PROJECT_BINARY_DIR}/share/mote/${name} SYMBOLIC)
  endif()
endforeach()
