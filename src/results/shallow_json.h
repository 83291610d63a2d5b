// SPDX-License-Identifier: MIT
//
// JSON that others wrote, of no more levels than our own files have.
//
// The library calls itself for what a value holds where it copies or prints one. Of a file of
// nothing but brackets that would take more stack than there is.
#pragma once

#include <cstddef>
#include <exception>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// JSON of a type that nobody else has, read several times as fast: its functions, those of its
// texts too, are compiled in this folder alone. Of the usual types, the command's own sources,
// which are not optimized, have instances, and a linker takes any.
template <class Value>
struct ReadAllocator : std::allocator<Value> {
  ReadAllocator() = default;
  template <class Other>
  ReadAllocator(const ReadAllocator<Other>&) {}  // NOLINT: as allocators are
};
using ReadText = std::basic_string<char, std::char_traits<char>, ReadAllocator<char>>;
using ReadJson = nlohmann::basic_json<std::map, std::vector, ReadText>;

// Arrays and objects within each other; our own files have about eight.
constexpr std::size_t kMostLevels = 100;

// Both throw std::runtime_error for text that is nested deeper, and what the library throws for
// text that is no JSON.
nlohmann::json parse_shallow(std::string_view text);
ReadJson parse_line(std::string_view text);

// A string's text. Throws std::runtime_error for any other value.
std::string_view to_text(const ReadJson& json);

// What an exception says, for people: the JSON library's tag in brackets, which stands before its
// sentences, is left out.
std::string fault_of(const std::exception& error);

}  // namespace edgecase
