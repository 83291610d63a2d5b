// SPDX-License-Identifier: MIT
#include "diff/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "diff/coverage/cause.h"
#include "diff/coverage/legality.h"
#include "diff/upside_down.h"
#include "diff/verdicts.h"
#include "model/fnv.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

using Counts = std::map<AlternativeId, std::ptrdiff_t>;

// "line", "triangle": rules of one subject decide on the same primitives.
std::string subject_of(RuleId rule) {
  const std::string name = name_of(rule);
  return name.substr(0, name.find('.'));
}

// Of a primitive that single alternatives explain, all others of their subject.
void read_missed(const Result::Evidence& evidence, AlternativeSet& missed) {
  std::set<AlternativeId> singles;
  std::set<std::string> subjects;
  for (const Cause& cause : evidence.causes) {
    if (cause.size() != 1) continue;
    singles.insert(cause.parts.front());
    subjects.insert(subject_of(cause.rule()));
  }
  if (singles.empty()) return;
  for (const RuleId rule : coverage_rules()) {
    if (!subjects.contains(subject_of(rule))) continue;
    for (std::size_t i = 0; i < rule_of(rule).alternatives.size(); ++i)
      if (const AlternativeId id{rule, static_cast<std::uint8_t>(i)}; !singles.contains(id))
        missed.add(id);
  }
}

// Adds to RunReading::alternatives, refuted and missed. A primitive of several passes counts once.
void read_alternatives(const Result& result, RunReading& reading) {
  Counts& counts = reading.alternatives;
  std::set<std::pair<int, AlternativeId>> helpful;
  for (const Result::Evidence& evidence : result.evidence)
    for (const Cause& cause : evidence.causes)
      for (const AlternativeId part : cause.parts) helpful.emplace(evidence.primitive, part);
  for (const auto& [primitive, part] : helpful) ++counts[part];
  for (const Result::Evidence& evidence : result.evidence) read_missed(evidence, reading.missed);
  result.refuted.for_each([&](AlternativeId id) {
    --counts[id];
    reading.refuted.add(id);
  });
}

// An alternative that the run does not mention counts 0.
std::ptrdiff_t count_of(const Counts& counts, AlternativeId alternative) {
  const auto found = counts.find(alternative);
  return found == counts.end() ? 0 : found->second;
}

// True if the evidence is about the same primitive and pass as the disagreement.
bool is_of(const DisagreementClass& d, const Result::Evidence& evidence) {
  return d.primitive == evidence.primitive && (evidence.pass < 0 || d.sample == evidence.pass);
}

// True if the drawn primitive is legal, with lines read under `reading`.
bool is_legal(const Result& result, const Result::Evidence& evidence, const std::string& reading) {
  return !any_class(result, [&](const DisagreementClass& d) {
    if (!is_of(d, evidence) || d.policy_agrees) return false;
    if (d.kind == DisagreementKind::value) return false;
    return is_about_a_line(d) ? contains(evidence.illegal_line_snaps, reading) : !is_legal(d);
  });
}

// True if more of the run speaks for each of these alternatives than against it.
bool is_followed(const Cause& cause, const Counts& counts) {
  return std::ranges::all_of(cause.parts,
                             [&](AlternativeId part) { return count_of(counts, part) > 0; });
}

// How many primitives of the run the alternatives of a cause help to explain, on average.
double support_of(const Cause& cause, const Counts& counts) {
  std::ptrdiff_t sum = 0;
  for (const AlternativeId part : cause.parts) sum += count_of(counts, part);
  return static_cast<double>(sum) / static_cast<double>(cause.size());
}

// True if an agreeing case of the run refutes one of these alternatives.
bool is_refuted(const Cause& cause, const RunReading& reading) {
  return std::ranges::any_of(cause.parts,
                             [&](AlternativeId part) { return reading.refuted.contains(part); });
}

// The largest support among faults of the candidates that no case of the run refutes. A renderer
// with such a fault sometimes draws, by chance, what an open choice draws; elsewhere in the run
// that choice is refuted.
double most_support_of_a_fault(const Result::Evidence& evidence, const RunReading& reading) {
  double most = 0;
  for (const Cause& cause : evidence.causes)
    if (!is_open_choice(cause) && !is_refuted(cause, reading))
      most = std::max(most, support_of(cause, reading.alternatives));
  return most;
}

bool is_snap_rule(RuleId rule) {
  return std::ranges::any_of(values_of<PrimitiveKind>(),
                             [&](PrimitiveKind kind) { return snap_rule_of(kind) == rule; });
}

