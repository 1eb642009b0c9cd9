# `cmake --install`: the program, the headers, the static libraries, robots and scenarios, and a CMake package,
# so that outside this tree find_package(murosimf) gives murosimf::murosimf and murosimf::client.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(data_directory "${CMAKE_INSTALL_DATADIR}/murosimf")
set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/murosimf")

get_property(layers GLOBAL PROPERTY murosimf_layers)
install(TARGETS ${layers} EXPORT murosimf_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT murosimf_targets NAMESPACE murosimf:: DESTINATION "${package_directory}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/murosimf" DESTINATION include FILES_MATCHING PATTERN "*.h")
if(TARGET murosimf_app)
  install(TARGETS murosimf_app RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
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
