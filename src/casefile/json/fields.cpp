// SPDX-License-Identifier: MIT
#include "casefile/json/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "casefile/json/text.h"

namespace edgecase {

namespace {

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const char* name_of(JsonKind kind) {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return "true or false";
    case JsonKind::number:
      return "a number";
    case JsonKind::string:
      return "a string";
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "a value";
}

const char* remedy_for(JsonKind kind) {
  switch (kind) {
    case JsonKind::number:
      return "write a number without quotes";
    case JsonKind::string:
      return "write it in double quotes";
    case JsonKind::array:
      return "write it as a list in [ ]";
    case JsonKind::object:
      return "write it as {\"key\": value}";
    case JsonKind::null:
    case JsonKind::boolean:
      break;
  }
  return "write true or false";
}

bool is_control(char c) {
  return (c >= 0 && c < 0x20) || c == 0x7F;
}

}  // namespace

Place Place::child(std::size_t index) const {
  const JsonNode& found = node->children[index];
  const std::string part =
      node->kind == JsonKind::object ? escape_pointer(found.name) : std::to_string(index);
  return {&found, pointer + "/" + part};
}

void Findings::add(const Place& place, std::string message, std::string remedy) {
  diagnostics_.push_back(
      {file_, place.node->line, place.pointer, std::move(message), std::move(remedy)});
}

void Findings::add_key(const Place& place, std::string message, std::string remedy) {
  diagnostics_.push_back(
      {file_, place.node->name_line, place.pointer, std::move(message), std::move(remedy)});
}

void Findings::note(const Place& place, std::string message) {
  // For the vertices of a mesh, one note suffices.
  const bool told =
      !notes_.empty() && notes_.back().pointer == place.pointer && notes_.back().message == message;
  if (told) return;
  notes_.push_back({file_, place.node->line, place.pointer, std::move(message), ""});
}

std::vector<Diagnostic> Findings::take() {
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  return std::move(diagnostics_);
}

ObjectReader::ObjectReader(const Place& place, std::string_view what, const Keys& keys,
                           Findings& findings)
    : place_(place), valid_(expect_kind(place, JsonKind::object, what, findings)) {
  if (valid_) check_keys(what, keys, findings);
}

void ObjectReader::check_keys(std::string_view what, const Keys& keys, Findings& findings) const {
  std::vector<std::string> known = keys.required;
  known.insert(known.end(), keys.optional.begin(), keys.optional.end());
  for (std::size_t i = 0; i < place_.node->children.size(); ++i) {
    const Place member = place_.child(i);
    const std::string& name = member.node->name;
    if (member.node->duplicate || contains(known, name)) continue;
    if (contains(keys.later, name)) {
      findings.add_key(member, fmt::format("{} is not supported yet", quote(name)),
                       "remove it, or keep the case for a later version");
    } else {
      findings.add_key(member, fmt::format("{} is no key of {}", quote(name), what),
                       suggest_names(name, known));
    }
  }
  for (const std::string& name : keys.required)
    if (place_.node->find(name) == nullptr)
      findings.add(place_, fmt::format("{} lacks {}", what, quote(name)),
                   fmt::format("add \"{}\": ...", name));
}

std::optional<Place> ObjectReader::find(std::string_view name) const {
  if (!valid_) return std::nullopt;
  for (std::size_t i = 0; i < place_.node->children.size(); ++i)
    if (place_.node->children[i].name == name) return place_.child(i);
  return std::nullopt;
}

bool expect_kind(const Place& place, JsonKind kind, std::string_view what, Findings& findings) {
  if (place.node->kind == kind) return true;
  findings.add(place,
               fmt::format("{} must be {}, not {}", what, name_of(kind), describe(*place.node)),
               remedy_for(kind));
  return false;
}

std::optional<std::string> read_text(const Place& place, std::string_view what, TextLimits limits,
                                     Findings& findings) {
  if (!expect_kind(place, JsonKind::string, what, findings)) return std::nullopt;
  const std::string& text = place.node->text;
  const std::size_t count = count_characters(text);
  if (count < limits.least || count > limits.most) {
    findings.add(place, fmt::format("{} has {} characters", what, count),
                 fmt::format("write {} to {} characters", limits.least, limits.most));
    return std::nullopt;
  }
  const bool clean = std::none_of(text.begin(), text.end(), [&](char c) {
    return is_control(c) && !(limits.lines && (c == '\n' || c == '\t'));
  });
  if (!clean) {
    findings.add(place, fmt::format("{} holds a control character", what), "remove it");
    return std::nullopt;
  }
  return text;
}

std::optional<std::string> read_choice(const Place& place, std::string_view what,
                                       const Names& names, Findings& findings) {
  if (!expect_kind(place, JsonKind::string, what, findings)) return std::nullopt;
  const std::string& name = place.node->text;
  if (contains(names.allowed, name)) return name;
  if (contains(names.later, name)) {
    findings.add(place, fmt::format("{} {} is not supported yet", what, quote(name)),
                 "use " + join_names(names.allowed));
  } else {
    findings.add(place, fmt::format("{} cannot be {}", what, quote(name)),
                 suggest_names(name, names.allowed));
  }
  return std::nullopt;
}

std::optional<JsonNode> parse_json(std::string_view text, Findings& findings) {
  JsonDocument document = parse_json(text, findings.file());
  for (Diagnostic& diagnostic : document.diagnostics) findings.add(std::move(diagnostic));
  return std::move(document.root);
}

Diagnostic unreadable(const std::filesystem::path& file, const TextFile& read) {
  return {file.generic_string(), 0, "", read.message, read.remedy};
}

namespace {

namespace fs = std::filesystem;

fs::path suite_of(const fs::path& folder) {
  for (fs::path at = folder; at != at.root_path() && !at.empty(); at = at.parent_path())
    if (at.filename() == "cases") return at;
  return folder;
}

}  // namespace

std::optional<fs::path> find_in_suite(const fs::path& case_file, const Place& place,
                                      std::string_view kind, Findings& findings) {
  const fs::path relative(place.node->text);
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(case_file, error), error).parent_path();
  const fs::path root = suite_of(folder);
  const fs::path file = fs::weakly_canonical(folder / relative, error);
  const auto end = std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first;
  if (!error && !relative.empty() && relative.is_relative() && end == root.end()) return file;
  findings.add(place, fmt::format("{} leaves the folder of the cases", quote(place.node->text)),
               fmt::format("name {} of the suite, by its path from the case file", kind));
  return std::nullopt;
}

}  // namespace edgecase
