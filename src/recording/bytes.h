// SPDX-License-Identifier: MIT
//
// Sizes, deflated stretches of bytes, columns of numbers, and checksums. Readers remove what they
// read from the front, and throw std::runtime_error if the writers cannot have written it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase::recording {

// Seven bits per byte, the lowest first; the last byte has its highest bit clear.
void write_size(std::uint64_t size, std::string& out);
std::uint64_t read_size(std::string_view& bytes);

// RFC 1950, at zlib's best compression.
std::string deflated(std::string_view bytes);

// Deflated bytes, preceded by their size and by that of the inflated data.
void write_deflated(std::string_view bytes, std::string& out);
void write_stretch(std::size_t size, std::string_view deflated, std::string& out);
// Refuses inflated data of more than `most` bytes before it inflates anything: a thousandth of them
// suffices to ask for all memory.
std::string read_deflated(std::string_view& bytes, std::uint64_t most);

// CRC-32 as in zlib, continued from the checksum of the bytes before.
std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

// A column of numbers as few bytes, without loss.
//
// Whole numbers take few bytes each; others take their four or eight bytes as float32 or double,
// all first bytes before all second ones, since signs and exponents vary less than the end of a
// mantissa. Each form is tried directly and as steps from one number to the next, with bits read as
// integers; the one that deflates best is kept.

// Appends the column to `out`. Numbers must be finite and not -0.
void write_column(const std::vector<double>& column, std::string& out);

// Reads a column of at most `most` numbers from the front of `bytes` and removes it. Throws
// std::runtime_error if write_column cannot have written it.
std::vector<double> read_column(std::string_view& bytes, std::uint64_t most);

}  // namespace edgecase::recording
