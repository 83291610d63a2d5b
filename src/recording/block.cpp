// SPDX-License-Identifier: MIT
#include "recording/block.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

#include "recording/bytes.h"

namespace edgecase::recording {

namespace {

constexpr char kMark = '#';
constexpr std::size_t kPhases = 4;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
// Doubles up to here are written as integers.
constexpr double kLargestInteger = 9007199254740992.0;

// The state of a scan through a text of lines, and the column of a number at this place. Columns
// are numbered by first use, so both directions number them alike.
class Place {
 public:
  Place() { end_line(); }

  void key(std::string_view name) {
    key_ = &columns_.try_emplace(std::string(name), kNew).first->second;
  }
  void open() {
    outer_.push_back({key_, index_});
    index_ = 0;
  }
  void close() {
    if (outer_.empty()) throw std::runtime_error("a bracket closes nothing");
    key_ = outer_.back().key;
    index_ = outer_.back().index;
    outer_.pop_back();
  }
  void comma() { ++index_; }
  void end_line() {
    outer_.clear();
    index_ = 0;
    key("");
  }
  std::size_t column() {
    std::size_t& number = (*key_)[index_ % kPhases];
    if (number == kNone) number = count_++;
    return number;
  }

 private:
  using Numbers = std::array<std::size_t, kPhases>;
  static constexpr Numbers kNew = {kNone, kNone, kNone, kNone};
  struct Outer {
    Numbers* key;
    std::size_t index;
  };
  std::map<std::string, Numbers> columns_;
  Numbers* key_ = nullptr;
  std::size_t index_ = 0;
  std::vector<Outer> outer_;
  std::size_t count_ = 0;
};

// The position behind the closing quote of the string that starts at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      return i + 1;
  }
  throw std::runtime_error("a string does not end");
}

bool begins_number(char c) {
  return c == '-' || (c >= '0' && c <= '9');
}

std::size_t end_of_number(std::string_view text, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < text.size() && (begins_number(text[end]) || text[end] == '.' || text[end] == 'e' ||
                               text[end] == 'E' || text[end] == '+'))
    ++end;
  return end;
}

void write_number(std::string& out, double value) {
  std::array<char, 24> digits;
  if (std::abs(value) < kLargestInteger && value == std::trunc(value)) {
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(),
                                            static_cast<std::int64_t>(value));
    out.append(digits.data(), end);
  } else {
    fmt::format_to(std::back_inserter(out), "{}", value);
  }
}

// The number, if this program would write it exactly as `token`; otherwise nothing.
std::optional<double> number_of(std::string_view token) {
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  // Small whole numbers, the usual case, need no proof.
  constexpr std::size_t kSurelyWhole = 15;
  const bool is_plain = token.size() <= kSurelyWhole && token[0] != '-' &&
                        (token[0] != '0' || token.size() == 1) &&
                        token.find_first_not_of("0123456789") == token.npos;
  if (is_plain) return value;
  std::string written;
  write_number(written, value);
  return written == token ? std::optional(value) : std::nullopt;
}

// Scans a text and copies it to `out`. If `is_number` accepts a character, `number(place, begin)`
// is called instead of copying and returns where the text continues.
template <class IsNumber, class Number>
void scan(std::string_view text, Place& place, std::string& out, IsNumber is_number,
          Number number) {
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (is_number(c)) {
      i = number(i);
      continue;
    }
    if (c == '"') {
      const std::size_t end = end_of_string(text, i);
      if (end < text.size() && text[end] == ':') place.key(text.substr(i + 1, end - i - 2));
      out.append(text, i, end - i);
      i = end;
      continue;
    }
    if (c == '[' || c == '{')
      place.open();
    else if (c == ']' || c == '}')
      place.close();
    else if (c == ',')
      place.comma();
    else if (c == '\n')
      place.end_line();
    out += c;
    ++i;
  }
}

}  // namespace

LineColumns take_apart(const std::vector<std::string>& lines) {
  LineColumns parts;
  Place place;
  for (const std::string& line : lines) {
    const std::string_view text = line;
    scan(text, place, parts.text, begins_number, [&](std::size_t begin) {
      const std::size_t end = end_of_number(text, begin);
      const std::string_view token = text.substr(begin, end - begin);
      const auto value = number_of(token);
      if (!value) {
        parts.text += token;
        return end;
      }
      const std::size_t column = place.column();
      if (column == parts.columns.size()) parts.columns.emplace_back();
      parts.columns[column].push_back(*value);
      parts.text += kMark;
      return end;
    });
    place.end_line();
    parts.text += '\n';
  }
  return parts;
}

namespace {

[[noreturn]] void refuse_length() {
  throw std::runtime_error("it is longer than its scenes can need");
}

}  // namespace

std::vector<std::string> put_together(const LineColumns& parts, std::size_t most) {
  std::vector<std::string> lines;
  std::vector<std::size_t> used(parts.columns.size());
  Place place;
  const std::string_view text = parts.text;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    if (end == text.npos) throw std::runtime_error("a line does not end");
    std::string& line = lines.emplace_back();
    scan(
        text.substr(begin, end - begin), place, line, [](char c) { return c == kMark; },
        [&](std::size_t at) {
          const std::size_t column = place.column();
          if (column >= used.size() || used[column] == parts.columns[column].size())
            throw std::runtime_error("a number is missing");
          write_number(line, parts.columns[column][used[column]++]);
          if (line.size() > most) refuse_length();
          return at + 1;
        });
    // A text of line breaks alone takes as much.
    if (line.size() + sizeof(line) > most) refuse_length();
    most -= line.size() + sizeof(line);
    place.end_line();
    begin = end + 1;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i] != parts.columns[i].size()) throw std::runtime_error("a number is left over");
  return lines;
}

std::string pack_block(const std::vector<std::string>& lines) {
  const LineColumns parts = take_apart(lines);
  std::string bytes;
  write_deflated(parts.text, bytes);
  write_size(parts.columns.size(), bytes);
  for (const std::vector<double>& column : parts.columns) write_column(column, bytes);
  return bytes;
}

std::vector<std::string> unpack_block(std::string_view bytes, std::size_t most) {
  LineColumns parts;
  parts.text = read_deflated(bytes, most);
  // There is a mark in the text for each.
  auto numbers = static_cast<std::size_t>(std::ranges::count(parts.text, kMark));
  const std::uint64_t columns = read_size(bytes);
  for (std::uint64_t i = 0; i < columns; ++i) {
    parts.columns.push_back(read_column(bytes, numbers));
    numbers -= parts.columns.back().size();
  }
  if (!bytes.empty()) throw std::runtime_error("there is something behind the last column");
  return put_together(parts, most);
}

}  // namespace edgecase::recording
