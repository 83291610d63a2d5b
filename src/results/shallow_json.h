// SPDX-License-Identifier: MIT
//
// JSON that others wrote, of no more levels than our own files have.
//
// The library calls itself for what a value holds where it copies or prints one. Of a file of
// nothing but brackets that would take more stack than there is.
#pragma once

#include <cstddef>
#include <exception>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace edgecase {

// Arrays and objects within each other; our own files have about eight.
constexpr std::size_t kMostLevels = 100;

// Throws std::runtime_error for text that is nested deeper, and what the library throws for text
// that is no JSON.
nlohmann::json parse_shallow(std::string_view text);

// What an exception says, for people: the JSON library's tag in brackets, which stands before its
// sentences, is left out.
std::string fault_of(const std::exception& error);

}  // namespace edgecase
