// SPDX-License-Identifier: MIT
//
// Text: whole files of it, and utilities for messages: UTF-8, lists of names, "did you mean".
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgecase {

struct TextFile {
  std::optional<std::string> text;
  std::string message;  // why there is no text
  std::string remedy;
};

// Reads a whole file. Only regular files are read, and those that are as long as they say: a pipe,
// a device or a file of the system could block a run for ever. Never throws. Refuses a file of more
// than `limit` bytes, and reads nothing of it.
TextFile read_text_file(const std::filesystem::path& file, std::size_t limit);

// Offset of the first byte that is not part of well-formed UTF-8 (no overlong forms, no surrogates,
// nothing above U+10FFFF); nothing if there is none.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

// Number of code points; `text` must be well-formed UTF-8.
std::size_t count_characters(std::string_view text);

// The text with '?' for each control character and each byte that is not part of well-formed UTF-8:
// a foreign text as a line that any file may contain.
std::string clean_line(std::string text);

// The longest start of well-formed UTF-8 with whole characters and at most `most` bytes.
std::string_view beginning_of(std::string_view text, std::size_t most);

// In double quotes, cut after about 60 characters.
std::string quote(std::string_view text);

// "a, b, c".
std::string join_names(std::span<const std::string> names);

// The name nearest to `name`, if it is near enough to be meant: `name` is its start, or up to a
// third of the characters (at least one of three) are changed, missing, added or swapped with a
// neighbour. Empty if there is none.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

// "did you mean \"NEAREST\"? Allowed are a, b, c". The question is asked only if a name is near;
// the list then has at most 30 names or is omitted.
std::string suggest_names(std::string_view name, std::span<const std::string> names);

}  // namespace edgecase
