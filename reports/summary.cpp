// SPDX-License-Identifier: MIT
#include "reports/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "model/renderer.h"
#include "model/text.h"
#include "reports/cluster_summary.h"
#include "reports/painter.h"
#include "reports/text.h"
#include "reports/unexpected_summary.h"
#include "rules/renderer_claims.h"

namespace edgecase {
namespace {

constexpr std::size_t kMaxListed = 20;
constexpr std::size_t kLabelWidth = 12;

// "41 s", and "0.4 s" below ten.
std::string duration_text(double seconds) {
  constexpr double kFew = 9.95;
  return fmt::format("{:.{}f} s", seconds, seconds < kFew ? 1 : 0);
}

// "30,718 cases, 2 renderers: 0 unexpected, 61,400 answers as before, 41 s", in green or, if the
// run fails, in red. Other reasons for failing are added.
std::string first_line(const Results& results, const std::optional<RunCost>& cost,
                       const Painter& paint) {
  std::size_t drawings = 0;
  for (const CaseOutline& one : results.cases.outlines()) drawings += one.expect_failures;
  std::vector<std::string> found;
  const std::size_t unexpected = count_unexpected(results);
  if (!results.diagnostics.empty())
    found.push_back(counted(results.diagnostics.size(), "fault", "faults") + " in case files");
  if (drawings > 0) found.push_back(counted(drawings, "drawing", "drawings") + " not met");
  const auto grown = static_cast<std::size_t>(
      std::ranges::count(results.faults, FaultState::grown, &FaultSeen::state));
  if (grown > 0) found.push_back(counted(grown, "known fault", "known faults") + " grown");
  if (const std::size_t idle = idle_renderers(results).size(); idle > 0)
    found.push_back(counted(idle, "renderer", "renderers") + " drew nothing");
  if (results.interrupted) found.emplace_back("interrupted");
  const bool is_good = unexpected == 0 && found.empty();
  found.insert(found.begin(), grouped(unexpected) + " unexpected");
  if (cost && cost->as_before > 0)
    found.push_back(counted(cost->as_before, "answer", "answers") + " as before");
  if (cost) found.push_back(duration_text(cost->seconds));
  const std::string text = fmt::format("{}, {}: {}", counted(results.cases.size(), "case", "cases"),
                                       counted(results.renderers.size(), "renderer", "renderers"),
                                       fmt::join(found, ", "));
  return paint(style_of(is_good ? Verdict::agree : Verdict::violation), text);
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
    write_images(out, "images", Verdict::agree, &ImageCounts::drawn);
    write_images(out, "refused", Verdict::not_run, &ImageCounts::refused);
  }

 private:
  using Count = std::function<std::size_t(std::size_t renderer)>;

  void write_images(std::ostream& out, const std::string& label, Verdict verdict,
                    int ImageCounts::*counted) const {
    write_row(out, label, style_of(verdict), [&](std::size_t r) {
      std::size_t all = 0;
      for (const CaseOutline& one : results_.cases.outlines())
        all += static_cast<std::size_t>(one.answers[r].images.*counted);
      return all;
    });
  }

  // Nothing if all counts are 0.
  void write_row(std::ostream& out, const std::string& label, fmt::text_style style,
                 const Count& count) const {
    std::size_t all = 0;
    for (std::size_t r = 0; r < names_.size(); ++r) all += count(r);
    if (all == 0) return;
    out << fmt::format("{:<{}}", label, kLabelWidth);
    for (std::size_t r = 0; r < names_.size(); ++r) {
      const std::size_t n = count(r);
      const std::string cell =
          fmt::format("{:>{}}", grouped(n), std::max<std::size_t>(8, names_[r].size()));
      out << "  " << (n > 0 ? paint_(style, cell) : paint_(fmt::emphasis::faint, cell));
    }
    out << '\n';
  }

  const Results& results_;
  const Painter& paint_;
  std::vector<std::string> names_;
};

// The driver whose known faults apply to a recording.
void write_recordings(const Results& results, std::ostream& out) {
  for (const RendererInfo& info : results.renderers)
    if (address_of(info).starts_with(kRecordingPrefix) && known_as(info) != info.name)
      out << fmt::format("{} replays {} ({}, {}), whose known faults hold.\n", one_line(info.name),
                         one_line(known_as(info)), one_line(info.device), one_line(info.version));
}

// A heading and at most kMaxListed lines.
void write_list(std::ostream& out, const std::string& heading,
                const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  out << '\n' << heading << '\n';
  const std::size_t listed = std::min(kMaxListed, lines.size());
  for (std::size_t i = 0; i < listed; ++i) out << "  " << lines[i] << '\n';
  if (listed < lines.size()) out << fmt::format("  and {} more\n", lines.size() - listed);
}

std::vector<std::string> drawn_lines(const Results& results, const Painter& paint) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const CaseOutline& one = results.cases.outline(i);
    if (one.expect_failures == 0) continue;
    for (const std::string& failure : results.cases[i].expect_failures)
      lines.push_back(paint.bold(one_line(one.id)) + " " + one_line(failure));
  }
  return lines;
}

// Known faults whose counts differ from their files.
std::vector<std::string> fault_lines(const Results& results, const Painter& paint) {
  std::vector<std::string> lines;
  for (const FaultSeen& seen : results.faults)
    if (seen.state != FaultState::known)
      lines.push_back(fmt::format("{} {}: {}", paint.bold(one_line(seen.id)),
                                  one_line(seen.renderer), describe(seen)));
  return lines;
}

