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

// Lines of JSON, taken apart so that they deflate well, and put together again.
//
// A rendering on a line is mostly numbers, and numbers deflate badly among the text that repeats
// round them: neighbours of one kind stand far apart, and a float32 takes seventeen digits. So the
// text is kept with a mark for each number, and the numbers go to columns of their kind: by the key
// that they stand under and their index in the innermost list, modulo four, which separates the
// components of colours. Nothing here knows what a rendering is: keys that answers gain later are
// kept as well.
//
// What comes back is the same, byte for byte. A number that this program would write otherwise
// ("1.50", "-0", one beyond 2^53) stays in the text.
struct LineColumns {
  std::string text;  // of all lines, each ended by a line break, '#' for each number in a column
  std::vector<std::vector<double>> columns;  // in the order in which the text first needs them
};

// Lines are JSON values without line breaks.
LineColumns take_apart(const std::vector<std::string>& lines);

// The inverse. Throws std::runtime_error where text and columns do not belong together.
std::vector<std::string> put_together(const LineColumns& parts);

}  // namespace edgecase::recording
