# Every library that Karat builds on, as one interface target: all of them are Debian 12 packages.
find_package(embree 3.13 REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(valijson REQUIRED CONFIG)
find_package(yaml-cpp REQUIRED)
find_package(assimp REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO>=2.1)

add_library(karat_dependencies INTERFACE)
target_link_libraries(karat_dependencies INTERFACE
  embree TBB::tbb OpenImageIO::OpenImageIO OpenEXR::OpenEXR nlohmann_json::nlohmann_json
  valijson yaml-cpp assimp::assimp CLI11::CLI11 fmt::fmt PkgConfig::OpenColorIO)
