# karat_dependencies: every library that Karat builds on, as one interface target. All of them are
# Debian 12 packages; a newer major version is taken as it comes.

# Embree's config files allow one major version only, so the version is compared here.
find_package(embree CONFIG REQUIRED)
if(embree_VERSION VERSION_LESS 3.13)
  message(FATAL_ERROR "Embree 3.13 or newer is needed; ${embree_DIR} holds ${embree_VERSION}.")
endif()
find_package(TBB CONFIG REQUIRED)
find_package(OpenImageIO CONFIG REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(valijson CONFIG REQUIRED)
find_package(yaml-cpp CONFIG REQUIRED)
find_package(assimp CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(SQLite3 REQUIRED)
# Ceres' small solver (ceres/tiny_solver.h) is a header that needs Eigen alone; libceres is not linked.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
# Debian puts OpenColorIO's config files where CMake does not look, and cairo has none.
find_package(PkgConfig REQUIRED)
pkg_check_modules(Cairo REQUIRED IMPORTED_TARGET cairo>=1.16)
pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO>=2.1)

# Two targets got a namespace in later versions.
set(karat_valijson valijson)
if(TARGET ValiJSON::valijson)
  set(karat_valijson ValiJSON::valijson)
endif()
set(karat_yaml yaml-cpp)
if(TARGET yaml-cpp::yaml-cpp)
  set(karat_yaml yaml-cpp::yaml-cpp)
endif()

add_library(karat_dependencies INTERFACE)
target_link_libraries(karat_dependencies INTERFACE
  embree TBB::tbb OpenEXR::OpenEXR nlohmann_json::nlohmann_json
  ${karat_valijson} ${karat_yaml} assimp::assimp CLI11::CLI11 fmt::fmt PkgConfig::OpenColorIO
  SQLite::SQLite3 PkgConfig::Cairo Eigen3::Eigen)
# OpenImageIO is linked by the module karat_images alone (CMakeLists.txt); its version is a header's.
# Debian's target names include folders of packages that need not be installed, which CMake forgives
# behind a target of our own.
add_library(karat_openimageio INTERFACE)
target_link_libraries(karat_openimageio INTERFACE OpenImageIO::OpenImageIO)
target_include_directories(karat_dependencies SYSTEM INTERFACE
  $<TARGET_PROPERTY:OpenImageIO::OpenImageIO,INTERFACE_INCLUDE_DIRECTORIES>)
target_link_libraries(karat_dependencies INTERFACE ${CMAKE_DL_LIBS})

# What Karat's own headers include; cmake/karat-config.cmake.in finds the same.
set(karat_public_dependencies nlohmann_json::nlohmann_json)
