# SPDX-License-Identifier: MIT
# The program that tells what a tree knows, of this tree or of a copy of it in which something is
# planted. Of results, reports and the rasterizer it has only the sources that it asks.
set(sources reference/drawn_keys.cpp reports/text.cpp src/raster/attributes.cpp
            src/raster/vertex_attributes.cpp src/results/json_writer.cpp)
list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/)
add_executable(recipes_probe EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/recipes_probe.cpp ${sources})
target_include_directories(recipes_probe PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_options(recipes_probe PRIVATE -ffunction-sections -fdata-sections)
target_link_options(recipes_probe PRIVATE LINKER:--gc-sections)
target_link_libraries(recipes_probe PRIVATE edgecase_rules edgecase_casefile edgecase_wire
                                            edgecase_options fmt::fmt nlohmann_json::nlohmann_json)
