# SPDX-License-Identifier: MIT
# Where EDGECASE_UNITY is on, several sources are compiled as one, upon precompiled headers: what is
# built once and as a whole is built in half the time. Whoever edits builds one source at a
# time, as the preset `dev` does, which also shows a missing include.
#
# CMake's own UNITY_BUILD puts sources together whatever they hold. Ours give the same name to many a
# helper in a namespace without a name: tools/unity.py keeps such sources apart.
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

# edgecase_headers(KIND [PROGRAMS] LIBRARIES target... OPTIONS option... HEADERS file...) precompiles
# headers of other projects for all libraries, or all programs, that are compiled with these options.
function(edgecase_headers kind)
  if(NOT EDGECASE_UNITY)
    return()
  endif()
  cmake_parse_arguments(arg "PROGRAMS" "" "LIBRARIES;OPTIONS;HEADERS" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_${kind}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// What a library has to have: one source.\n")
  add_library(edgecase_headers_${kind} OBJECT ${source})
  if(arg_PROGRAMS)
    set_target_properties(edgecase_headers_${kind} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    list(APPEND arg_OPTIONS -fPIE)
  endif()
  target_compile_options(edgecase_headers_${kind} PRIVATE ${arg_OPTIONS})
  target_link_libraries(edgecase_headers_${kind} PRIVATE ${arg_LIBRARIES} edgecase_options)
  target_precompile_headers(edgecase_headers_${kind} PRIVATE ${arg_HEADERS})
endfunction()

# Compiles a target upon the precompiled headers of a kind.
function(edgecase_precompiled target kind)
  if(EDGECASE_UNITY)
    target_precompile_headers(${target} REUSE_FROM edgecase_headers_${kind})
    # Behind a precompiled header g++ 12 forgets which lines are the system's, and tells what it does
    # not tell of them elsewhere.
    target_compile_options(${target} PRIVATE
      "$<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>"
      # g++ 14 and 16 see faults in their own vector and optional.
      "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,14>>:-Wno-maybe-uninitialized>")
  endif()
endfunction()
