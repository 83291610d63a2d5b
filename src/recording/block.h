// SPDX-License-Identifier: MIT
//
// A block: the lines of several neighbouring cases, packed together because neighbours are alike.
// Reading one case means reading its block.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgecase::recording {

// Lines are JSON values without line breaks. Equal lines give equal bytes.
std::string pack_block(const std::vector<std::string>& lines);

// The inverse, for lines that take at most `most` bytes of memory together (std::string). Throws
// std::runtime_error if pack_block cannot have made the bytes, or the lines are longer.
std::vector<std::string> unpack_block(std::string_view bytes, std::size_t most);

// Lines of JSON, split so that they deflate well, and joined again.
//
// A rendering on a line is mostly numbers, and numbers deflate badly amid repeating text: similar
// ones are far apart, and a float32 takes seventeen digits. So the text keeps a mark for each
// number, and the numbers go to columns by their key and their index in the innermost list modulo
// four, which separates the components of colours. This code knows nothing of renderings, so keys
// that answers gain later work as well.
//
// The result of joining is identical, byte for byte. A number that this program would write
// differently ("1.50", "-0", one beyond 2^53) stays in the text.
struct LineColumns {
  std::string text;  // all lines, each ended by a line break, with '#' for each number in a column
  std::vector<std::vector<double>> columns;  // in order of first use by the text
};

// Lines are JSON values without line breaks.
LineColumns take_apart(const std::vector<std::string>& lines);

// The inverse. Throws std::runtime_error if text and columns do not match, or the lines take more
// than `most` bytes of memory.
std::vector<std::string> put_together(const LineColumns& parts, std::size_t most);

}  // namespace edgecase::recording
