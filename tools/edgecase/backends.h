// SPDX-License-Identifier: MIT
//
// `edgecase backends`: what each renderer really offers, found out by rendering.
#pragma once

#include <string>
#include <vector>

namespace edgecase {

// Probes the renderers of these names (none: the OpenGL ones) and prints a table to standard
// output. `program_directory` holds the worker program, see run/renderer_names.h. Returns the exit
// code: 0; 2 when a name is no renderer; 4 when a named renderer is unavailable, or none works.
int run_backends(const std::vector<std::string>& names, const std::string& program_directory);

}  // namespace edgecase
