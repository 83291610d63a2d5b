// SPDX-License-Identifier: MIT
#include "reports/markdown.h"

#include <algorithm>

#include "reports/text.h"

namespace edgecase {
namespace {

std::size_t longest_run_of_backticks(std::string_view text) {
  std::size_t longest = 0;
  std::size_t run = 0;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

}  // namespace

std::string markdown_code(std::string_view text, std::size_t most) {
  const std::string shown = one_line(shortened(text, most));
  if (shown.empty()) return "-";
  // A span ends at a run of as many backticks as it begins with; one space at either end is
  // dropped.
  const std::string fence(longest_run_of_backticks(shown) + 1, '`');
  const auto is_lost = [](char c) { return c == '`' || c == ' '; };
  const bool needs_room = is_lost(shown.front()) || is_lost(shown.back());
  const std::string room = needs_room ? " " : "";
  return fence + room + shown + room + fence;
}

std::string markdown_cell(std::string_view text, std::size_t most) {
  std::string cell;
  for (const char c : markdown_code(text, most)) {
    if (c == '|') cell += '\\';
    cell += c;
  }
  return cell;
}

namespace {

constexpr std::string_view kLast = "\n\nThe rest does not fit here; the report has it.\n";

}  // namespace

void MarkdownPage::add(std::string_view lines) {
  if (is_full_ || text_.size() + lines.size() + kLast.size() > most_)
    is_full_ = true;
  else
    text_ += lines;
}

std::string MarkdownPage::text() const {
  return is_full_ ? text_ + std::string(kLast) : text_;
}

}  // namespace edgecase
