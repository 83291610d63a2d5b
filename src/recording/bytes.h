// SPDX-License-Identifier: MIT
//
// Sizes and deflated stretches of bytes, and their checksums. Readers take what they read away from
// the front, and throw std::runtime_error where that is not what the writers write.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

// A column of numbers as bytes, small and exact.
//
// Whole numbers become few bytes each, others their four or eight bytes as float32 or double, all
// first bytes before all second ones: signs and exponents vary less than the end of a mantissa.
// Each kind is tried as it is and as steps from one number to the next, with bits taken for
// integers; what deflates best is kept.

// Appends the column to `out`. Numbers are finite, and zero is not negative.
void write_column(const std::vector<double>& column, std::string& out);

// Reads a column from the beginning of `bytes`, and takes it away. Throws std::runtime_error for
// what write_column does not write.
std::vector<double> read_column(std::string_view& bytes);

}  // namespace edgecase::recording
