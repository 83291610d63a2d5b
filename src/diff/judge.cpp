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
#include "rules/all_rules.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

using Counts = std::map<AlternativeId, std::ptrdiff_t>;

// Adds to RunReading::alternatives and refuted. A primitive of several passes counts once.
void read_alternatives(const Result& result, RunReading& reading) {
  Counts& counts = reading.alternatives;
  std::set<std::pair<int, AlternativeId>> helpful;
  for (const Result::Evidence& evidence : result.evidence)
    for (const Cause& cause : evidence.causes)
      for (const AlternativeId part : cause.parts) helpful.emplace(evidence.primitive, part);
  for (const auto& [primitive, part] : helpful) ++counts[part];
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

// The candidate whose alternatives explain most of the run, on average; of several, the first. For
// a legal drawing, an alternative that the specification leaves open comes before one that it does
// not. If it is not among the smallest candidates, the renderer must follow it elsewhere; if the
// run refutes it, no unrefuted fault may explain more. Illegal drawings, such as a hole in a shared
// edge, are evidence for neither.
Cause choose_cause(const Result::Evidence& evidence, bool legal, const RunReading& reading) {
  const Counts& counts = reading.alternatives;
  const Cause* best = nullptr;
  std::pair most{false, -std::numeric_limits<double>::infinity()};
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Cause& cause : evidence.causes) least = std::min(least, cause.size());
  const double fault = most_support_of_a_fault(evidence, reading);
  for (const Cause& cause : evidence.causes) {
    const double support = support_of(cause, counts);
    const bool likely = cause.size() == least || is_followed(cause, counts);
    const bool outdone = fault > 0 && support < fault && is_refuted(cause, reading);
    const std::pair score{legal && likely && !outdone && is_open_choice(cause), support};
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
      d.ruling = is_legal(d) ? 3 : d.rule == RuleId::line_joint ? 14 : 1;
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

// FNV-1a, 64 bits.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  void add(int number) {
    for (int shift = 0; shift < 32; shift += 8)
      add_byte(static_cast<unsigned char>(static_cast<unsigned>(number) >> shift));
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }

  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

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
  Hash hash;
  for (const std::string& line : lines) hash.add(line);
  for (const CountedDisagreements& counted : result.counted) {
    hash.add(fmt::format("{} {} {}\n", name_of(rule_of_case(counted)), name_of(counted.kind),
                         counted.sample));
    for (const PixelRun& run : counted.runs)
      for (const int number : {run.y, run.begin, run.end}) hash.add(number);
  }
  return hash.text();
}

}  // namespace

void RunReader::add(const Result& result) {
  for (const Snap snap : all_snaps())
    if (!result.failure && !contains(result.illegal_line_snaps, name_of(snap)))
      ++legal_[name_of(snap)];
  read_alternatives(result, reading_);
}

