// SPDX-License-Identifier: MIT
//
// Deflate: what is long, made short (RFC 1950: deflated, with a checksum at its end).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// Throws std::runtime_error where there is no memory.
std::vector<std::uint8_t> deflated(std::string_view text);

// The inverse. Throws std::runtime_error for bytes that are damaged.
std::string inflated(const std::vector<std::uint8_t>& bytes);

}  // namespace edgecase
