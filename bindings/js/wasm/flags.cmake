# What every target is compiled with for WebAssembly: 128-bit registers, exceptions of the machine (not of JavaScript).
option(CAROM_WASM_SIMD "Use WebAssembly's 128-bit registers: same bits, faster" ON)
# clang 14 turns a scalar that is loaded and spread over a register into one load, and moves that behind stores to the
# same place:
# `v = m * v` then reads what it has just written. Its vectorisers make such code of ours; core/wide.h hides its own
# spreads.
#
# For size, but small functions are inlined and small loops unrolled as at -O2: NOTES.md has figures. emscripten inlines
# nothing at -Os unless INLINING_LIMIT is 0. What runs seldom is for size alone: the boundary, many worlds, characters and
# vehicles, and what src/CMakeLists.txt lists. A step of the rest is slow at -Oz.
set(CAROM_WASM_OPTIMISE -Os CACHE STRING "How the module is optimised: -Os, or -O2; -Oz is slow")
set(CAROM_WASM_SELDOM "-Oz -mllvm -inline-threshold=50" CACHE STRING "How what runs seldom is optimised")
target_compile_options(carom_flags INTERFACE -fwasm-exceptions ${CAROM_WASM_OPTIMISE} -sINLINING_LIMIT=0
  "SHELL:-mllvm -inline-threshold=225" "SHELL:-mllvm -unroll-threshold=150"
  "SHELL:-mllvm -unroll-runtime=false" "SHELL:-mllvm -unroll-allow-partial=false"
  $<$<BOOL:${CAROM_WASM_SIMD}>:-msimd128> -fno-slp-vectorize -fno-vectorize
  "$<$<OR:$<IN_LIST:$<TARGET_PROPERTY:NAME>,carom_abi$<SEMICOLON>carom_batch$<SEMICOLON>carom_kit>,$<BOOL:$<TARGET_PROPERTY:CAROM_SELDOM>>>:SHELL:${CAROM_WASM_SELDOM}>")
target_link_options(carom_flags INTERFACE -fwasm-exceptions)
target_compile_definitions(carom_flags INTERFACE CAROM_FEW_COPIES)  # core/wide.h: kernels share their parts
# Preset wasm-threads: memory that workers share, and atomic instructions. CMakeLists.txt links the
# module of it.
option(CAROM_WASM_THREADS "Steps on several threads, where memory can be shared" OFF)
if(CAROM_WASM_THREADS)
  target_compile_options(carom_flags INTERFACE -pthread)
endif()

# The engine needs C++20's library: libc++ 15 or later. An emscripten that brings an older one (Debian's 3.1.6 has 13)
# is given
# the headers of Debian's libc++-16-dev; what those expect in a compiled library and is not in the older one, libcxx/
# adds.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS "-std=c++20")
check_cxx_source_compiles("#include <algorithm>\n#include <memory_resource>\n#include <vector>\n
  int main() { std::pmr::vector<int> v; std::ranges::sort(v); return int(v.size()); }" CAROM_WASM_OWN_LIBCXX)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT CAROM_WASM_OWN_LIBCXX)
  set(CAROM_LIBCXX_HEADERS /usr/lib/llvm-16/include/c++/v1 CACHE PATH "Headers of libc++ 16")
  if(NOT EXISTS ${CAROM_LIBCXX_HEADERS}/memory_resource)
    message(FATAL_ERROR "This emscripten's C++ library is too old, and ${CAROM_LIBCXX_HEADERS} has none. Install Debian's "
      "libc++-16-dev, set CAROM_LIBCXX_HEADERS to libc++ 16's headers, or use a newer emscripten.")
  endif()
  target_compile_options(carom_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-nostdinc++>
    "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-isystem ${CMAKE_CURRENT_LIST_DIR}/libcxx -isystem ${CAROM_LIBCXX_HEADERS}>")
  set(CAROM_WASM_LIBCXX_SUPPLEMENT ${CMAKE_CURRENT_LIST_DIR}/libcxx/supplement.cpp)
endif()
