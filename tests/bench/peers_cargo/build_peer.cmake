# Builds PACKAGE by CARGO into MODULE, or writes MODULE.reason.
file(REMOVE ${MODULE}.reason)
if(CARGO)
  get_filename_component(folder ${MODULE} DIRECTORY)
  get_filename_component(folder ${folder} DIRECTORY)
  # All crates of the workspace first: a shim asks cargo, without the network, where the sources of its engine are.
  execute_process(COMMAND ${CARGO} fetch ERROR_VARIABLE told)
  execute_process(COMMAND ${CARGO} build --release --target-dir ${folder} -p ${PACKAGE}
    RESULT_VARIABLE failed ERROR_VARIABLE told ECHO_ERROR_VARIABLE)
  string(REGEX MATCH "error[^\n]*" reason "${told}")
else()
  set(failed TRUE)
  set(reason "there was no cargo when CMake ran")
endif()
if(failed)
  file(REMOVE ${MODULE})
  file(WRITE ${MODULE}.reason "${reason}\n")
  message(WARNING "${PACKAGE} is not built: ${reason}")
endif()
