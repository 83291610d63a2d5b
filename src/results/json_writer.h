// SPDX-License-Identifier: MIT
//
// Appends JSON to a text, member by member, without a tree in memory.
//
// The text equals, to the byte, what nlohmann::ordered_json dumps without spaces: escapes and
// numbers with a fraction are that library's, and invalid UTF-8 is replaced. The caller gives the
// members of an object names, all different.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <ranges>
#include <string>
#include <string_view>

namespace edgecase {

class JsonWriter {
 public:
  // Appends to `text`, which must live as long.
  explicit JsonWriter(std::string& text) : text_(text) {}

  // The members are what `write()` writes.
  template <std::invocable Write>
  void object(Write write) {
    open('{');
    write();
    close('}');
  }

  // The name of a member, whose value must be written next.
  JsonWriter& key(std::string_view name);
  template <class Value>
  void member(std::string_view name, const Value& value) {
    key(name).value(value);
  }

  // An array, whose items are what `write()` writes.
  template <std::invocable Write>
  void list(Write write) {
    open('[');
    write();
    close(']');
  }
  // The same, where `write(*this, item)` writes one value for each item.
  template <std::ranges::input_range Range, class Write>
  void list(const Range& items, Write write) {
    open('[');
    for (const auto& item : items) write(*this, item);
    close(']');
  }
  // The same of given values.
  template <class... Values>
  void array(const Values&... values) {
    open('[');
    (value(values), ...);
    close(']');
  }

  template <std::same_as<bool> Bool>  // no pointer becomes one
  void value(Bool value) {
    literal(value ? "true" : "false");
  }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) void value(Integer value) {
    const fmt::format_int digits(value);
    literal({digits.data(), digits.size()});
  }
  // JSON has no NaN or infinity: they are the strings "nan", "inf" and "-inf".
  void value(double value);
  void value(std::string_view text);
  void value(std::nullptr_t) { literal("null"); }
  template <std::ranges::input_range Range>
  requires(!std::convertible_to<const Range&, std::string_view>) void value(const Range& items) {
    list(items, [](JsonWriter& json, const auto& item) { json.value(item); });
  }

 private:
  // What stands before any value or name.
  void separate() {
    if (needs_comma_) text_ += ',';
    needs_comma_ = true;
  }
  void open(char bracket) {
    separate();
    text_ += bracket;
    needs_comma_ = false;
  }
  void close(char bracket) {
    text_ += bracket;
    needs_comma_ = true;
  }
  void literal(std::string_view text) {
    separate();
    text_ += text;
  }

  std::string& text_;
  bool needs_comma_ = false;  // a value ends here, and none begins
};

}  // namespace edgecase
