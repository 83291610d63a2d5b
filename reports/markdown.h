// SPDX-License-Identifier: MIT
//
// Texts from files and renderers inside Markdown (CommonMark, with GitHub's tables).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace edgecase {

// The text as a span of code on one line, backticks included, so that nothing in it is markup; "-"
// where it is empty. What is beyond `most` bytes is left out, and said to be.
std::string markdown_code(std::string_view text, std::size_t most = 600);

// The same for a cell of a table, which a bar would end.
std::string markdown_cell(std::string_view text, std::size_t most = 600);

// A page that takes whole lines for as long as there is room, and then says that more is left out.
class MarkdownPage {
 public:
  // At most `most` bytes, the words at its end included.
  explicit MarkdownPage(std::size_t most) : most_(most) {}

  void add(std::string_view lines);
  std::string text() const;

 private:
  std::size_t most_;
  std::string text_;
  bool is_full_ = false;
};

}  // namespace edgecase
