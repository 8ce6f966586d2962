# What reports consist of besides their numbers is built into the program: they open without a network
# and without an installation. karat_report_source: the source file that holds it.

# D3 5 or newer (Debian's node-d3 is one file for browsers); Debian's libjs-d3 is version 3.
find_file(KARAT_D3 d3.min.js PATHS /usr/share/nodejs/d3/dist /usr/share/javascript/d3
  DOC "D3's browser bundle, version 5 or newer" NO_DEFAULT_PATH)
if(NOT KARAT_D3)
  message(FATAL_ERROR "d3.min.js was not found: install node-d3, or set -D KARAT_D3=FILE.")
endif()
file(STRINGS "${KARAT_D3}" d3_version REGEX "d3js.org v[0-9]+" LIMIT_COUNT 1)
string(REGEX MATCH "v([0-9]+)" d3_version "${d3_version}")
if(CMAKE_MATCH_1 LESS 5)
  message(FATAL_ERROR "${KARAT_D3} is not D3 version 5 or newer: install node-d3.")
endif()

file(GLOB report_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/apps/karat/fresnel/report/*)
list(APPEND report_files "${KARAT_D3}")
list(JOIN report_files "," report_file_list)
set(karat_report_source ${PROJECT_BINARY_DIR}/embedded_files.cpp)
add_custom_command(OUTPUT ${karat_report_source}
  COMMAND ${CMAKE_COMMAND} -D output=${karat_report_source} -D files=${report_file_list}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/embed.cmake
  DEPENDS ${report_files} ${CMAKE_CURRENT_SOURCE_DIR}/cmake/embed.cmake
  COMMENT "Building the report's files into the program" VERBATIM)
