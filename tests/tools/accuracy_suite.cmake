# Accuracy scenes: each at a new world's dials errs as src/tools/accuracy/ERRORS.md records, or less.
if(NOT CAROM_SANITIZE)
  add_test(NAME tools/accuracy_errors COMMAND ${CAROM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/bench/accuracy_errors $<TARGET_FILE:carom_cli>)
  set_tests_properties(tools/accuracy_errors PROPERTIES LABELS tools TIMEOUT 900 COST 150)
  # Presets that another setting dominates: a slice of scenes; all of them: tests/bench/preset_fronts on a sweep.
  add_test(NAME tools/preset_fronts COMMAND ${CAROM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/bench/preset_fronts --run $<TARGET_FILE:carom_cli>)
  set_tests_properties(tools/preset_fronts PROPERTIES LABELS tools TIMEOUT 300 COST 50)
  # What was found to fall at other sizes, loads and steps than the suite's, and sizes that the mends were not made on.
  foreach(of "bridge planks=60 ratio=1000 1/80" "bridge planks=50 ratio=200 1/60" "bridge planks=35 ratio=500 1/100" "kapla layers=27 ratio=1 1/80"
          "kapla layers=50 ratio=1 1/50" "kapla layers=34 ratio=1 1/60")
    string(REPLACE " " ";" of ${of})
    list(GET of 0 scene)
    list(GET of 1 size)
    list(GET of 2 ratio)
    list(GET of 3 dt)
    set(sets --set ${size})
    if(scene STREQUAL bridge)
      list(APPEND sets --set ${ratio})
    endif()
    string(REPLACE "=" "_" name ${scene}_${size})
    add_test(NAME tools/stands_${name} COMMAND carom_cli accuracy run ${scene} ${sets} --dt ${dt} --seconds 30)
    set_tests_properties(tools/stands_${name} PROPERTIES LABELS tools TIMEOUT 900 COST 50)
  endforeach()
endif()
# Bounds of flight are those of the preset `accurate`, at 1/240 s. A second for all: these run always.
foreach(scene freefall drag gzbox top dzhanibekov heavytop)
  add_test(NAME tools/accurate_${scene} COMMAND carom_cli accuracy run ${scene} --preset accurate --dt 1/240)
  set_tests_properties(tools/accurate_${scene} PROPERTIES LABELS tools)
endforeach()
# What the page on choosing says of presets is what the library says.
add_test(NAME tools/choosing COMMAND ${CAROM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/bench/choosing $<TARGET_FILE:carom_cli> --check)
set_tests_properties(tools/choosing PROPERTIES LABELS tools)
