# Targets s_table_NAME: one cargo build each, one after the other. An engine that can't be built costs no build: what the
# compiler said lies beside the place of its module, and s_table says it.
find_program(CAROM_CARGO cargo HINTS $ENV{HOME}/.cargo/bin)
set(CAROM_CARGO_PEERS rapier rapier64 rapier_threads box3d jolt physx CACHE STRING "Engines of s_table that cargo builds")
foreach(name ${CAROM_CARGO_PEERS})
  set(module ${CMAKE_BINARY_DIR}/cargo/release/libpeer_${name}.so)
  add_custom_target(s_table_${name} ALL USES_TERMINAL VERBATIM
    COMMAND ${CMAKE_COMMAND} -DCARGO=${CAROM_CARGO} -DPACKAGE=peer_${name} -DMODULE=${module}
            -P ${CMAKE_CURRENT_LIST_DIR}/build_peer.cmake
    WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
  list(APPEND cargo_engines s_table_${name})
  list(APPEND cargo_modules "{\"${name}\", \"${module}\"}")
  set_property(GLOBAL APPEND PROPERTY CAROM_CARGO_TARGETS s_table_${name})
  set_property(GLOBAL APPEND PROPERTY CAROM_CARGO_PATHS "\"${module}\"")
endforeach()
