# What `cmake --install` copies: the program, libkarat, the module for images, the headers, the data
# files, and the config files for find_package(karat). The headers include nlohmann-json and no other
# library, so a project that uses Karat needs only that one to configure and compile; headers that
# only Karat's own sources use, with Eigen or SQLite in them, stay behind.
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_MESSAGE LAZY)
if(TARGET karat)
  install(TARGETS karat RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(TARGETS karat_library EXPORT karat-targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS karat_images LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/karat)
install(DIRECTORY spectral materials render DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/karat
  FILES_MATCHING PATTERN "*.h"
  PATTERN "nonnegative_least_squares.h" EXCLUDE
  PATTERN "index_search_folder.h" EXCLUDE
  PATTERN "sqlite_database.h" EXCLUDE)
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
