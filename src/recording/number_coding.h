// SPDX-License-Identifier: MIT
//
// A column of numbers as bytes, small and exact.
//
// Whole numbers become few bytes each, others their four or eight bytes as float32 or double, all
// first bytes before all second ones: signs and exponents vary less than the end of a mantissa.
// Each kind is tried as it is and as steps from one number to the next, with bits taken for
// integers; what deflates best is kept.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgecase::recording {

// Appends the column to `out`. Numbers are finite, and zero is not negative.
void write_column(const std::vector<double>& column, std::string& out);

// Reads a column from the beginning of `bytes`, and takes it away. Throws std::runtime_error for
// what write_column does not write.
std::vector<double> read_column(std::string_view& bytes);

}  // namespace edgecase::recording
