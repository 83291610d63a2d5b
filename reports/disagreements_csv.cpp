// SPDX-License-Identifier: MIT
#include "reports/disagreements_csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "model/text.h"
#include "reports/text.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// A text as one field, quoted if it contains a delimiter. An apostrophe is put before a text that a
// spreadsheet would take for a formula.
std::string field(const std::string& raw) {
  std::string text = xml_text(raw);
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
    text.insert(0, "'");
  if (text.find_first_of(",\"\n\t") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string numbers(const std::vector<double>& values) {
  return fmt::format("{}", fmt::join(values, " "));
}

struct Row {
  const std::string& id;  // this and the next two as fields
  const std::string& renderer;
  const std::string& file;
  const Result& result;
  const Disagreement& d;
};

struct Column {
  const char* name;
  std::string (*text)(const Row&);
};

constexpr Column kColumns[] = {
    {"case", [](const Row& row) { return row.id; }},
    {"renderer", [](const Row& row) { return row.renderer; }},
    {"verdict", [](const Row& row) { return std::string(name_of(row.result.verdict)); }},
    {"standing", [](const Row& row) { return std::string(name_of(row.result.standing)); }},
    {"x", [](const Row& row) { return std::to_string(row.d.x); }},
    {"y", [](const Row& row) { return std::to_string(row.d.y); }},
    {"sample", [](const Row& row) { return std::to_string(row.d.sample); }},
    {"primitive", [](const Row& row) { return std::to_string(row.d.primitive); }},
    {"kind", [](const Row& row) { return std::string(name_of(row.d.kind)); }},
    {"rule", [](const Row& row) { return field(name_of(row.d.rule)); }},
    {"legality", [](const Row& row) { return std::string(name_of(row.d.legality)); }},
    {"ruling", [](const Row& row) { return std::to_string(row.d.ruling); }},
    {"cause", [](const Row& row) { return field(text_of(row.d.cause)); }},
    {"situation", [](const Row& row) { return field(row.d.situation); }},
    {"exact", [](const Row& row) { return numbers(row.d.exact); }},
    {"rendered", [](const Row& row) { return numbers(row.d.rendered); }},
    {"explanation", [](const Row& row) { return field(row.d.explanation); }},
    {"file", [](const Row& row) { return row.file; }},
};

// The texts of all columns as one line.
template <class Text>
void write_line(std::ostream& out, const Text& text) {
  const char* before = "";
  for (const Column& column : kColumns) {
    out << before << text(column);
    before = ",";
  }
  out << "\r\n";
}

void write_row(std::ostream& out, const Row& row) {
  write_line(out, [&](const Column& column) { return column.text(row); });
}

// Stands for all of the class: at the first pixel, and told with their number.
Disagreement first_of(const CountedDisagreements& counted) {
  Disagreement d;
  static_cast<DisagreementClass&>(d) = counted;
  d.x = counted.runs.front().begin;
  d.y = counted.runs.front().y;
  d.explanation = fmt::format("{} of this kind, from this pixel on, are only counted",
                              grouped(counted.count()));
  return d;
}

}  // namespace

void write_disagreements_csv(const Results& results, std::ostream& out) {
  write_line(out, [](const Column& column) { return column.name; });
  std::vector<std::string> names;
  for (const RendererInfo& info : results.renderers) names.push_back(field(info.name));
  for (const CaseResults& one : results.cases) {
    const std::string id = field(one.id);
    const std::string file = field(one.file);
    for (std::size_t r = 0; r < one.results.size() && r < names.size(); ++r) {
      const Result& result = one.results[r];
      for (const Disagreement& d : result.disagreements)
        write_row(out, {id, names[r], file, result, d});
      for (const CountedDisagreements& counted : result.counted)
        write_row(out, {id, names[r], file, result, first_of(counted)});
    }
  }
}

}  // namespace edgecase
