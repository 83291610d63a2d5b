// SPDX-License-Identifier: MIT
//
// Deflate: what is long, made short (RFC 1950: deflated, with a checksum at its end).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// Throws std::runtime_error where there is no memory.
std::vector<std::uint8_t> deflated(std::string_view text);

// The longest text that a value of ours is deflated from, a picture of the largest target say, is a
// small part of it. A file of some megabytes could otherwise ask for all memory.
constexpr std::size_t kMostInflated = std::size_t{1} << 30;

// The inverse. Throws std::runtime_error for bytes that are damaged, or deflated from more than
// `most` bytes.
std::string inflated(const std::vector<std::uint8_t>& bytes, std::size_t most = kMostInflated);

}  // namespace edgecase
