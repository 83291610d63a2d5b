// SPDX-License-Identifier: MIT
//
// A block: the lines of some neighbouring cases, packed together, since neighbours are alike. What
// one case costs to read is its block.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgecase::recording {

// Lines are JSON values without line breaks. The same lines are the same bytes.
std::string pack_block(const std::vector<std::string>& lines);

// The inverse. Throws std::runtime_error for what pack_block does not make.
std::vector<std::string> unpack_block(std::string_view bytes);

}  // namespace edgecase::recording
