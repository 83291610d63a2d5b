// SPDX-License-Identifier: MIT
//
// The parser knows little more than where it stopped. Mistakes in JSON written by hand are few (a
// comma too many or too few, comments, single quotes, NaN, numbers as in C), so the text around
// that position is compared with a list of them.
#include "casefile/json/json_document.h"

#include <algorithm>
#include <string>

#include "casefile/json/text.h"

namespace edgecase {

namespace {

bool is_word_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '+' || c == '-' || c == '.';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string_view word_at(std::string_view text, std::size_t start) {
  std::size_t end = start;
  while (end < text.size() && is_word_character(text[end])) ++end;
  return text.substr(start, end - start);
}

// The length of the string that opens at `start`, with both quotes if it closes on its line.
std::size_t string_length(std::string_view text, std::size_t start) {
  std::size_t end = start + 1;
  while (end < text.size() && text[end] != '"' && text[end] != '\n')
    end += text[end] == '\\' ? 2U : 1U;
  return std::min(end + 1, text.size()) - start;
}

// The start of the string, word or single character with the byte at `offset`.
std::size_t token_start(std::string_view text, std::size_t offset) {
  for (std::size_t start = 0;;) {
    std::size_t length = 1;
    if (text[start] == '"') {
      length = string_length(text, start);
    } else if (is_word_character(text[start])) {
      length = word_at(text, start).size();
    }
    if (start + length > offset) return start;
    start += length;
  }
}

// The last character before `offset` that is not white space, or '\0'.
char previous_character(std::string_view text, std::size_t offset) {
  const std::size_t at = text.substr(0, offset).find_last_not_of(" \t\r\n");
  return at == std::string_view::npos ? '\0' : text[at];
}

// Whether a word is a JSON number.
bool is_json_number(std::string_view word) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t start = i;
    while (i < word.size() && is_digit(word[i])) ++i;
    return i - start;
  };
  if (i < word.size() && word[i] == '-') ++i;
  const std::size_t first = i;
  const std::size_t whole = digits();
  if (whole == 0 || (whole > 1 && word[first] == '0')) return false;
  if (i < word.size() && word[i] == '.' && (++i, digits() == 0)) return false;
  if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
    ++i;
    if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
    if (digits() == 0) return false;
  }
  return i == word.size();
}

SyntaxError explain_word(std::string_view text, std::size_t start) {
  const std::string_view word = word_at(text, start);
  const std::string plain = lower(word.substr(std::min(word.find_first_not_of("+-"), word.size())));
  if (plain == "nan" || plain == "inf" || plain == "infinity")
    return {start, std::string(word) + " is no number in JSON", "write a finite number"};
  if (plain == "true" || plain == "false" || plain == "null")
    return {start, quote(word) + " is misspelt or misplaced", "write " + plain + " as a value"};
  if (is_digit(word.front()) || word.front() == '-' || word.front() == '+' || word.front() == '.') {
    if (is_json_number(word))
      return {start, quote(word) + " stands where no value can",
              "put a comma before it if it is a value of its own"};
    return {start, quote(word) + " is a malformed number",
            "write it like -10.5: no plus sign, no leading zeros, digits on both sides of the "
            "point; fractions go into quotes"};
  }
  return {start, quote(word) + " stands without quotes", "put double quotes round text"};
}

SyntaxError explain_string(std::string_view text, std::size_t start) {
  const std::string_view token = text.substr(start, string_length(text, start));
  return {start, quote(token.substr(1, token.size() - 2)) + " stands where no string can",
          "put a comma between two values, and a colon between a key and its value"};
}

SyntaxError explain_broken_string(std::string_view text, std::size_t start, std::size_t last) {
  if (text[last] >= 0 && text[last] < 0x20)
    return {last, "a string holds a line break or another control character",
            "write \\n for a line break, or close the string with \""};
  return {start, "a string holds a malformed escape",
          "write \\\\ for a backslash; the escapes are \\\" \\\\ \\/ \\b \\f \\n \\r \\t and "
          "\\uXXXX"};
}

SyntaxError explain_character(std::string_view text, std::size_t start) {
  const char here = text[start];
  const char before = previous_character(text, start);
  const std::string shown(1, here);
  switch (here) {
    case '}':
    case ']':
      if (before == ',')
        return {start, "a comma stands before the closing " + shown, "remove the comma"};
      return {start, shown + " closes nothing that is open here",
              "check that every { [ and \" is closed by its like, in order"};
    case ',':
      return {start, "a comma stands where a value should", "remove it or add the value"};
    case ':':
      return {start, "a colon stands where none can", "write \"key\": value"};
    case '/':
      if (is_digit(before))
        return {start, "a fraction stands without quotes", "write it as a string: \"1/2\""};
      [[fallthrough]];
    case '#':
      return {start, "JSON knows no comments", "put the words into \"why\" or remove them"};
    case '\'':
      return {start, "single quotes are no quotes in JSON", "use double quotes"};
    case '{':
    case '[':
      return {start, shown + " opens a value where none can stand",
              "put a comma between two values, and a key in front of a member's value"};
    default:
      break;
  }
  const bool printable = here >= 0x20 && here < 0x7F;
  return {start,
          (printable ? quote(shown) : std::string("a character")) + " stands where it cannot",
          "remove it, or put double quotes round text"};
}

}  // namespace

SyntaxError explain_syntax_error(std::string_view text, ParserStop stop) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return {0, "the file is empty", "write a JSON object into it"};
  if (stop.consumed > text.size())
    return {text.size(), "the text ends before its values are complete",
            "close every { [ and \" that is open"};
  const std::size_t last = std::max<std::size_t>(stop.consumed, 1) - 1;
  const std::size_t start = token_start(text, last);
  if (stop.broken_string) return explain_broken_string(text, start, last);
  if (stop.complete)
    return {start, "something follows the end of the document",
            "keep one JSON object per file, and remove what follows it"};
  if (text[start] == '"') return explain_string(text, start);
  if (is_word_character(text[start])) return explain_word(text, start);
  return explain_character(text, start);
}

}  // namespace edgecase
