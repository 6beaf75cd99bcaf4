# Every path that a README or ABI.md names in backticks exists.
set(checked 0)
file(GLOB_RECURSE pages ${SOURCE_DIR}/src/*.md ${SOURCE_DIR}/plugins/*.md ${SOURCE_DIR}/tests/*.md ${SOURCE_DIR}/bindings/*.md
  ${SOURCE_DIR}/include/*.md)
list(FILTER pages EXCLUDE REGEX "/(node_modules|dist)/")  # what npm and the build of the page put there
foreach(page ${SOURCE_DIR}/README.md ${SOURCE_DIR}/ABI.md ${SOURCE_DIR}/CONTRIBUTING.md ${SOURCE_DIR}/SECURITY.md ${pages})
  if(NOT EXISTS ${page})
    message(SEND_ERROR "${page} is missing")
    continue()
  endif()
  file(READ ${page} text)
  string(REGEX REPLACE "```[^`]*```" "" text "${text}")  # code blocks are commands and examples
  string(REPLACE ";" "," text "${text}")
  string(REGEX MATCHALL "`[^`\n]+`" spans "${text}")
  get_filename_component(folder ${page} DIRECTORY)
  foreach(span ${spans})
    string(REGEX REPLACE "`" "" span "${span}")
    # A path of ours: starts with a folder of the top level, or is a file name with an extension of ours and a slash.
    if(NOT span MATCHES "^(src|include|plugins|tests|bindings|docs)/[A-Za-z0-9_./*-]*$" AND
       NOT span MATCHES "^[A-Za-z0-9_/-]+\\.(md|cpp|cmake)$" AND NOT span MATCHES "^\\.ci/[a-z]+$")
      continue()
    endif()
    if(span MATCHES "NAME")  # a placeholder
      continue()
    endif()
    string(REGEX REPLACE "/$" "" span "${span}")
    math(EXPR checked "${checked} + 1")
    file(GLOB here ${SOURCE_DIR}/${span} ${folder}/${span})
    if(NOT here)
      message(SEND_ERROR "${page} names `${span}`, which does not exist")
    endif()
  endforeach()
endforeach()
if(checked LESS 5)
  message(FATAL_ERROR "only ${checked} paths were found: the pattern of this check no longer fits the pages")
endif()
message(STATUS "${checked} paths")
