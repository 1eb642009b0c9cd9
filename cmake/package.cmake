# `cmake --install`: the program, the headers, the static libraries, robots and scenarios, and a CMake package,
# so that outside this tree find_package(murosimf) gives murosimf::murosimf and murosimf::client, and murosimf::viewer
# where the window is built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(data_directory "${CMAKE_INSTALL_DATADIR}/murosimf")
set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/murosimf")

get_property(layers GLOBAL PROPERTY murosimf_layers)
install(TARGETS ${layers} EXPORT murosimf_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT murosimf_targets NAMESPACE murosimf:: DESTINATION "${package_directory}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/murosimf" DESTINATION include FILES_MATCHING PATTERN "*.h")
set(programs murosimf_app murosimf-control)
if(TARGET murosimf_viewer)
  list(APPEND programs murosimf-view)
  install(TARGETS murosimf_viewer murosimf_playing murosimf_controllers EXPORT murosimf_targets
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(FILES "${PROJECT_SOURCE_DIR}/apps/murosimf-view/run_viewer.h" DESTINATION include/murosimf-view)
endif()
install(TARGETS ${programs} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
# All that is installed, and nothing else: what `make install` builds.
add_custom_target(murosimf_installed DEPENDS ${programs} ${layers})
foreach(data robots scenarios)
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/${data}")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/${data}" DESTINATION "${data_directory}")
  endif()
endforeach()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/murosimf-config.cmake.in"
  "${PROJECT_BINARY_DIR}/murosimf-config.cmake" INSTALL_DESTINATION "${package_directory}"
  PATH_VARS data_directory)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/murosimf-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/murosimf-config.cmake" "${PROJECT_BINARY_DIR}/murosimf-config-version.cmake"
        DESTINATION "${package_directory}")