// True if the cause has a grid of vertices of the reported precision.
bool has_reported_precision(const Cause& cause, int subpixel_bits) {
  return std::ranges::any_of(cause.parts, [&](AlternativeId part) {
    if (!is_snap_rule(part.rule)) return false;
    const Snap* const snap = find_snap(alternative_of(part)->name);
    return snap != nullptr && snap->bits == subpixel_bits;
  });
}

// The candidate whose alternatives explain most of the run, on average; of several, one of the
// reported precision, then the first. For a legal drawing, an alternative that the specification
// leaves open comes before one that it does not. If it is not among the smallest candidates, the
// renderer must follow it elsewhere; if the run refutes it, no unrefuted fault may explain more.
// Illegal drawings, such as a hole in a shared edge, are evidence for neither.
Cause choose_cause(const Result::Evidence& evidence, bool legal, const RunReading& reading) {
  const Counts& counts = reading.alternatives;
  const Cause* best = nullptr;
  std::tuple most{false, -std::numeric_limits<double>::infinity(), false};
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Cause& cause : evidence.causes) least = std::min(least, cause.size());
  const double fault = most_support_of_a_fault(evidence, reading);
  for (const Cause& cause : evidence.causes) {
    const double support = support_of(cause, counts);
    const bool likely = cause.size() == least || is_followed(cause, counts);
    const bool outdone = fault > 0 && support < fault && is_refuted(cause, reading);
    const std::tuple score{legal && likely && !outdone && is_open_choice(cause), support,
                           has_reported_precision(cause, reading.subpixel_bits)};
    if (score <= most) continue;
    most = score;
    best = &cause;
  }
  return best != nullptr ? *best : Cause();
}

void judge_primitive(const Result::Evidence& evidence, const std::string& reading,
                     const Cause& cause, Result& result) {
  for_each_class(result, [&](DisagreementClass& d) {
    if (!is_of(d, evidence) || d.kind == DisagreementKind::value) return;
    if (d.policy_agrees) return;
    d.cause = cause;
    if (!is_about_a_line(d)) return;
    d.legality = by_letter(!contains(evidence.illegal_line_snaps, reading));
    // An illegal gap keeps the verdict of compare(); with other results it may have been legal.
    if (cause == Cause(kInteriorGap))
      d.ruling = rule_of(is_legal(d) ? RuleId::line_interior_gap : d.rule).ruling;
  });
}

// Alternatives of sample.enable that ignore the switch for points and triangles have the same
// consequences.
constexpr MultisampleSwitch kIgnored[] = {MultisampleSwitch::ignored,
                                          MultisampleSwitch::ignored_but_for_lines,
                                          MultisampleSwitch::ignored_but_whole_lines};

// Consequences of ignoring GL_MULTISAMPLE get the alternative that explains most of the coverage in
// the run as their cause.
void name_switch(const Counts& counts, Result& result) {
  std::vector<AlternativeId> ignored;
  std::optional<AlternativeId> most;
  for (const MultisampleSwitch alternative : kIgnored) {
    const AlternativeId id = alternative_id(RuleId::sample_enable, name_of(alternative));
    ignored.push_back(id);
    if (counts.contains(id) && (!most || counts.at(id) > counts.at(*most))) most = id;
  }
  if (!most) return;
  for_each_class(result, [&](DisagreementClass& d) {
    if (d.kind == DisagreementKind::value)
      for (AlternativeId& part : d.cause.parts)
        if (std::ranges::find(ignored, part) != ignored.end()) part = *most;
  });
}

// For a difference that the letter of a ruling forbids, the basis of the ruling decides whether it
// is contested. This is the only place that knows. Judging again applies the rulings as they are
// now.
void weigh_rulings(Result& result) {
  for_each_class(result, [](DisagreementClass& d) {
    if (!is_legal(d)) d.legality = legality_against(d.ruling);
  });
}

Verdict verdict_of(const Result& result, Latitude latitude) {
  if (result.failure) return Verdict::not_run;
  Verdict worst = Verdict::agree;
  for (const ValueAggregate& values : result.values)
    worst = std::max(worst, verdict_of(values, latitude));
  for_each_class(result, [&](const DisagreementClass& d) {
    worst = std::max(worst, verdict_of(d, latitude));
  });
  return worst;
}

// The hash with the four bytes of a number more, the lowest first.
std::uint64_t with_number(std::uint64_t hash, int number) {
  for (int shift = 0; shift < 32; shift += 8)
    hash = fnv_step(hash, (static_cast<unsigned>(number) >> shift) & 0xff);
  return hash;
}

