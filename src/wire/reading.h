// SPDX-License-Identifier: MIT
//
// Strict reading of JSON values that another program wrote. For src/wire alone: its readers throw a
// Refusal, and the public functions of this folder turn it into a WireError.
//
// A Path names the value at hand as an RFC 6901 pointer. It is a chain of links on the stack, so
// that an array of a million numbers costs no text until one of them is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace edgecase::wire {

class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Path {
 public:
  Path() = default;
  Path(const Path& parent, const char* key) : parent_(&parent), key_(key) {}
  Path(const Path& parent, std::size_t index) : parent_(&parent), index_(index) {}

  // "/fragments/3/x"; "the line" for the document itself.
  std::string text() const;

 private:
  std::string pointer() const;

  const Path* parent_ = nullptr;
  const char* key_ = nullptr;
  std::size_t index_ = 0;
};

// Parses a whole line; anything behind the first value is refused.
nlohmann::json parse_text(std::string_view line);

// Refuses what is no object, and keys other than `known`.
void require_object(const nlohmann::json& value, const Path& path,
                    std::span<const char* const> known);
void require_object(const nlohmann::json& value, const Path& path,
                    std::initializer_list<const char*> known);

// Refuses what is no array, or one of another length than `size`.
void require_array(const nlohmann::json& value, const Path& path, std::size_t size);

// The member `key`, which must be there; and the one that may be absent (nullptr).
const nlohmann::json& member(const nlohmann::json& object, const Path& path, const char* key);
const nlohmann::json* optional_member(const nlohmann::json& object, const char* key);

// An integer, written as one (3, not 3.0), of low to high, both inclusive.
std::int64_t read_integer(const nlohmann::json& value, const Path& path, std::int64_t low,
                          std::int64_t high);

// The same, for limits of an int.
int read_int(const nlohmann::json& value, const Path& path, int low, int high);

bool read_bool(const nlohmann::json& value, const Path& path);

// A finite number.
double read_finite(const nlohmann::json& value, const Path& path);

// A number, or one of the strings "nan", "inf" and "-inf".
double read_number(const nlohmann::json& value, const Path& path);

const std::string& read_string(const nlohmann::json& value, const Path& path);

[[noreturn]] void refuse_name(const std::string& name, const Path& path);

// A name of an enumeration for which there is a parse_name.
template <class Enum>
Enum read_name(const nlohmann::json& value, const Path& path) {
  const std::string& name = read_string(value, path);
  Enum result{};
  if (!parse_name(name, result)) refuse_name(name, path);
  return result;
}

// The first characters of `text`, printable, at most `limit`, with "..." where something was cut.
std::string excerpt(std::string_view text, std::size_t limit);

}  // namespace edgecase::wire
