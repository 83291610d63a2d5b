# SPDX-License-Identifier: MIT
# What tools/mutate adds to a project of which it builds a mutated copy: CMake includes this file at
# the end of project(), see CMAKE_PROJECT_INCLUDE.

# The switches come first in every translation unit. Warnings are about originals, not about this.
add_compile_options(-O1 -w -include ${CMAKE_CURRENT_LIST_DIR}/switches.h)
# An index beyond the end ends the program, whatever lies in memory there.
add_compile_definitions(_GLIBCXX_ASSERTIONS)

# It is built once and as a whole.
set(EDGECASE_UNITY ON)

# What links the recorder is of no use elsewhere.
set(EDGECASE_INSTALL OFF)

add_library(mutation_recorder STATIC ${CMAKE_CURRENT_LIST_DIR}/recorder.cpp)
target_include_directories(mutation_recorder PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../..)
set_target_properties(mutation_recorder PROPERTIES CXX_STANDARD 20 POSITION_INDEPENDENT_CODE ON)
link_libraries(mutation_recorder)
