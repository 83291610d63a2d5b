// SPDX-License-Identifier: MIT
//
// Texts from files and renderers inside Markdown (CommonMark, with GitHub's tables).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace edgecase {

// The text as a code span on one line, in which nothing is markup; "-" if it is empty. Text beyond
// `most` bytes is replaced by a note.
std::string markdown_code(std::string_view text, std::size_t most = 600);

// The same for a cell of a table, with bars escaped.
std::string markdown_cell(std::string_view text, std::size_t most = 600);

// A page of whole lines that ends with a note if some did not fit.
class MarkdownPage {
 public:
  // At most `most` bytes, including the note at the end.
  explicit MarkdownPage(std::size_t most) : most_(most) {}

  void add(std::string_view lines);
  std::string text() const;

 private:
  std::size_t most_;
  std::string text_;
  bool is_full_ = false;
};

}  // namespace edgecase
