// SPDX-License-Identifier: MIT
//
// Reads typed values from a JSON tree; all faults are collected and none is thrown.
//
// A Place is a value with its JSON pointer. Each reader returns the value, or adds a finding and
// returns nothing; the caller then continues with the next value, so that a person sees all faults
// of a file at once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "casefile/json/json_document.h"
#include "casefile/json/text.h"
#include "model/case.h"

namespace edgecase {

struct Place {
  const JsonNode* node = nullptr;
  std::string pointer;

  // The place of a child: a member of an object, or an item of an array, by its index.
  Place child(std::size_t index) const;
};

// The faults of one file, and notes on values that were read differently from how they are written.
class Findings {
 public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  void add(const Place& place, std::string message, std::string remedy);
  // The same for the key of a member.
  void add_key(const Place& place, std::string message, std::string remedy);
  void add(Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }
  // Reports something that is not a fault; an immediate repetition is ignored.
  void note(const Place& place, std::string message);
  void note(Diagnostic note) { notes_.push_back(std::move(note)); }

  bool empty() const { return diagnostics_.empty(); }
  std::size_t size() const { return diagnostics_.size(); }
  const std::string& file() const { return file_; }
  // All findings, in order of lines.
  std::vector<Diagnostic> take();
  std::vector<Diagnostic> take_notes() { return std::move(notes_); }

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<Diagnostic> notes_;
};

// The keys of an object. `later` ones belong to the format but not to this version: they are
// refused by name, since an ignored key would seem to be tested.
struct Keys {
  std::vector<std::string> required;
  std::vector<std::string> optional;
  std::vector<std::string> later;
};

// An object whose keys have been checked. If the value is not an object, it is invalid and has no
// members.
class ObjectReader {
 public:
  // `what` names the object in messages: "a draw".
  ObjectReader(const Place& place, std::string_view what, const Keys& keys, Findings& findings);

  bool valid() const { return valid_; }
  // The place of a member, or nothing if it is absent.
  std::optional<Place> find(std::string_view name) const;

 private:
  void check_keys(std::string_view what, const Keys& keys, Findings& findings) const;

  Place place_;
  bool valid_ = false;
};

// Returns true if the value has this JSON type; otherwise adds "WHAT must be ..., not ...".
bool expect_kind(const Place& place, JsonKind kind, std::string_view what, Findings& findings);

// A string of `least` to `most` characters without control characters; `lines` permits line breaks
// and tabs.
struct TextLimits {
  std::size_t least = 0;
  std::size_t most = 10000;
  bool lines = false;
};
constexpr TextLimits kWordLimits{1, 200};   // a title, a rule, a tag, an alternative
constexpr TextLimits kNameLimits{1, 100};   // of a policy, of a zip group
constexpr TextLimits kPathLimits{1, 1000};  // of a file beside a case
std::optional<std::string> read_text(const Place& place, std::string_view what, TextLimits limits,
                                     Findings& findings);

// One of some names; names of the format that are not supported yet are refused as such.
struct Names {
  std::vector<std::string> allowed;
  std::vector<std::string> later;
};
std::optional<std::string> read_choice(const Place& place, std::string_view what,
                                       const Names& names, Findings& findings);

// The same for an enumeration that has a parse_name; `value` is unchanged if the name is refused.
template <class Enum>
bool read_enum(const Place& place, std::string_view what, const Names& names, Findings& findings,
               Enum& value) {
  const std::optional<std::string> name = read_choice(place, what, names, findings);
  return name && parse_name(*name, value);
}

// A JSON document; its faults are added to `findings`.
std::optional<JsonNode> parse_json(std::string_view text, Findings& findings);

// The value of a file, or all faults of the file.
template <class Value>
struct Loaded {
  std::optional<Value> value;  // set exactly if there are no diagnostics
  std::vector<Diagnostic> diagnostics;
};

// Why a file cannot be read.
Diagnostic unreadable(const std::filesystem::path& file, const TextFile& read);

// Loads a text by `read(root, findings)`, which returns the value.
template <class Value, class Read>
Loaded<Value> load_text(std::string_view text, const std::filesystem::path& file, Read read) {
  Findings findings(file.generic_string());
  const std::optional<JsonNode> root = parse_json(text, findings);
  Value value;
  if (root) value = read(*root, findings);
  Loaded<Value> loaded;
  loaded.diagnostics = findings.take();
  if (loaded.diagnostics.empty()) loaded.value = std::move(value);
  return loaded;
}

// Paths in a case file: meshes and images must lie in the suite, so that it opens nothing else.

// The file that a string names, relative to `case_file`. It must lie inside the suite: the nearest
// folder named "cases" round the case file or, if there is none, its own folder. Otherwise nothing,
// and a finding. `kind` describes the file: "an OBJ file".
std::optional<std::filesystem::path> find_in_suite(const std::filesystem::path& case_file,
                                                   const Place& place, std::string_view kind,
                                                   Findings& findings);

}  // namespace edgecase
