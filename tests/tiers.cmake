# SPDX-License-Identifier: MIT
# Which tests run when, by labels of ctest:
#
#   quick   tools/test: every subject, and one share of each test that asks many scenes
#   all     tools/test --all: everything, whole
#   turn-N  tools/test --turn N/8: an eighth of what is in `all` and not in `quick`
set(EDGECASE_QUICK_SHARE 1/16)
set(EDGECASE_TURNS 8)

# edgecase_add_test(NAME COMMAND word... [SECONDS n [PARTS n] [QUICK_SHARE i/n] [NOT_QUICK]]
#                   [QUICK_SECONDS n] [ENVIRONMENT name=value...] [TIMEOUT seconds] [PROCESSORS n]
#                   [SETS_UP fixture] [FIXTURES fixture...])
#
# Registers the command with ctest. Without SECONDS the test is in both tiers. With SECONDS, which
# is about how long all of it takes on one core, the quick tier has NAME, which asks one share of its
# scenes (EDGECASE_SHARE: tests/support/share.h), unless NOT_QUICK; and the full tier has NAME.1 to
# NAME.PARTS, which together ask all of them. Each of those is in the turn that is the shortest so far.
#
# QUICK_SECONDS is about how long NAME takes in the quick tier, share or not: ctest starts the longest
# first, also where it has not run them yet.
#
# A test that SETS_UP a fixture makes what tests with it among their FIXTURES read: ctest runs it
# before those, whichever of them are chosen, so that it is in no turn. SHARE in the name of a fixture
# stands for the share that a test asks: both need the same PARTS.
function(edgecase_add_test name)
  cmake_parse_arguments(arg "NOT_QUICK"
                        "SECONDS;PARTS;QUICK_SHARE;QUICK_SECONDS;TIMEOUT;PROCESSORS;SETS_UP"
                        "COMMAND;ENVIRONMENT;FIXTURES" ${ARGN})
  if(NOT arg_SECONDS)
    edgecase_add_labelled(${name} "quick;all" "" "${arg_QUICK_SECONDS}")
    return()
  endif()
  if(NOT arg_QUICK_SHARE)
    set(arg_QUICK_SHARE ${EDGECASE_QUICK_SHARE})
  endif()
  if(NOT arg_NOT_QUICK)
    edgecase_add_labelled(${name} quick ${arg_QUICK_SHARE} "${arg_QUICK_SECONDS}")
  endif()
  if(NOT arg_PARTS)
    set(arg_PARTS 1)
  endif()
  math(EXPR seconds "${arg_SECONDS} / ${arg_PARTS}")
  foreach(part RANGE 1 ${arg_PARTS})
    set(labels all)
    if(NOT arg_SETS_UP)
      edgecase_take_turn(turn ${seconds})
      list(APPEND labels turn-${turn})
    endif()
    edgecase_add_labelled(${name}.${part} "${labels}" ${part}/${arg_PARTS} ${seconds})
  endforeach()
endfunction()

# For edgecase_add_test alone, whose arguments it reads.
function(edgecase_add_labelled name labels share cost)
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  if(share)
    list(APPEND arg_ENVIRONMENT EDGECASE_SHARE=${share})
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" ENVIRONMENT "${arg_ENVIRONMENT}")
  if(cost)
    set_tests_properties(${name} PROPERTIES COST ${cost})
  endif()
  foreach(property TIMEOUT PROCESSORS)
    if(arg_${property})
      set_tests_properties(${name} PROPERTIES ${property} ${arg_${property}})
    endif()
  endforeach()
  string(REPLACE SHARE "${share}" sets_up "${arg_SETS_UP}")
  string(REPLACE SHARE "${share}" fixtures "${arg_FIXTURES}")
  set_tests_properties(${name} PROPERTIES FIXTURES_SETUP "${sets_up}"
                                          FIXTURES_REQUIRED "${fixtures}")
endfunction()

# Sets `result` to the turn with the fewest seconds so far, and adds `seconds` to it.
function(edgecase_take_turn result seconds)
  set(shortest 1)
  foreach(turn RANGE 1 ${EDGECASE_TURNS})
    get_property(load_${turn} GLOBAL PROPERTY edgecase_turn_${turn})
    if(NOT load_${turn})
      set(load_${turn} 0)
    endif()
    if(load_${turn} LESS load_${shortest})
      set(shortest ${turn})
    endif()
  endforeach()
  math(EXPR load "${load_${shortest}} + ${seconds}")
  set_property(GLOBAL PROPERTY edgecase_turn_${shortest} ${load})
  set(${result} ${shortest} PARENT_SCOPE)
endfunction()
