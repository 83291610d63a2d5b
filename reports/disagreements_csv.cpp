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

// The columns up to the verdict's standing, which all rows of a result share.
std::string begin_row(const std::string& id, const std::string& renderer, const Result& result) {
  return fmt::format("{},{},{},{}", id, renderer, name_of(result.verdict),
                     name_of(result.standing));
}

std::string row(const Disagreement& d) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", d.x, d.y, d.sample, d.primitive,
                     name_of(d.kind), field(name_of(d.rule)), name_of(d.legality), d.ruling,
                     field(text_of(d.cause)), field(d.situation), numbers(d.exact),
                     numbers(d.rendered), field(d.explanation));
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
  out << "case,renderer,verdict,standing,x,y,sample,primitive,kind,rule,legality,ruling,cause,"
         "situation,exact,rendered,explanation,file\r\n";
  std::vector<std::string> names;
  for (const RendererInfo& info : results.renderers) names.push_back(field(info.name));
  for (const CaseResults& one : results.cases) {
    const std::string id = field(one.id);
    const std::string file = field(one.file);
    for (std::size_t r = 0; r < one.results.size() && r < names.size(); ++r) {
      const std::string begin = begin_row(id, names[r], one.results[r]);
      for (const Disagreement& d : one.results[r].disagreements)
        out << begin << ',' << row(d) << ',' << file << "\r\n";
      for (const CountedDisagreements& counted : one.results[r].counted)
        out << begin << ',' << row(first_of(counted)) << ',' << file << "\r\n";
    }
  }
}

}  // namespace edgecase
