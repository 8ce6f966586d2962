# Compiles through ccache where it is installed. Precompiled headers need the sloppiness below, or
# ccache never finds a result again; relative to the base folder, checkouts share results.
find_program(KARAT_CCACHE ccache DOC "ccache, used where it is found")
mark_as_advanced(KARAT_CCACHE)
if(KARAT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${KARAT_CCACHE})
endif()
