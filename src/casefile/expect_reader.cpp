// SPDX-License-Identifier: MIT
#include "casefile/expect_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "casefile/mask_drawing.h"
#include "casefile/text.h"
#include "casefile/text_file.h"

namespace edgecase {
namespace {

const Keys kExpectKeys{{}, {"policy", "when", "coverage", "coverage_file", "masks"}, {"values"}};

// One row of a drawing and the place that messages about it name.
struct Row {
  std::string text;
  Place place;
};

// Hits that a character of a drawing stands for, or -1.
int hits_of(char c) {
  if (c == '.') return 0;
  if (c == '#') return 1;
  return c >= '2' && c <= '9' ? c - '0' : -1;
}

void check_row(const Row& row, const std::string& name, const Target& target, Findings& findings) {
  const auto odd =
      std::find_if(row.text.begin(), row.text.end(), [](char c) { return hits_of(c) < 0; });
  if (odd != row.text.end())
    findings.add(
        row.place,
        fmt::format("{} has an unknown character in column {}", name, odd - row.text.begin() + 1),
        "draw with . for none, # for one hit, 2 to 9 for more");
  const auto is_start = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto width = std::count_if(row.text.begin(), row.text.end(), is_start);
  if (target.width > 0 && width != target.width)
    findings.add(row.place,
                 fmt::format("{} is {} wide, and the target is {}", name, width, target.width),
                 fmt::format("draw {} characters", target.width));
}

// Turns rows, top first, into hits, bottom first. Rows of a file are named by their number.
std::vector<int> rows_to_hits(const std::vector<Row>& rows, const Place& drawing,
                              const Target& target, Findings& findings) {
  if (target.height > 0 && rows.size() != static_cast<std::size_t>(target.height))
    findings.add(
        drawing,
        fmt::format("the drawing has {} rows, and the target has {}", rows.size(), target.height),
        fmt::format("draw {} rows, the top one first", target.height));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool in_file = drawing.node->kind == JsonKind::string;
    check_row(rows[i], in_file ? fmt::format("row {} of the file", i + 1) : "a row", target,
              findings);
  }
  std::vector<int> hits;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : row->text) hits.push_back(hits_of(c));
  return hits;
}

std::vector<Row> rows_of_array(const Place& place, Findings& findings) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place row = place.child(i);
    if (expect_kind(row, JsonKind::string, "a row of a drawing", findings))
      rows.push_back({row.node->text, row});
  }
  return rows;
}

// The path of the drawing's file, when it lies inside the case's folder.
std::optional<std::filesystem::path> resolve(const Place& place,
                                             const std::filesystem::path& folder,
                                             Findings& findings) {
  const std::filesystem::path relative(place.node->text);
  const std::filesystem::path base = folder.empty() ? std::filesystem::path(".") : folder;
  std::error_code error;
  const auto root = std::filesystem::weakly_canonical(base, error);
  const auto file = std::filesystem::weakly_canonical(base / relative, error);
  const auto end = std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first;
  if (!error && !relative.empty() && relative.is_relative() && end == root.end()) return file;
  findings.add(place, fmt::format("{} leaves the case's folder", quote(place.node->text)),
               "name a file beside the case file or below it");
  return std::nullopt;
}

std::vector<Row> rows_of_text(const std::string& text, const Place& place) {
  std::vector<Row> rows;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string row = text.substr(start, end - start);
    if (row.ends_with('\r')) row.pop_back();
    rows.push_back({std::move(row), place});
    start = end + 1;
  }
  return rows;
}

void read_drawing_file(const Place& place, const Target& target,
                       const std::filesystem::path& folder, Findings& findings, Expect& expect) {
  if (!expect_kind(place, JsonKind::string, "coverage_file", findings)) return;
  const auto path = resolve(place, folder, findings);
  if (!path) return;
  // Every row may end in two characters; a little more tells a file that is too long.
  constexpr std::size_t kMaxDrawingBytes = (std::size_t{4096} + 2) * 4096 + 2;
  const TextFile file = read_text_file(*path, kMaxDrawingBytes);
  if (!file.text) {
    findings.add(place, fmt::format("{}: {}", quote(place.node->text), file.message), file.remedy);
    return;
  }
  expect.coverage = rows_to_hits(rows_of_text(*file.text, place), place, target, findings);
}

// The one drawing that an expectation must have, as fits the target's samples; none, and a finding,
// where there is no such.
std::optional<Place> find_drawing(const Place& place, const ObjectReader& object, int samples,
                                  Findings& findings) {
  std::optional<Place> drawing;
  for (const char* name : {"coverage", "coverage_file", "masks"}) {
    const auto found = object.find(name);
    if (!found) continue;
    if (drawing) {
      findings.add(
          place,
          fmt::format("an expectation has both {} and {}", quote(drawing->node->name), quote(name)),
          "give exactly one of them");
      return std::nullopt;
    }
    drawing = found;
  }
  if (!drawing) {
    findings.add(place, "an expectation has no drawing",
                 "add \"coverage\", \"coverage_file\" or, of several samples, \"masks\"");
    return std::nullopt;
  }
  const bool masks = drawing->node->name == "masks";
  if (samples == 0 || masks == (samples > 1)) return drawing;
  findings.add_key(*drawing,
                   masks ? "\"masks\" tells several samples apart, and the target has 1"
                         : fmt::format("{} cannot tell the target's {} samples apart",
                                       quote(drawing->node->name), samples),
                   masks ? "draw \"coverage\"" : "draw \"masks\"");
  return std::nullopt;
}

}  // namespace

Expect read_drawing(const Place& place, const Target& target, const std::filesystem::path& folder,
                    Findings& findings) {
  Expect expect;
  const ObjectReader object(place, "an expectation", kExpectKeys, findings);
  if (!object.valid()) return expect;
  if (const auto policy = object.find("policy"))
    expect.policy = read_text(*policy, "a policy's name", {1, 100}, findings).value_or("");
  const auto drawing = find_drawing(place, object, target.samples, findings);
  if (!drawing) return expect;
  expect.where = fmt::format("{}:{}: {}", findings.file(), drawing->node->line, drawing->pointer);
  const std::string& name = drawing->node->name;
  if (name == "coverage_file") {
    read_drawing_file(*drawing, target, folder, findings, expect);
  } else if (name == "masks") {
    expect.masks = read_masks(*drawing, target, findings);
  } else if (expect_kind(*drawing, JsonKind::array, "coverage", findings)) {
    const std::size_t before = findings.size();
    const std::vector<Row> rows = rows_of_array(*drawing, findings);
    if (findings.size() == before) expect.coverage = rows_to_hits(rows, *drawing, target, findings);
  }
  return expect;
}

}  // namespace edgecase
