// SPDX-License-Identifier: MIT
//
// Lines and digits come from the parser's read position: the text is fed through a counting
// iterator. When a value is reported, its last character was just read; only after a number one
// more character was read, since nothing else shows where it ends.
#include "casefile/json/json_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <utility>

#include "casefile/json/text.h"

namespace edgecase {

namespace {

// The number of values of any kind in a file: 16 for each vertex that a case may have. In memory
// each takes as much as 100 characters.
constexpr std::size_t kMaxValues = std::size_t{1} << 20;

// Reads characters and counts them in a variable that outlives the parser's copies of the iterator.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  std::size_t* count_;
};

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& file, JsonDocument& document)
      : text_(text), file_(file), document_(document) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') breaks_.push_back(i);
  }

  std::size_t* count() { return &consumed_; }

  bool null() override {
    add(JsonKind::null);
    return room();
  }
  bool boolean(bool value) override {
    add(JsonKind::boolean)->truth = value;
    return room();
  }
  bool number_integer(number_integer_t) override { return number(); }
  bool number_unsigned(number_unsigned_t) override { return number(); }
  bool number_float(number_float_t, const string_t&) override { return number(); }
  bool string(string_t& value) override {
    add(JsonKind::string)->text = std::move(value);
    return room();
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonKind::object); }
  bool start_array(std::size_t) override { return open(JsonKind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override;
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override;

 private:
  // An array or object that is not closed yet.
  struct Open {
    JsonNode* node = nullptr;
    std::unordered_map<std::string, int> lines_of_keys;
  };

  int line_at(std::size_t offset) const {
    const auto next = std::lower_bound(breaks_.begin(), breaks_.end(), offset);
    return static_cast<int>(next - breaks_.begin()) + 1;
  }
  int column_at(std::size_t offset) const {
    const int line = line_at(offset);
    const std::size_t start = line == 1 ? 0 : breaks_[static_cast<std::size_t>(line) - 2] + 1;
    return static_cast<int>(count_characters(text_.substr(start, offset - start))) + 1;
  }
  std::size_t last_read() const { return std::max<std::size_t>(consumed_, 1) - 1; }

  JsonNode* add(JsonKind kind);
  bool room();  // for the value added last, which is refused otherwise
  bool number();
  bool open(JsonKind kind);
  bool close() {
    open_.pop_back();
    return true;
  }
  std::string pointer_of_next() const;
  void diagnose(int line, std::string pointer, std::string message, std::string remedy) {
    document_.diagnostics.push_back(
        {file_, line, std::move(pointer), std::move(message), std::move(remedy)});
  }

  std::string_view text_;
  const std::string& file_;
  JsonDocument& document_;
  std::vector<std::size_t> breaks_;  // offsets of line breaks
  std::size_t consumed_ = 0;         // characters read by the parser
  std::size_t values_ = 0;           // in the tree
  std::vector<Open> open_;
  JsonNode pending_;  // name, line and duplicate flag of the next member
};

// Appends a value to the innermost open node. Pointers to open nodes stay valid: a list of children
// grows only while none of those children is open.
JsonNode* TreeBuilder::add(JsonKind kind) {
  JsonNode node = std::exchange(pending_, {});
  node.kind = kind;
  node.line = line_at(last_read());
  if (open_.empty()) return &document_.root.emplace(std::move(node));
  return &open_.back().node->children.emplace_back(std::move(node));
}

bool TreeBuilder::room() {
  if (++values_ <= kMaxValues) return true;
  diagnose(line_at(last_read()), "", fmt::format("more than {} values", kMaxValues),
           "split the file into several cases, and give large pictures and meshes files of their "
           "own");
  document_.root.reset();
  return false;
}

bool TreeBuilder::number() {
  const auto is_part = [](char c) {
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
  };
  std::size_t end = consumed_;
  while (end > 0 && (text_[end - 1] < '0' || text_[end - 1] > '9')) --end;
  std::size_t start = end;
  while (start > 0 && is_part(text_[start - 1])) --start;
  JsonNode* node = add(JsonKind::number);
  node->line = line_at(start);
  node->text = text_.substr(start, end - start);
  return room();
}

bool TreeBuilder::open(JsonKind kind) {
  JsonNode* node = add(kind);
  open_.push_back({node, {}});
  if (open_.size() <= kMaxNesting) return room();
  diagnose(node->line, "", fmt::format("nested deeper than {} levels", kMaxNesting),
           "flatten the file: a case needs about six levels");
  document_.root.reset();
  return false;
}

bool TreeBuilder::key(string_t& name) {
  pending_.name = name;
  pending_.name_line = line_at(last_read());
  const auto [found, fresh] = open_.back().lines_of_keys.emplace(name, pending_.name_line);
  pending_.duplicate = !fresh;
  if (!fresh)
    diagnose(pending_.name_line, pointer_of_next(),
             fmt::format("the key {} stands twice, first on line {}", quote(name), found->second),
             "keep one of the two");
  return true;
}

// The pointer of the value that is added next.
std::string TreeBuilder::pointer_of_next() const {
  std::string result;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const JsonNode& parent = *open_[i].node;
    const bool innermost = i + 1 == open_.size();
    const JsonNode& child = innermost ? pending_ : *open_[i + 1].node;
    const std::size_t index = parent.children.size() - (innermost ? 0 : 1);
    result += '/';
    result += parent.kind == JsonKind::object ? escape_pointer(child.name) : std::to_string(index);
  }
  return result;
}

