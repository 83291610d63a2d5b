// SPDX-License-Identifier: MIT
//
// The library of its own that holds OpenImageIO. Loading it costs 200 ms and 128 MiB that most
// commands have no use for, so it is opened when the first file is read or written.
#pragma once

#include <string>

namespace edgecase {

// A function of the library beside the running program, or null with `error` set. The library stays
// open.
void* find_image_function(const char* symbol, std::string& error);

}  // namespace edgecase