// "Known: 11 faults of egl:llvmpipe in 207 cases." for each renderer that has some.
void write_known(const Results& results, std::ostream& out) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const std::string& name = results.renderers[r].name;
    const auto faults =
        static_cast<std::size_t>(std::ranges::count_if(results.faults, [&](const FaultSeen& seen) {
          return seen.renderer == name && seen.cases > 0;
        }));
    const auto cases = static_cast<std::size_t>(
        std::ranges::count_if(results.cases.outlines(), [r](const CaseOutline& one) {
          return r < one.answers.size() && !one.answers[r].faults.empty();
        }));
    if (faults > 0)
      out << fmt::format("Known: {} of {} in {}.\n", counted(faults, "fault", "faults"),
                         one_line(name), counted(cases, "case", "cases"));
  }
}

// "Not supported by egl:llvmpipe: 127 cases: REASON" for each of the commonest reasons, where it is
// not said already that the renderer drew nothing.
void write_unsupported(const Results& results, std::ostream& out) {
  constexpr std::size_t kMostReasons = 6;
  constexpr std::size_t kMostBytes = 2000;  // of a reason
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    if (drew_nothing(results, r)) continue;
    const std::vector<Refusal> refusals = refusals_of(results, r);
    const std::string name = one_line(results.renderers[r].name);
    for (std::size_t i = 0; i < std::min(kMostReasons, refusals.size()); ++i)
      out << fmt::format("Not supported by {}: {}: {}.\n", name,
                         counted(refusals[i].cases, "case", "cases"),
                         one_line(shortened(refusals[i].reason, kMostBytes)));
    if (refusals.size() > kMostReasons)
      out << fmt::format("Not supported by {}: {}.\n", name,
                         counted(refusals.size() - kMostReasons, "more reason", "more reasons"));
  }
}

// What all answers of a renderer together say of it.
void write_portraits(const Results& results, const Painter& paint, std::ostream& out) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    for (const std::string& sentence : sentences_of(portrait_of(results, r)))
      out << paint.bold(results.renderers.size() == 1
                            ? sentence
                            : fmt::format("{}: {}", one_line(results.renderers[r].name), sentence))
          << '\n';
}

// Which renderers drew nothing, and why: a line each.
void write_idle(const Results& results, const Painter& paint, std::ostream& out) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    if (drew_nothing(results, r)) out << paint.bold(words_of_idleness(results, r)) << '\n';
}

// The claims that excuse nothing.
void write_refused_claims(const Results& results, std::ostream& out) {
  constexpr std::size_t kMostOfClaim = 300;
  for (const RendererInfo& info : results.renderers)
    for (const std::string& claim : claims_of(info).refused)
      out << fmt::format("Not believed of {}: {}.\n", one_line(info.name),
                         one_line(shortened(claim, kMostOfClaim)));
}

}  // namespace

void write_summary(const Results& results, bool color, std::ostream& out,
                   std::optional<RunCost> cost) {
  const Painter paint(color);
  out << first_line(results, cost, paint) << '\n';
  if (cost && !cost->note.empty()) out << one_line(cost->note) << '\n';
  write_portraits(results, paint, out);
  write_idle(results, paint, out);
  const auto clusters = clusters_of(results);
  write_unexpected(results, clusters, paint, out);

  std::vector<std::string> files;
  for (const Diagnostic& diagnostic : results.diagnostics)
    files.push_back(one_line(to_string(diagnostic)));
  write_list(out, paint.bold("Case files that cannot be loaded:"), files);
  write_list(out, paint.bold("Hand-drawn expectations that the exact side does not meet:"),
             drawn_lines(results, paint));
  write_list(out, paint.bold("Known faults that are not as their files say (`edgecase bless`):"),
             fault_lines(results, paint));
  if (results.interrupted) out << '\n' << paint.bold(words_of_interruption(results)) << '\n';
  if (results.cases.empty()) return;
  out << '\n';
  Table(results, paint).write(out);
  write_recordings(results, out);
  write_refused_claims(results, out);
  write_known(results, out);
  write_unsupported(results, out);
  write_clusters(results, clusters, paint, out);
}

void write_changes(const Comparison& comparison, bool color, std::ostream& out) {
  constexpr std::size_t kMostGroups = 10;
  const Painter paint(color);
  for (const RendererComparison& renderer : comparison.renderers) {
    out << '\n'
        << paint.bold(fmt::format("Changed since, {}: {} of {}", one_line(renderer.after),
                                  renderer.cases.size(),
                                  counted(renderer.same + renderer.cases.size(), "case", "cases")))
        << '\n';
    for (std::size_t i = 0; i < std::min(kMostGroups, renderer.clusters.size()); ++i) {
      const ChangeCluster& cluster = renderer.clusters[i];
      out << fmt::format("  {}: {}{}{}: {}, first {}\n", describe(cluster.change),
                         one_line(cluster.rule), cluster.cause.empty() ? "" : ", ",
                         one_line(cluster.cause), counted(cluster.cases, "case", "cases"),
                         one_line(cluster.first_case));
    }
    if (renderer.clusters.size() > kMostGroups)
      out << fmt::format("  and {} more\n", renderer.clusters.size() - kMostGroups);
  }
}

}  // namespace edgecase
