// SPDX-License-Identifier: MIT
//
// Small services on text for messages: UTF-8, lists of names, and "did you mean".
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgecase {

// Offset of the first byte that is not part of well-formed UTF-8 (no overlong forms, no
// surrogates, nothing above U+10FFFF); none when all of it is.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

// Number of code points; `text` must be well-formed UTF-8.
std::size_t count_characters(std::string_view text);

// The text with '?' for each byte that is no part of well-formed UTF-8 and for each control
// character: what others wrote, as a line that every file may hold.
std::string clean_line(std::string text);

// The beginning of well-formed UTF-8: whole characters, at most `most` bytes of them.
std::string_view beginning_of(std::string_view text, std::size_t most);

// In double quotes, cut after about 60 characters.
std::string quote(std::string_view text);

// "a, b, c".
std::string join_names(std::span<const std::string> names);

// The name that differs least from `name`, if it is near enough to be meant: `name` is its start,
// or up to a third of the characters (at least one of three) are changed, left out, added or
// swapped with a neighbour. Empty: none.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

// "did you mean \"NEAREST\"? Allowed are a, b, c": the question only where a name is near, and then
// the list only where it has 30 names at most.
std::string suggest_names(std::string_view name, std::span<const std::string> names);

}  // namespace edgecase
