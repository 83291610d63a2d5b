// SPDX-License-Identifier: MIT
//
// Sizes and deflated stretches of bytes, and their checksums. Readers take what they read away from
// the front, and throw std::runtime_error where that is not what the writers write.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace edgecase::recording {

// Seven bits to a byte, the lowest first; the last byte has its highest bit clear.
void write_size(std::uint64_t size, std::string& out);
std::uint64_t read_size(std::string_view& bytes);

// RFC 1950, by the smallest that zlib finds.
std::string deflated(std::string_view bytes);

// What a stretch may be deflated from: several times a column of the largest target's fragments.
constexpr std::uint64_t kLongestStretch = std::uint64_t{1} << 30;

// Deflated bytes with their sizes before them, and what they were deflated from.
void write_deflated(std::string_view bytes, std::string& out);
void write_stretch(std::size_t size, std::string_view deflated, std::string& out);
std::string read_deflated(std::string_view& bytes);

// CRC-32, as zlib has it; goes on from that of the bytes before.
std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

}  // namespace edgecase::recording