RuleId rule_of_case(const DisagreementClass& d) {
  return d.upright ? d.upright->rule : d.rule;
}

// The hash of rule, kind and set of pixels or samples; of counted ones, of their runs. Values
// inside the permitted interval count by rule only, and not at all beside a difference that the
// letter forbids, since which of them are off by an ULP may depend on the processor. The run
// decides whether the whole answer is upside down, so the fingerprint has the rules that the case
// alone gives. Without a rendering it has the kind of failure.
std::string fingerprint_of(const Result& result) {
  if (result.failure) return name_of(result.failure->kind);
  std::set<std::string> lines;
  for (const Disagreement& d : result.disagreements)
    lines.insert(fmt::format("{} {} {} {}{}\n", name_of(rule_of_case(d)), name_of(d.kind), d.x, d.y,
                             d.sample > 0 ? fmt::format(" {}", d.sample) : ""));
  for (const ValueAggregate& values : result.values)
    if (result.verdict < Verdict::contested)
      lines.insert(fmt::format("{} {} {}\n", name_of(values.rule), values.attribute,
                               values.cause.empty() ? "permitted" : text_of(values.cause)));
  if (lines.empty()) return "";
  std::uint64_t hash = kFnvStart;
  for (const std::string& line : lines) hash = fnv_of(line, hash);
  for (const CountedDisagreements& counted : result.counted) {
    hash = fnv_of(fmt::format("{} {} {}\n", name_of(rule_of_case(counted)), name_of(counted.kind),
                              counted.sample),
                  hash);
    for (const PixelRun& run : counted.runs)
      for (const int number : {run.y, run.begin, run.end}) hash = with_number(hash, number);
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace

void RunReader::add(const Result& result, const std::string& id) {
  for (const Snap snap : all_snaps())
    if (!result.failure && !contains(result.illegal_line_snaps, name_of(snap)))
      ++legal_[name_of(snap)];
  read_alternatives(result, reading_);
  rules_.add(result);
  things_.add(result, id);
}

// Lines are read with the snap under which most cases are legal; of several, with the first in
// catalogue order.
RunReading RunReader::reading() const {
  RunReading reading = reading_;
  reading.rules = rules_.answers();
  reading.things = things_.meetings();
  reading.line_snap.clear();
  std::size_t most = 0;
  for (const Snap snap : all_snaps()) {
    const std::string name = name_of(snap);
    const auto found = legal_.find(name);
    const std::size_t legal = found == legal_.end() ? 0 : found->second;
    if (!reading.line_snap.empty() && legal <= most) continue;
    most = legal;
    reading.line_snap = name;
  }
  return reading;
}

AlternativeSet refuted_in(const RunReading& reading) {
  AlternativeSet refuted;
  reading.missed.for_each([&](AlternativeId id) {
    if (is_open_choice(Cause(id))) refuted.add(id);
  });
  reading.refuted.for_each([&](AlternativeId id) {
    const auto count = reading.alternatives.find(id);
    const bool helps = count != reading.alternatives.end() && count->second > 0;
    if (!is_open_choice(Cause(id)) || !helps) refuted.add(id);
  });
  return refuted;
}

RunReading read_run(std::span<Result* const> results) {
  RunReader reader;
  for (const Result* result : results) reader.add(*result);
  return reader.reading();
}

void judge(std::span<Result* const> results, Latitude latitude, const RunReading& reading) {
  const Counts& counts = reading.alternatives;
  for (Result* result : results) {
    report_upright(*result);
    if (!result->failure)
      for (const Result::Evidence& evidence : result->evidence) {
        const bool legal = is_legal(*result, evidence, reading.line_snap);
        judge_primitive(evidence, reading.line_snap, choose_cause(evidence, legal, reading),
                        *result);
      }
    report_refuted_things(latitude == Latitude::opengl ? reading.things : Meetings(), *result);
    name_switch(counts, *result);
    if (is_noted_upside_down(*result) && count_of(counts, {kWindowOrigin}) > 0)
      report_upside_down(*result);
    weigh_rulings(*result);
    result->verdict = verdict_of(*result, latitude);
    count_pixels(*result, latitude);
    result->fingerprint = fingerprint_of(*result);
  }
}

std::string judge(std::span<Result* const> results, Latitude latitude) {
  RunReading reading = read_run(results);
  judge(results, latitude, reading);
  return reading.line_snap;
}

}  // namespace edgecase
