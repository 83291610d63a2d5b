# SPDX-License-Identifier: MIT
# Where EDGECASE_UNITY is on, several sources are compiled as one: what is built once and as a whole
# is built in half the time. Whoever edits builds one source at a time, as the preset `dev` does.
option(EDGECASE_UNITY "Compile several sources as one: faster as a whole, slower after an edit" OFF)

# edgecase_sources(RESULT TARGET source...) sets RESULT to what TARGET is to be made of.
function(edgecase_sources result target)
  if(NOT EDGECASE_UNITY)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(together)
  set(alone)
  foreach(source IN LISTS ARGN)
    # What is generated is not there yet.
    if(IS_ABSOLUTE ${source})
      list(APPEND alone ${source})
    else()
      list(APPEND together ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    endif()
  endforeach()
  execute_process(
    COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/tools/unity.py
            ${CMAKE_CURRENT_BINARY_DIR}/${target} ${together}
    OUTPUT_VARIABLE files
    OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" files "${files}")
  set(${result} ${files} ${alone} PARENT_SCOPE)
endfunction()
