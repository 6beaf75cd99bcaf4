# Install to a fresh prefix, then build and run a C client by find_package and by pkg-config, as a stranger would.
file(REMOVE_RECURSE ${SCRATCH})
set(prefix ${SCRATCH}/prefix)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

foreach(piece src plugins)  # what a client uses; the tools need not be built for this check
  run(${CMAKE_COMMAND} --install ${BINARY_DIR}/${piece} --prefix ${prefix})
endforeach()
set(client ${SOURCE_DIR}/tests/abi/client)
# A bare machine may have no make: what builds us builds the client.
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${client} -B ${SCRATCH}/by_cmake -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_C_COMPILER=${C_COMPILER})
run(${CMAKE_COMMAND} --build ${SCRATCH}/by_cmake)
run(${SCRATCH}/by_cmake/hello)

# What a package of it needs beside: the licence and the pages, whose links hold.
foreach(page LICENSE README.md CHANGELOG.md ABI.md include/README.md include/pages/index.md src/tools/report/gallery/seesaw.svg)
  if(NOT EXISTS ${prefix}/share/doc/carom/${page})
    message(FATAL_ERROR "share/doc/carom/${page} is not installed")
  endif()
endforeach()
# The archive, by find_package and by pkg-config: a program in one file, of a compiler of C++, since the library is.
file(GLOB_RECURSE archive ${prefix}/*/libcarom.a)
if(archive)
  file(WRITE ${SCRATCH}/one_file/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(one_file LANGUAGES C CXX)\n"
    "find_package(carom 0.9 REQUIRED)\nadd_executable(one_file one_file.c)\ntarget_link_libraries(one_file PRIVATE carom::carom_static)\n")
  file(WRITE ${SCRATCH}/one_file/one_file.c [[
#include <carom/carom.h>
#include <stddef.h>
int main(void) {
  carom_engine *engine = NULL;
  carom_shape shape = 0;
  const double radius = 0.5;
  if (carom_engine_create(NULL, &engine, NULL) || carom_plugins_register_standard(engine, NULL)) return 1;
  return carom_shape_create_named(engine, "sphere", &radius, 1, &shape, NULL) || carom_engine_destroy(engine, NULL);
}
]])
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SCRATCH}/one_file -B ${SCRATCH}/one_file/build -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_C_COMPILER=${C_COMPILER})
  run(${CMAKE_COMMAND} --build ${SCRATCH}/one_file/build)
  run(${SCRATCH}/one_file/build/one_file)
endif()

find_program(pkg_config pkg-config)
if(NOT pkg_config)
  message(FATAL_ERROR "pkg-config is not installed (Debian: pkg-config)")
endif()
file(GLOB_RECURSE pc ${prefix}/*/carom.pc)
get_filename_component(pc_dir ${pc} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
execute_process(COMMAND ${pkg_config} --cflags --libs carom OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE result)
execute_process(COMMAND ${pkg_config} --variable=plugindir carom OUTPUT_VARIABLE plugins OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(COMMAND ${pkg_config} --variable=libdir carom OUTPUT_VARIABLE libdir OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "pkg-config does not find carom")
endif()
separate_arguments(flags)
run(${C_COMPILER} ${client}/hello.c -DCAROM_PLUGIN_DIR="${plugins}" ${flags} -Wl,-rpath,${libdir} -o ${SCRATCH}/by_pkg_config)
run(${SCRATCH}/by_pkg_config)

# README's hello as README says to build it: it finds its shape by name, where the library is installed.
file(READ ${SOURCE_DIR}/README.md readme)
string(FIND "${readme}" "```c\n" begin)
math(EXPR begin "${begin} + 5")
string(SUBSTRING "${readme}" ${begin} -1 readme)
string(FIND "${readme}" "\n```" end)
string(SUBSTRING "${readme}" 0 ${end} program)
file(WRITE ${SCRATCH}/readme_hello.c "${program}\n")
run(${C_COMPILER} ${SCRATCH}/readme_hello.c ${flags} -o ${SCRATCH}/readme_hello)
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libdir} ${SCRATCH}/readme_hello)

# plugins/README.md's line makes a shape of the template, as typed, and it is found by the name of its file.
file(READ ${SOURCE_DIR}/plugins/README.md readme)
string(REGEX MATCH "\ncc -shared[^\n]*" line "${readme}")
if(NOT line)
  message(FATAL_ERROR "plugins/README.md has no line that begins with cc -shared")
endif()
file(COPY ${SOURCE_DIR}/plugins/template/template.c DESTINATION ${SCRATCH}/shape)
execute_process(COMMAND sh -c "${line}" WORKING_DIRECTORY ${SCRATCH}/shape RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "failed as typed:${line}")
endif()
file(WRITE ${SCRATCH}/shape/client.c [[
#include <carom/carom.h>
#include <stdio.h>
int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine *engine = NULL;
  carom_shape shape[2] = {0, 0};
  const double top[2] = {0.35, 0.4}, larger[2] = {0.7, 0.8};
  int32_t r = carom_engine_create(NULL, &engine, &e);
  if (r == CAROM_OK) r = carom_shape_create_named(engine, "top", top, 2, &shape[0], &e);
  if (r == CAROM_OK) r = carom_shape_create_named(engine, "top", larger, 2, &shape[1], &e);
  if (r != CAROM_OK) fprintf(stderr, "%s. %s\n", e.message, e.remedy);
  return r != CAROM_OK || shape[0] == shape[1];
}
]])
run(${C_COMPILER} ${SCRATCH}/shape/client.c ${flags} -o ${SCRATCH}/shape/client)
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libdir} CAROM_PLUGIN_PATH=${SCRATCH}/shape ${SCRATCH}/shape/client)
