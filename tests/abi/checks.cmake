# Checks of the boundary that run tools instead of code: compilers on each header, nm and readelf on the library, greps.
function(carom_script_test name)
  add_test(NAME abi/${name} COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DBINARY_DIR=${CMAKE_BINARY_DIR}
    -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/${name} ${ARGN} -P ${CMAKE_CURRENT_SOURCE_DIR}/abi/check_${name}.cmake)
  set_tests_properties(abi/${name} PROPERTIES TIMEOUT ${carom_timeout} LABELS abi)
endfunction()

if(NOT CAROM_SANITIZE)  # headers are headers
  carom_script_test(headers)
endif()
# What bindings/gen writes from the headers is as committed.
if(NOT CAROM_PYTHON)
  message(FATAL_ERROR "the tests need python3 (Debian: python3)")
endif()
add_test(NAME abi/api_fresh COMMAND ${CAROM_PYTHON} ${PROJECT_SOURCE_DIR}/bindings/gen/generate --check)
add_test(NAME abi/api_reader COMMAND ${CAROM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/bindings/test_reader.py -q)
add_test(NAME abi/circles COMMAND ${CAROM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/abi/check_circles.py ${PROJECT_SOURCE_DIR}/src)
add_test(NAME abi/parts COMMAND ${CAROM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/abi/check_parts.py ${PROJECT_SOURCE_DIR}/src)
add_test(NAME abi/api_signatures COMMAND ${CAROM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/bindings/check_signatures.py
  ${PROJECT_SOURCE_DIR} ${CMAKE_C_COMPILER} $<TARGET_FILE:carom>)
add_test(NAME abi/versions COMMAND ${CAROM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/abi/check_versions.py ${PROJECT_SOURCE_DIR})
set_tests_properties(abi/api_fresh abi/api_reader abi/api_signatures abi/circles abi/parts abi/versions PROPERTIES TIMEOUT 60 LABELS abi)
# What computes in a step, and what stands on it: its bits are of no C library.
get_property(objects GLOBAL PROPERTY carom_objects)
get_property(shape_plugins DIRECTORY ${PROJECT_SOURCE_DIR}/plugins PROPERTY BUILDSYSTEM_TARGETS)
list(FILTER shape_plugins INCLUDE REGEX "^plugin_")
list(TRANSFORM shape_plugins REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
add_test(NAME abi/libm COMMAND ${CAROM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/abi/check_libm.py ${CMAKE_NM} ${CMAKE_C_COMPILER}
  ${CMAKE_CURRENT_BINARY_DIR}/libm ${objects} ${shape_plugins} COMMAND_EXPAND_LISTS)
set_tests_properties(abi/libm PROPERTIES TIMEOUT 60 LABELS abi)
carom_script_test(symbols -DLIBRARY=$<TARGET_FILE:carom> -DSANITIZE=${CAROM_SANITIZE})
carom_script_test(arrows)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CAROM_SANITIZE)  # stubs are stubs, sanitized or not: gate/README.md
  carom_script_test(gate -DLIBRARY=$<TARGET_FILE:carom> -DC_COMPILER=${CMAKE_C_COMPILER})
  carom_script_test(gate_mutants -DC_COMPILER=${CMAKE_C_COMPILER})
  carom_script_test(old_library -DC_COMPILER=${CMAKE_C_COMPILER})
  add_custom_target(freeze_abi COMMAND ${CMAKE_COMMAND} -DFREEZE=ON -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
    -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/gate -DC_COMPILER=${CMAKE_C_COMPILER}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/abi/check_gate.cmake VERBATIM)
endif()

# Clients of every version so far, with the declarations of their time: they see nothing of include/.
file(GLOB kept_clients CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/abi/client/v[0-9]*.c)
foreach(source ${kept_clients})
  get_filename_component(name ${source} NAME_WE)
  add_executable(client_${name} ${source})
  target_link_libraries(client_${name} PRIVATE carom_flags $<TARGET_FILE:carom> m)
  set_target_properties(client_${name} PROPERTIES BUILD_RPATH $<TARGET_FILE_DIR:carom>)
  add_dependencies(client_${name} carom)
  add_test(NAME abi/client_${name} COMMAND client_${name})
  set_tests_properties(abi/client_${name} PROPERTIES TIMEOUT 300 LABELS abi)
endforeach()
if(EXISTS ${PROJECT_SOURCE_DIR}/README.md)
  carom_script_test(readme_paths)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CAROM_SANITIZE)  # sanitizers add symbols of their own
  carom_script_test(kernels "-DOBJECTS=$<TARGET_OBJECTS:carom_dynamics>")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CAROM_SANITIZE AND CAROM_BUILD_STATIC)
  carom_script_test(host -DALL=${CAROM_LONG_TESTS} -DLIBRARY=$<TARGET_FILE:carom> -DLIBRARY_DIR=$<TARGET_FILE_DIR:carom>
    -DARCHIVE=$<TARGET_FILE:carom_static> -DC_COMPILER=${CMAKE_C_COMPILER} -DCXX_COMPILER=${CMAKE_CXX_COMPILER} -DGENERATOR=${CMAKE_GENERATOR}
    -DLTO_AR=${CMAKE_CXX_COMPILER_AR} -DLTO_RANLIB=${CMAKE_CXX_COMPILER_RANLIB})
endif()
if(NOT CAROM_SANITIZE)  # a client without the sanitizer cannot load a library with it
  carom_script_test(install -DC_COMPILER=${CMAKE_C_COMPILER} -DGENERATOR=${CMAKE_GENERATOR})
endif()

# Plugins that lie, one a file, for what only a shared object can lie about; the rest are in test_plugins.c.
file(GLOB invalid_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/abi/invalid_plugins/*.c)
set(invalid_targets)
foreach(source ${invalid_sources})
  get_filename_component(name ${source} NAME_WE)
  add_library(invalid_${name} MODULE ${source})
  target_include_directories(invalid_${name} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(invalid_${name} PRIVATE carom_flags m)
  set_target_properties(invalid_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/invalid_plugins)
  list(APPEND invalid_targets invalid_${name})
endforeach()
# A copy under another name, for a test that shows what loading it by hand does.
add_library(invalid_flush_to_zero_too MODULE ${CMAKE_CURRENT_SOURCE_DIR}/abi/invalid_plugins/flush_to_zero.c)
target_include_directories(invalid_flush_to_zero_too PRIVATE ${PROJECT_SOURCE_DIR}/include)
target_link_libraries(invalid_flush_to_zero_too PRIVATE carom_flags m)
set_target_properties(invalid_flush_to_zero_too PROPERTIES PREFIX "" OUTPUT_NAME flush_to_zero_too
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/invalid_plugins)
list(APPEND invalid_targets invalid_flush_to_zero_too)
set(carom_invalid_plugins ${invalid_targets})
set(carom_invalid_dir ${CMAKE_CURRENT_BINARY_DIR}/invalid_plugins)
