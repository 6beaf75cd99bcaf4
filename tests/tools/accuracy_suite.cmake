# Accuracy scenes: each at a new world's dials errs as src/tools/accuracy/ERRORS.md records, or less.
if(NOT CAROM_SANITIZE)
  add_test(NAME tools/accuracy_errors COMMAND ${CAROM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/bench/accuracy_errors $<TARGET_FILE:carom_cli>)
  set_tests_properties(tools/accuracy_errors PROPERTIES LABELS tools TIMEOUT 900)
endif()
# Bounds of flight are those of the preset `accurate`, at 1/240 s. A second for all: these run always.
foreach(scene freefall drag gzbox top dzhanibekov heavytop)
  add_test(NAME tools/accurate_${scene} COMMAND carom_cli accuracy run ${scene} --preset accurate --dt 1/240)
  set_tests_properties(tools/accurate_${scene} PROPERTIES LABELS tools)
endforeach()
# What the page on choosing says of presets is what the library says.
add_test(NAME tools/choosing COMMAND ${CAROM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/bench/choosing $<TARGET_FILE:carom_cli> --check)
set_tests_properties(tools/choosing PROPERTIES LABELS tools)
