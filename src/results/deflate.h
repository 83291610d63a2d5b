// SPDX-License-Identifier: MIT
//
// Bytes in fewer bytes (zlib, RFC 1950: deflated, with a checksum at the end).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// Throws std::runtime_error if memory runs out.
std::vector<std::uint8_t> deflated(std::string_view text);

// Much longer than any text of ours, such as a picture of the largest target. Without a limit a
// file of some megabytes could take all memory.
constexpr std::size_t kMostInflated = std::size_t{1} << 30;

// The inverse. Throws std::runtime_error for bytes that are damaged, or deflated from more than
// `most` bytes.
std::string inflated(const std::vector<std::uint8_t>& bytes, std::size_t most = kMostInflated);

}  // namespace edgecase