// Lines are read with the snap under which most cases are legal; of several, with the first in
// catalogue order.
RunReading RunReader::reading() const {
  RunReading reading = reading_;
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

// ------------------------------------------------------------------------------- verdicts of parts

namespace {

struct JudgedPixel {
  int x;
  int y;
  Verdict verdict;
};

bool is_same_pixel(const JudgedPixel& a, const JudgedPixel& b) {
  return a.x == b.x && a.y == b.y;
}

// The worst difference of a pixel comes first.
bool comes_first(const JudgedPixel& a, const JudgedPixel& b) {
  return std::tie(a.y, a.x, b.verdict) < std::tie(b.y, b.x, a.verdict);
}

// Adds pixels, which mostly are in order already, to others in order.
void merge_pixels(std::vector<JudgedPixel> more, std::vector<JudgedPixel>& pixels) {
  if (!std::ranges::is_sorted(more, comes_first)) std::ranges::sort(more, comes_first);
  std::vector<JudgedPixel> all;
  all.reserve(pixels.size() + more.size());
  std::ranges::merge(pixels, more, std::back_inserter(all), comes_first);
  pixels = std::move(all);
}

// Every pixel that differs, with its worst legality.
std::vector<JudgedPixel> judged_pixels(const Result& result, Latitude latitude) {
  std::vector<JudgedPixel> pixels;
  for (const Disagreement& d : result.disagreements)
    pixels.push_back({d.x, d.y, verdict_of(d, latitude)});
  std::ranges::sort(pixels, comes_first);
  for (const ValueAggregate& values : result.values) {
    const Verdict verdict = verdict_of(values, latitude);
    std::vector<JudgedPixel> more;
    more.reserve(values.differing.size());
    for (const ValueAggregate::Place& place : values.differing)
      more.push_back({place.x, place.y, verdict});
    merge_pixels(std::move(more), pixels);
  }
  pixels.erase(std::unique(pixels.begin(), pixels.end(), is_same_pixel), pixels.end());
  return pixels;
}

// The same of a gross fault, as the numbers of pixels by verdict. It differs at most pixels, and a
// byte for each is less than a list.
std::map<Verdict, std::size_t> count_gross(const Result& result, Latitude latitude) {
  int width = 0;
  int height = 0;
  const auto reach = [&](int x, int y) {
    width = std::max(width, x + 1);
    height = std::max(height, y + 1);
  };
  for (const Disagreement& d : result.disagreements) reach(d.x, d.y);
  for (const CountedDisagreements& counted : result.counted)
    for (const PixelRun& run : counted.runs) reach(run.end - 1, run.y);
  for (const ValueAggregate& values : result.values)
    for (const ValueAggregate::Place& place : values.differing) reach(place.x, place.y);
  std::vector<std::uint8_t> worst(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
  const auto add = [&](int y, int begin, int end, Verdict verdict) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (std::size_t x = row + static_cast<std::size_t>(begin);
         x < row + static_cast<std::size_t>(end); ++x)
      worst[x] = std::max(worst[x], static_cast<std::uint8_t>(verdict));
  };
  for (const Disagreement& d : result.disagreements)
    add(d.y, d.x, d.x + 1, verdict_of(d, latitude));
  for (const CountedDisagreements& counted : result.counted)
    for (const PixelRun& run : counted.runs)
      add(run.y, run.begin, run.end, verdict_of(counted, latitude));
  for (const ValueAggregate& values : result.values)
    for (const ValueAggregate::Place& place : values.differing)
      add(place.y, place.x, place.x + 1, verdict_of(values, latitude));
  std::map<Verdict, std::size_t> counts;
  for (const std::uint8_t verdict : worst) ++counts[static_cast<Verdict>(verdict)];
  return counts;
}

}  // namespace

Verdict verdict_of(const DisagreementClass& disagreement, Latitude latitude) {
  if (latitude == Latitude::none || disagreement.legality == Legality::illegal)
    return Verdict::violation;
  if (disagreement.legality == Legality::contested) return Verdict::contested;
  return is_open_choice(disagreement.cause) ? Verdict::convention : Verdict::permitted;
}

Verdict verdict_of(const ValueAggregate& values, Latitude latitude) {
  if (latitude == Latitude::none) return Verdict::violation;
  return is_open_choice(values.cause) ? Verdict::convention : Verdict::permitted;
}

void count_pixels(Result& result, Latitude latitude) {
  const PixelCounts before = result.pixel_counts;
  const std::size_t all =
      before.agree + before.convention + before.permitted + before.contested + before.violation;
  if (all == 0) return;
  std::map<Verdict, std::size_t> found;
  if (result.counted.empty())
    for (const JudgedPixel& pixel : judged_pixels(result, latitude)) ++found[pixel.verdict];
  else
    found = count_gross(result, latitude);
  PixelCounts& counts = result.pixel_counts = {};
  counts.same = before.same;
  counts.convention = found[Verdict::convention];
  counts.permitted = found[Verdict::permitted];
  counts.contested = found[Verdict::contested];
  counts.violation = found[Verdict::violation];
  counts.agree = all - counts.convention - counts.permitted - counts.contested - counts.violation;
}

}  // namespace edgecase