bool TreeBuilder::parse_error(std::size_t position, const std::string& token,
                              const nlohmann::detail::exception& error) {
  constexpr int kNumberOverflow = 406;
  if (error.id == kNumberOverflow) {
    diagnose(line_at(last_read()), pointer_of_next(),
             fmt::format("the number {} is too large to read", token), "write a smaller number");
  } else {
    const bool broken = std::string_view(error.what()).find("invalid string") != std::string::npos;
    const bool complete = document_.root && open_.empty();
    const SyntaxError found = explain_syntax_error(text_, {position, broken, complete});
    diagnose(line_at(found.offset), "",
             fmt::format("no valid JSON at line {}, column {}: {}", line_at(found.offset),
                         column_at(found.offset), found.message),
             found.remedy);
  }
  document_.root.reset();
  return false;
}

// Checks before any parsing; nothing if there is no fault.
std::optional<Diagnostic> check_bytes(std::string_view text, const std::string& file) {
  if (text.size() > kMaxFileBytes)
    return Diagnostic{file, 0, "", fmt::format("larger than {} bytes", kMaxFileBytes),
                      "split the file into several cases"};
  if (text.starts_with("\xEF\xBB\xBF"))
    return Diagnostic{file, 1, "", "starts with a byte order mark",
                      "save the file as UTF-8 without one"};
  if (const auto offset = find_invalid_utf8(text)) {
    const auto breaks = std::count(text.begin(), text.begin() + static_cast<long>(*offset), '\n');
    return Diagnostic{file, static_cast<int>(breaks) + 1, "",
                      fmt::format("byte {} of the file is not UTF-8", *offset),
                      "save the file as UTF-8"};
  }
  // The parser would treat it as the end of the file.
  if (const auto nul = text.find('\0'); nul != text.npos) {
    const auto breaks = std::count(text.begin(), text.begin() + static_cast<long>(nul), '\n');
    return Diagnostic{file, static_cast<int>(breaks) + 1, "",
                      fmt::format("byte {} of the file is NUL, which no JSON holds", nul),
                      "take it out, and what follows it if that is no JSON"};
  }
  return std::nullopt;
}

}  // namespace

const JsonNode* JsonNode::find(std::string_view member) const {
  for (const JsonNode& child : children)
    if (child.name == member) return &child;
  return nullptr;
}

JsonDocument parse_json(std::string_view text, const std::string& file) {
  JsonDocument document;
  if (auto refused = check_bytes(text, file)) {
    document.diagnostics.push_back(std::move(*refused));
    return document;
  }
  TreeBuilder builder(text, file, document);
  const char* begin = text.data();
  nlohmann::json::sax_parse(CountingIterator(begin, builder.count()),
                            CountingIterator(begin + text.size(), builder.count()), &builder);
  return document;
}

std::string escape_pointer(std::string_view part) {
  std::string result;
  for (const char c : part) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

std::string describe(const JsonNode& node) {
  switch (node.kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return node.truth ? "true" : "false";
    case JsonKind::number:
      return "the number " + node.text;
    case JsonKind::string:
      return "the string " + quote(node.text);
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "a value";
}

}  // namespace edgecase
