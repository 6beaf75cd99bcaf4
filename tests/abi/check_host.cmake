# A host that takes Carom in with add_subdirectory(): it gets the library in both forms and the plugins, nothing else, and
# can do so with warnings of its own, which are not ours. By day it is configured, one file of each part is compiled in its tree,
# and its program is linked with the library and the archive of this build. By night (ALL) everything is built there. Its objects hold
# what -flto needs beside machine code. They are then merged without making code of them, which takes seconds: two layers that define
# one name differently (the One Definition Rule) fail there.
file(REMOVE_RECURSE ${SCRATCH})
file(WRITE ${SCRATCH}/CMakeLists.txt [[
cmake_minimum_required(VERSION 3.25)
project(host C CXX)
set(CAROM_BUILD_STATIC ON)
add_subdirectory(${CAROM} carom)
add_executable(host host.c)
target_link_libraries(host PRIVATE carom::carom)
add_executable(host_static host.c)
target_link_libraries(host_static PRIVATE carom::carom_static)
set_target_properties(host_static PROPERTIES LINKER_LANGUAGE CXX)
target_compile_definitions(host_static PRIVATE LINKED)
get_property(tests DIRECTORY ${CAROM} PROPERTY TESTS)
if(tests OR TARGET carom_cli OR TARGET python_wheel_test)
  message(FATAL_ERROR "a host gets tests or tools: ${tests}")
endif()
]])
file(WRITE ${SCRATCH}/host.c [[
#include <carom/carom.h>
#include <stdio.h>
int main(void) {
  carom_engine *engine;
  carom_world *world;
  carom_body ball;
  carom_body_desc desc;
  double p[3];
  if (carom_engine_create(NULL, &engine, NULL) || carom_world_create(engine, NULL, &world, NULL)) return 1;
#ifdef LINKED /* an archive has the plugins of plugins/ in it */
  {
    const double half[3] = {0.5, 0.5, 0.5};
    carom_shape box;
    if (carom_plugins_register_standard(engine, NULL) || carom_plugins_register_standard(engine, NULL)) return 7;
    if (carom_shape_create_named(engine, "box", half, 3, &box, NULL)) return 8;
  }
#else
  if (carom_plugins_register_standard(engine, NULL) != CAROM_E_UNSUPPORTED) return 9;
#endif
  carom_body_desc_init(&desc, sizeof desc), desc.position[1] = 10;
  if (carom_body_create(world, &desc, &ball, NULL)) return 2;
  for (int i = 0; i < 60; i++)
    if (carom_world_step(world, 1.0 / 60, NULL)) return 3;
  if (carom_world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &ball, 1, p, 0, NULL)) return 4;
  printf("y = %.3f m\n", p[1]);
  if (carom_world_destroy(world, NULL) || carom_engine_destroy(engine, NULL)) return 5;
  return p[1] > 4.9 && p[1] < 5.2 ? 0 : 6; /* 10 - g/2, and what semi-implicit Euler adds */
}
]])
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
set(odr -Werror=odr -Werror=lto-type-mismatch)
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SCRATCH} -B ${SCRATCH}/build -DCAROM=${SOURCE_DIR} -DCAROM_UNITY=ON
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= "-DCMAKE_CXX_FLAGS=-O0 -flto -ffat-lto-objects"
  -DCMAKE_SHARED_LINKER_FLAGS=-fno-lto -DCMAKE_EXE_LINKER_FLAGS=-fno-lto
  -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_AR=${LTO_AR} -DCMAKE_RANLIB=${LTO_RANLIB})
if(NOT ALL)
  set(objects)
  foreach(part carom_abi.dir/Unity/unity_1 carom_batch.dir/Unity/unity_0 carom_dynamics.dir/Unity/unity_1 carom_collision.dir/Unity/unity_1)
    list(APPEND objects carom/src/CMakeFiles/${part}_cxx.cxx.o)
  endforeach()
  run(${CMAKE_COMMAND} --build ${SCRATCH}/build --target plugin_box ${objects})
  run(${C_COMPILER} -std=c11 -I${SOURCE_DIR}/include ${SCRATCH}/host.c ${LIBRARY} -Wl,-rpath,${LIBRARY_DIR} -o ${SCRATCH}/host)
  run(${SCRATCH}/host)
  run(${C_COMPILER} -std=c11 -I${SOURCE_DIR}/include -DLINKED -c ${SCRATCH}/host.c -o ${SCRATCH}/host_static.o)
  run(${CXX_COMPILER} ${SCRATCH}/host_static.o ${ARCHIVE} -lm -ldl -lpthread -o ${SCRATCH}/host_static)
  run(${SCRATCH}/host_static)
  return()
endif()
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
file(GLOB_RECURSE hosts ${SCRATCH}/build/host ${SCRATCH}/build/host_static)
list(LENGTH hosts count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "not built where it was looked for: ${hosts}")
endif()
foreach(host ${hosts})
  run(${host})
endforeach()
set(objects)
foreach(part carom_abi carom_batch carom_dynamics carom_collision)
  file(GLOB_RECURSE found ${SCRATCH}/build/carom/src/CMakeFiles/${part}.dir/*.o ${SCRATCH}/build/carom/src/CMakeFiles/${part}_seldom.dir/*.o)
  list(LENGTH found count)
  if(count LESS 3)
    message(FATAL_ERROR "no objects of ${part} where they were looked for")
  endif()
  list(APPEND objects ${found})
endforeach()
run(${CXX_COMPILER} -O0 -flto -flinker-output=rel -r ${odr} ${objects} -o ${SCRATCH}/merged.o)
