# A library of stubs made of headers: the same symbols, nodes and types as the real one, and nothing behind them.

# What clients are linked with: libcarom.so. and the major version, before 1.0 the minor version as well.
file(STRINGS ${SOURCE_DIR}/include/carom/base.h soname REGEX "^#define CAROM_VERSION_(MAJOR|MINOR)")
list(TRANSFORM soname REPLACE "[^0-9]" "")
list(JOIN soname "." soname)
string(REGEX REPLACE "^([1-9][0-9]*)\\..*" "\\1" soname "${soname}")
set(soname libcarom.so.${soname})

# build_stub(HEADERS MAP OUT): OUT/${soname} from the headers HEADERS/carom/*.h and the version script MAP.
# More arguments go to the compiler, in place of the flags by which the real library is bound at load if there are any.
function(build_stub headers map out)
  file(REMOVE_RECURSE ${out})
  file(GLOB names RELATIVE ${headers}/carom ${headers}/carom/*.h)
  foreach(name ${names})
    file(READ ${headers}/carom/${name} text)
    string(REGEX REPLACE "\nCAROM_API ([^;]*)\\);" "\nCAROM_API \\1) { return 0; }" text "${text}")
    file(WRITE ${out}/carom/${name} "${text}")
  endforeach()
  file(WRITE ${out}/stub.c "#include <carom/carom.h>\n")
  set(extra ${ARGN})
  if(NOT extra)
    set(extra -Wl,-z,now)
  endif()
  execute_process(COMMAND ${C_COMPILER} -std=c11 -w -g -O0 -fPIC -shared -fvisibility=hidden -I${out} ${out}/stub.c
    -o ${out}/${soname} -Wl,-soname,${soname} -Wl,--version-script=${map} ${extra}
    RESULT_VARIABLE result ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "no stubs of ${headers}:\n${output}")
  endif()
endfunction()
