# A host in LuaJIT builds the scene of scene.c and gets its bits: nothing at this boundary is Python's or C's alone.
set(ENV{LUA_PATH} "${SOURCE_DIR}/bindings/lua/?.lua")
execute_process(COMMAND ${SCENE} ${PLUGIN_DIR} OUTPUT_VARIABLE of_c RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT of_c MATCHES "^[0-9a-f]+\n[0-9a-f]+\n[0-9a-f]+\n$")
  message(FATAL_ERROR "the C scene failed: ${result}\n${of_c}")
endif()
execute_process(COMMAND ${LUAJIT} ${SOURCE_DIR}/tests/bindings/scene.lua ${LIBRARY} ${PLUGIN_DIR}
  OUTPUT_VARIABLE of_lua RESULT_VARIABLE result ERROR_VARIABLE error)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "scene.lua: ${error}")
endif()
if(NOT of_lua STREQUAL of_c)
  message(FATAL_ERROR "LuaJIT got\n${of_lua}C got\n${of_c}")
endif()
