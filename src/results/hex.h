// SPDX-License-Identifier: MIT
//
// Bytes as lower-case hexadecimal digits, two for each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace edgecase {

std::string to_hex(const std::vector<std::uint8_t>& bytes);
void append_hex(const std::vector<std::uint8_t>& bytes, std::string& text);

// The inverse. Throws std::runtime_error where `text` is anything else.
std::vector<std::uint8_t> from_hex(const std::string& text);

}  // namespace edgecase
