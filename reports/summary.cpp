// SPDX-License-Identifier: MIT
#include "reports/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "model/recorded.h"
#include "reports/cluster_summary.h"
#include "reports/painter.h"
#include "reports/text.h"
#include "results/worst_first.h"

namespace edgecase {
namespace {

constexpr std::size_t kMaxListed = 20;
constexpr std::size_t kLabelWidth = 12;
constexpr Verdict kWorstFirst[] = {Verdict::violation,  Verdict::contested, Verdict::permitted,
                                   Verdict::convention, Verdict::agree,     Verdict::not_run};

std::size_t count_unexpected(const Results& results, std::size_t renderer) {
  const auto stands_out = [renderer](const CaseResults& one) {
    return renderer < one.results.size() && is_unexpected(one.results[renderer].standing);
  };
  return static_cast<std::size_t>(
      std::count_if(results.cases.begin(), results.cases.end(), stands_out));
}

class Table {
 public:
  Table(const Results& results, const Painter& paint) : results_(results), paint_(paint) {
    for (const RendererInfo& renderer : results.renderers)
      names_.push_back(one_line(renderer.name));
  }

  void write(std::ostream& out) const {
    out << std::string(kLabelWidth, ' ');
    for (const std::string& name : names_) out << "  " << paint_.bold(fmt::format("{:>8}", name));
    out << '\n';
    for (Verdict verdict : kWorstFirst)
      write_row(out, name_of(verdict), style_of(verdict), [&](std::size_t r) {
        const auto counts = count_verdicts(results_, r);
        const auto found = counts.find(verdict);
        return found == counts.end() ? std::size_t{0} : found->second;
      });
    write_row(out, "unexpected", style_of(Verdict::violation),
              [&](std::size_t r) { return count_unexpected(results_, r); });
  }

 private:
  using Count = std::function<std::size_t(std::size_t renderer)>;

  void write_row(std::ostream& out, const std::string& label, fmt::text_style style,
                 const Count& count) const {
    out << fmt::format("{:<{}}", label, kLabelWidth);
    for (std::size_t r = 0; r < names_.size(); ++r) {
      const std::size_t n = count(r);
      const std::string cell = fmt::format("{:>{}}", n, std::max<std::size_t>(8, names_[r].size()));
      out << "  " << (n > 0 ? paint_(style, cell) : paint_(fmt::emphasis::faint, cell));
    }
    out << '\n';
  }

  const Results& results_;
  const Painter& paint_;
  std::vector<std::string> names_;
};

// Whose expectations hold for a recording's answers.
void write_recordings(const Results& results, std::ostream& out) {
  for (const RendererInfo& info : results.renderers)
    if (known_as(info) != info.name)
      out << fmt::format("{} replays {} ({}, {}), whose expectations hold.\n", one_line(info.name),
                         one_line(known_as(info)), one_line(info.device), one_line(info.version));
}

// A heading and at most kMaxListed of the lines.
void write_list(std::ostream& out, const std::string& heading,
                const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  out << '\n' << heading << '\n';
  const std::size_t listed = std::min(kMaxListed, lines.size());
  for (std::size_t i = 0; i < listed; ++i) out << "  " << lines[i] << '\n';
  if (listed < lines.size()) out << fmt::format("  and {} more\n", lines.size() - listed);
}

std::string unexpected_line(const Results& results, const CaseResults& one, std::size_t renderer,
                            const Painter& paint) {
  const Result& result = one.results[renderer];
  const std::string name =
      renderer < results.renderers.size() ? results.renderers[renderer].name : "?";
  std::string line = fmt::format("{} {} {}, {}", paint.bold(one_line(one.id)), one_line(name),
                                 paint(style_of(result.verdict), name_of(result.verdict)),
                                 name_of(result.standing));
  if (result.standing == Standing::flake) line += ": " + one_line(result.expectation);
  const std::string explanation = one_line(first_explanation(result, one.samples.samples));
  return explanation.empty() ? line : line + "\n      " + explanation;
}

std::vector<std::string> unexpected_lines(const Results& results, const Painter& paint) {
  std::vector<std::string> lines;
  for (const auto& [i, r] : worst_first(
           results, [](const KnownResult& result) { return is_unexpected(result.standing); }))
    lines.push_back(unexpected_line(results, results.cases[i], r, paint));
  return lines;
}

std::vector<std::string> drawn_lines(const Results& results, const Painter& paint) {
  std::vector<std::string> lines;
  for (const CaseResults& one : results.cases)
    for (const std::string& failure : one.expect_failures)
      lines.push_back(paint.bold(one_line(one.id)) + " " + one_line(failure));
  return lines;
}

std::vector<std::string> missing_lines(const Results& results, const Painter& paint) {
  std::vector<std::string> lines;
  for (const MissingCase& missing : results.missing)
    lines.push_back(fmt::format("{} {}, expected {}", paint.bold(one_line(missing.id)),
                                one_line(missing.renderer), name_of(missing.expected.verdict)));
  return lines;
}

}  // namespace

void write_summary(const Results& results, bool color, std::ostream& out) {
  const Painter paint(color);
  Table(results, paint).write(out);
  write_recordings(results, out);
  write_clusters(results, paint, out);

  std::vector<std::string> files;
  for (const Diagnostic& diagnostic : results.diagnostics)
    files.push_back(one_line(to_string(diagnostic)));
  write_list(out, paint.bold("Case files that cannot be loaded:"), files);
  write_list(out, paint.bold("Hand-drawn expectations that the exact side does not meet:"),
             drawn_lines(results, paint));
  write_list(out,
             paint.bold("Expectations of cases that the suite has no more; `edgecase bless "
                        "--apply` removes them:"),
             missing_lines(results, paint));
  write_list(out, paint.bold("Unexpected:"), unexpected_lines(results, paint));
  if (results.interrupted) out << '\n' << paint.bold(words_of_interruption(results)) << '\n';
}

}  // namespace edgecase
