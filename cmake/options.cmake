# karat_options: how everything in this project is compiled.
include(CheckCXXCompilerFlag)

add_library(karat_options INTERFACE)
target_include_directories(karat_options INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(karat_options INTERFACE
  KARAT_LANES=${KARAT_LANES}
  KARAT_VERSION="${PROJECT_VERSION}")

# -fno-math-errno, -fno-trapping-math and -fopenmp-simd let lane loops vectorise and change no value;
# NaN keeps its meaning. -ffp-contract=fast: products and sums may become one fused instruction.
# -fno-semantic-interposition: the same objects also make up the shared library, and a call to a
# neighbouring function stays direct and inlinable nevertheless.
target_compile_options(karat_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow
  -fno-math-errno -fno-trapping-math -fopenmp-simd -ffp-contract=fast
  -fno-semantic-interposition)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Lane loops are marked; elsewhere, vectors that a compiler makes of neighbouring floats (SLP) wait for
# the single stores that made them. GCC also takes a SampledSpectrum that is copied apart into single
# floats, and waits again to load it whole: the parameter keeps aggregates over 32 bytes together.
target_compile_options(karat_options INTERFACE -fno-tree-slp-vectorize
  $<$<CXX_COMPILER_ID:GNU>:--param=sra-max-scalarization-size-Ospeed=32>)

# Flags that name an instruction set exist on x86 only; elsewhere the compiler's own choice stands.
if(KARAT_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|i.86)$")
  set(march ${KARAT_ARCH})
  if(march STREQUAL "portable")
    set(march x86-64-v3)
  endif()
  # The variable's name holds the value, so that another value is checked again.
  string(MAKE_C_IDENTIFIER "KARAT_HAS_MARCH_${march}" supported)
  check_cxx_compiler_flag(-march=${march} ${supported})
  if(NOT ${supported})
    message(FATAL_ERROR "KARAT_ARCH=${KARAT_ARCH}: the compiler does not know -march=${march}. "
      "Allowed: native, portable, a -march value such as x86-64-v4, or empty.")
  endif()
  target_compile_options(karat_options INTERFACE -march=${march})
  # Sixteen floats are one AVX-512 register, but compilers prefer halves of it unless told.
  check_cxx_compiler_flag(-mprefer-vector-width=512 KARAT_HAS_PREFER_VECTOR_WIDTH)
  if(KARAT_HAS_PREFER_VECTOR_WIDTH)
    target_compile_options(karat_options INTERFACE -mprefer-vector-width=512)
  endif()
endif()

if(NOT KARAT_LANES MATCHES "^(4|8|16)$")
  message(FATAL_ERROR "KARAT_LANES=${KARAT_LANES}: allowed are 4, 8 and 16.")
endif()

if(KARAT_SANITIZE)
  list(JOIN KARAT_SANITIZE "," sanitizers)
  target_compile_options(karat_options INTERFACE
    -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(karat_options INTERFACE -fsanitize=${sanitizers})
  # Instrumented code makes GCC see uninitialised values where there are none; Clang cannot vectorise
  # it and would say so at every lane loop.
  target_compile_options(karat_options INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>)
endif()

if(KARAT_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "KARAT_FUZZ needs Clang (libFuzzer): cmake --preset fuzz")
  endif()
  target_compile_options(karat_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
