// SPDX-License-Identifier: MIT
#include "casefile/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "casefile/json/text.h"

namespace edgecase {

namespace {

void read_variant(const Place& place, const Variants& variants, Findings& findings, When& when) {
  if (!expect_kind(place, JsonKind::string, "a variant", findings)) return;
  std::vector<std::string> parts;
  for (const Image& image : variants.images)
    if (image.kind != VariantKind::none) parts.push_back(image.part());
  when.variant = place.node->text;
  if (std::find(parts.begin(), parts.end(), when.variant) != parts.end()) return;
  findings.add(place, fmt::format("the file has no variant {}", quote(when.variant)),
               parts.empty() ? "add \"variants\"" : suggest_names(when.variant, parts));
}

void read_member(const Place& place, const Sweep& sweep, Findings& findings, When& when) {
  std::vector<std::string> names{"variant"};
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    names.push_back(sweep.axes[a].name);
    if (sweep.axes[a].name != place.node->name) continue;
    if (const auto value = read_value_of(place, sweep.axes[a], findings))
      when.values.emplace_back(a, *value);
    return;
  }
  findings.add_key(place, fmt::format("the file has no axis {}", quote(place.node->name)),
                   suggest_names(place.node->name, names));
}

void read_when(const Place& place, const Sweep& sweep, const Variants& variants, Findings& findings,
               When& when) {
  when.place = place;
  when.given = true;
  if (!expect_kind(place, JsonKind::object, "when", findings)) return;
  if (place.node->children.empty())
    findings.add(place, "when is empty", "name an axis and its value, or remove it");
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place member = place.child(i);
    if (member.node->duplicate) continue;
    if (member.node->name == "variant")
      read_variant(member, variants, findings, when);
    else
      read_member(member, sweep, findings, when);
  }
}

}  // namespace

std::vector<When> read_conditions(const Place& expect, const Sweep& sweep, const Variants& variants,
                                  Findings& findings) {
  std::vector<When> result;
  if (expect.node->kind != JsonKind::array) return result;
  for (std::size_t i = 0; i < expect.node->children.size(); ++i) {
    When when;
    when.place = expect.child(i);
    const JsonNode& drawing = *when.place.node;
    const Place item = when.place;
    for (std::size_t k = 0; drawing.kind == JsonKind::object && k < drawing.children.size(); ++k)
      if (drawing.children[k].name == "when" && !drawing.children[k].duplicate)
        read_when(item.child(k), sweep, variants, findings, when);
    result.push_back(std::move(when));
  }
  return result;
}

bool holds(const When& when, const Sweep& sweep, const Combination& combination,
           const Image& image) {
  if (!when.given) return image.kind == VariantKind::none && combination == base_of(sweep);
  return image.part() == when.variant &&
         std::all_of(when.values.begin(), when.values.end(),
                     [&](const auto& value) { return combination[value.first] == value.second; });
}

namespace {

using Masks = std::vector<std::uint32_t>;

std::vector<std::string_view> cells_of(std::string_view row) {
  std::vector<std::string_view> cells;
  for (std::size_t start = row.find_first_not_of(' '); start != row.npos;
       start = row.find_first_not_of(' ', start)) {
    const std::size_t end = std::min(row.find(' ', start), row.size());
    cells.push_back(row.substr(start, end - start));
    start = end;
  }
  return cells;
}

// Up to four hexadecimal digits, enough for 16 samples.
std::optional<std::uint32_t> parse_mask(std::string_view cell) {
  constexpr std::size_t kMostDigits = 4;
  std::uint32_t mask = 0;
  const char* end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, mask, 16);
  if (error != std::errc() || stop != end || cell.size() > kMostDigits) return std::nullopt;
  return mask;
}

std::uint32_t read_cell(const Place& row, std::string_view cell, int samples, Findings& findings) {
  if (cell == ".") return 0;
  const auto mask = parse_mask(cell);
  if (!mask) {
    findings.add(row, fmt::format("a row has the unknown cell {}", quote(cell)),
                 "write a mask in hexadecimal digits, or . for none");
    return 0;
  }
  const std::uint32_t all = (1U << (samples > 0 ? samples : kMaxSamples)) - 1;
  if (*mask == 0)
    findings.add(row, "a row has the mask 0", "write . where no sample is covered");
  else if (*mask > all)
    findings.add(row,
                 fmt::format("a row has the mask {:x}, and the target {} samples", *mask, samples),
                 fmt::format("write 1 to {:x}, or . for none", all));
  return *mask;
}

Masks read_row(const Place& place, const Target& target, Findings& findings) {
  Masks masks;
  if (!expect_kind(place, JsonKind::string, "a row of a drawing", findings)) return masks;
  const std::vector<std::string_view> cells = cells_of(place.node->text);
  if (target.width > 0 && cells.size() != static_cast<std::size_t>(target.width))
    findings.add(
        place,
        fmt::format("a row has {} cells, and the target is {} wide", cells.size(), target.width),
        fmt::format("draw {} cells, separated by blanks", target.width));
  for (const std::string_view cell : cells)
    masks.push_back(read_cell(place, cell, target.samples, findings));
  return masks;
}

// Returns masks row by row from the bottom. A size or number of samples that is 0 in `target` is
// unknown and not checked.
std::vector<std::uint32_t> read_masks(const Place& place, const Target& target,
                                      Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "masks", findings)) return {};
  const std::size_t height = place.node->children.size();
  if (target.height > 0 && height != static_cast<std::size_t>(target.height))
    findings.add(
        place, fmt::format("the drawing has {} rows, and the target has {}", height, target.height),
        fmt::format("draw {} rows, the top one first", target.height));
  Masks result;
  for (std::size_t i = height; i-- > 0;) {
    const Masks row = read_row(place.child(i), target, findings);
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

const Keys kExpectKeys{{}, {"policy", "when", "coverage", "coverage_file", "masks"}, {"values"}};

// One row of a drawing and its place for messages.
struct Row {
  std::string text;
  Place place;
};

// The number of hits for a character of a drawing, or -1.
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

// Converts rows, top first, to hits, bottom first. Rows of a file are named by their number.
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

// The path of the drawing's file, if it lies inside the case's folder.
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
  // A row may end in two characters; a little more suffices to detect a file that is too long.
  constexpr std::size_t kMaxDrawingBytes = (std::size_t{4096} + 2) * 4096 + 2;
  const TextFile file = read_text_file(*path, kMaxDrawingBytes);
  if (!file.text) {
    findings.add(place, fmt::format("{}: {}", quote(place.node->text), file.message), file.remedy);
    return;
  }
  expect.coverage = rows_to_hits(rows_of_text(*file.text, place), place, target, findings);
}

// The single drawing of an expectation, in the form that the target's samples need. Otherwise
// nothing, and a finding.
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
    expect.policy = read_text(*policy, "a policy's name", kNameLimits, findings).value_or("");
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
