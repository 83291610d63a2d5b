// SPDX-License-Identifier: MIT
#include "casefile/json/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <vector>

namespace edgecase {

namespace {

std::uint8_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<std::uint8_t>(text[i]);
}

bool is_continuation(std::uint8_t byte) {
  return (byte & 0xC0) == 0x80;
}

// Length of the well-formed sequence that starts at `i`, or 0. Unicode 15, table 3-7.
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const std::uint8_t lead = byte_at(text, i);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!is_continuation(byte_at(text, i + k))) return 0;
  const std::uint8_t second = byte_at(text, i + 1);
  if (lead == 0xE0 && second < 0xA0) return 0;  // overlong
  if (lead == 0xED && second > 0x9F) return 0;  // surrogates
  if (lead == 0xF0 && second < 0x90) return 0;  // overlong
  if (lead == 0xF4 && second > 0x8F) return 0;  // above U+10FFFF
  return length;
}

// Edit distance with swaps of neighbours (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * width);
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& cell = table[i * width + j];
      if (i == 0 || j == 0) {
        cell = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      cell = std::min({table[(i - 1) * width + j] + 1, table[i * width + j - 1] + 1,
                       table[(i - 1) * width + j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cell = std::min(cell, table[(i - 2) * width + j - 2] + 1);
    }
  }
  return table.back();
}

}  // namespace

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return !is_continuation(static_cast<std::uint8_t>(c));
  }));
}

std::string clean_line(std::string text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    const bool is_control = byte_at(text, i) < 0x20 || text[i] == 0x7F;
    if (length == 0 || is_control) text[i] = '?';
    i += std::max<std::size_t>(length, 1);
  }
  return text;
}

std::string_view beginning_of(std::string_view text, std::size_t most) {
  std::size_t end = std::min(text.size(), most);
  while (end < text.size() && end > 0 && is_continuation(byte_at(text, end))) --end;
  return text.substr(0, end);
}

std::string quote(std::string_view text) {
  constexpr std::size_t kShown = 60;
  const std::string_view shown = beginning_of(text, kShown);
  return fmt::format("\"{}{}\"", shown, shown.size() < text.size() ? "..." : "");
}

std::string join_names(std::span<const std::string> names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string nearest_name(std::string_view name, std::span<const std::string> names) {
  constexpr std::size_t kLongest = 80;  // no known name is longer
  if (name.empty() || name.size() > kLongest) return "";
  std::string nearest;
  std::size_t least = std::max<std::size_t>(name.size() > 2 ? 1 : 0, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const std::size_t edits = candidate.starts_with(name) ? 0 : distance(name, candidate);
    if (edits >= least) continue;
    least = edits;
    nearest = candidate;
  }
  return nearest;
}

std::string suggest_names(std::string_view name, std::span<const std::string> names) {
  const std::string nearest = nearest_name(name, names);
  if (nearest.empty()) return fmt::format("allowed are {}", join_names(names));
  constexpr std::size_t kMostListed = 30;  // a longer list would hide the question
  if (names.size() > kMostListed) return fmt::format("did you mean {}?", quote(nearest));
  return fmt::format("did you mean {}? Allowed are {}", quote(nearest), join_names(names));
}

TextFile read_text_file(const std::filesystem::path& file, std::size_t limit) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    return {{}, "there is no such file", "check the path's spelling"};
  if (!std::filesystem::is_regular_file(status))
    return {{}, "this is no regular file", "name a regular file"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {{}, "the file cannot be opened", "check its permissions"};
  // Reading one byte more than allowed detects a file that is too large, even while it grows. Most
  // files are much smaller, and memory for the largest would cost more than reading them.
  std::string text;
  std::array<char, 1 << 14> chunk;
  while (stream && text.size() <= limit) {
    stream.read(chunk.data(),
                static_cast<std::streamsize>(std::min(chunk.size(), limit + 1 - text.size())));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {{}, "the file cannot be read", "check the disk and its permissions"};
  if (text.size() > limit)
    return {{}, fmt::format("larger than {} bytes", limit), "make the file smaller"};
  return {std::move(text), "", ""};
}

}  // namespace edgecase
