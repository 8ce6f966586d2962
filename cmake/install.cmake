# What `cmake --install` copies: the program, libkarat, the module for images, the headers, the data
# files, and the config files for find_package(karat). Karat's headers include nlohmann-json and no other library, so a
# project that uses Karat needs only that one to configure and compile.
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_MESSAGE LAZY)
if(TARGET karat)
  install(TARGETS karat RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(TARGETS karat_library EXPORT karat-targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS karat_images LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/karat)
install(DIRECTORY spectral materials render DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/karat
  FILES_MATCHING PATTERN "*.h")
install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/karat OPTIONAL)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/karat)
install(EXPORT karat-targets NAMESPACE karat:: FILE karat-targets.cmake
  DESTINATION ${package_folder})
configure_package_config_file(cmake/karat-config.cmake.in ${PROJECT_BINARY_DIR}/karat-config.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/karat-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/karat-config.cmake ${PROJECT_BINARY_DIR}/karat-config-version.cmake
  DESTINATION ${package_folder})
