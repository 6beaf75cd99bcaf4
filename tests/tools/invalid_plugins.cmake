# Plugins for `carom check` to judge: the same ball with one lie each, and one valid.
set(carom_judged "")
set(carom_judged_dir ${CMAKE_BINARY_DIR}/judged)
foreach(lie VALID HANG CRASH ABORT EXIT JUMP NAN DENT LENGTH MEMORY DECLARATION RULES)
  string(TOLOWER ${lie} name)
  add_library(judged_${name} MODULE ${CMAKE_CURRENT_LIST_DIR}/invalid_plugins/invalid_plugins.c)
  target_include_directories(judged_${name} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(judged_${name} PRIVATE LIE_${lie})
  target_link_libraries(judged_${name} PRIVATE carom_flags m)
  set_target_properties(judged_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY
    ${carom_judged_dir})
  list(APPEND carom_judged judged_${name})
endforeach()
# The same as C++, which can throw.
add_library(judged_throw MODULE ${CMAKE_CURRENT_LIST_DIR}/invalid_plugins/throws.cpp)
target_link_libraries(judged_throw PRIVATE carom_flags)
target_include_directories(judged_throw PRIVATE ${PROJECT_SOURCE_DIR}/include)
set_target_properties(judged_throw PROPERTIES PREFIX "" OUTPUT_NAME throw LIBRARY_OUTPUT_DIRECTORY
  ${carom_judged_dir})
list(APPEND carom_judged judged_throw)
