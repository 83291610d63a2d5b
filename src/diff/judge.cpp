// SPDX-License-Identifier: MIT
#include "diff/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "diff/alternatives.h"
#include "diff/cause.h"
#include "diff/legality.h"
#include "rules/coverage/snap.h"

namespace edgecase {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The snap under which most cases are legal; the first in catalogue order of those that tie.
std::string choose_line_reading(std::span<Result* const> results) {
  std::string best;
  std::ptrdiff_t most = -1;
  for (Snap snap : all_snaps()) {
    const std::string name = name_of(snap);
    const auto legal = std::count_if(results.begin(), results.end(), [&](const Result* result) {
      return !result->failure && !contains(result->illegal_line_snaps, name);
    });
    if (legal <= most) continue;
    most = legal;
    best = name;
  }
  return best;
}

using Counts = std::map<std::string, std::ptrdiff_t>;

// How many primitives of the run each alternative helps to reproduce, alone or with another, less
// the cases that refute it.
Counts count_alternatives(std::span<Result* const> results) {
  Counts counts;
  for (const Result* result : results) {
    for (const Result::Evidence& evidence : result->evidence) {
      std::set<std::string> helpful;
      for (const std::string& cause : evidence.causes)
        for (const std::string& part : parts_of(cause)) helpful.insert(part);
      for (const std::string& part : helpful) ++counts[part];
    }
    for (std::size_t i = 0; i < result->refuted.size(); ++i)
      if (result->refuted[i] == '1') --counts[alternative_names()[i]];
  }
  return counts;
}

// Is what was drawn of a primitive inside the specification, lines read as they are?
bool is_legal(const Result& result, const Result::Evidence& evidence, const std::string& reading) {
  return std::all_of(
      result.disagreements.begin(), result.disagreements.end(), [&](const Disagreement& d) {
        if (d.primitive != evidence.primitive || d.policy_agrees) return true;
        if (d.kind == DisagreementKind::value) return true;
        return is_about_a_line(d) ? !contains(evidence.illegal_line_snaps, reading) : d.legal;
      });
}

// The candidate whose alternatives explain most of the run; the first in catalogue order of those
// that tie. Of what is legal, one that the specification leaves open comes before one that it does
// not. What is illegal, a hole in a shared edge say, speaks for neither.
std::string choose_cause(const Result::Evidence& evidence, bool legal, const Counts& counts) {
  std::string best;
  std::pair most{false, std::numeric_limits<std::ptrdiff_t>::min()};
  for (const std::string& cause : evidence.causes) {
    std::pair<bool, std::ptrdiff_t> score{legal && is_open_choice(cause), 0};
    for (const std::string& part : parts_of(cause)) score.second += counts.at(part);
    if (score <= most) continue;
    most = score;
    best = cause;
  }
  return best;
}

void judge_primitive(const Result::Evidence& evidence, const std::string& reading,
                     const std::string& cause, Result& result) {
  for (Disagreement& d : result.disagreements) {
    if (d.primitive != evidence.primitive || d.kind == DisagreementKind::value) continue;
    if (d.policy_agrees) continue;
    d.cause = cause;
    if (!is_about_a_line(d)) continue;
    d.legal = !contains(evidence.illegal_line_snaps, reading);
    if (cause == kInteriorGap && d.legal) d.ruling = 3;
  }
}

Verdict verdict_of(const Result& result, Latitude latitude) {
  if (result.failure) return Verdict::not_run;
  if (result.disagreements.empty() && result.values.empty()) return Verdict::agree;
  if (latitude == Latitude::none) return Verdict::violation;
  bool all_open = std::all_of(result.values.begin(), result.values.end(),
                              [](const ValueAggregate& v) { return is_open_choice(v.cause); });
  for (const Disagreement& d : result.disagreements) {
    if (!d.legal) return Verdict::violation;
    all_open = all_open && is_open_choice(d.cause);
  }
  return all_open ? Verdict::convention : Verdict::permitted;
}

// FNV-1a, 64 bits, of rule, kind and pixel set. Values inside the permitted interval count by rule
// only, and beside a violation not at all: which of them are off by an ULP may change with the
// processor. Without a rendering, the
// kind of failure stands in its place.
std::string fingerprint_of(const Result& result) {
  if (result.failure) return name_of(result.failure->kind);
  std::set<std::string> lines;
  for (const Disagreement& d : result.disagreements)
    lines.insert(fmt::format("{} {} {} {}\n", d.rule, name_of(d.kind), d.x, d.y));
  for (const ValueAggregate& values : result.values)
    if (result.verdict != Verdict::violation)
      lines.insert(fmt::format("{} {} {}\n", values.rule, values.attribute,
                               values.cause.empty() ? "permitted" : values.cause));
  if (lines.empty()) return "";
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::string& line : lines)
    for (const char c : line) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::string judge(std::span<Result* const> results, Latitude latitude) {
  const std::string reading = choose_line_reading(results);
  const Counts counts = count_alternatives(results);
  for (Result* result : results) {
    if (!result->failure)
      for (const Result::Evidence& evidence : result->evidence)
        judge_primitive(evidence, reading,
                        choose_cause(evidence, is_legal(*result, evidence, reading), counts),
                        *result);
    result->verdict = verdict_of(*result, latitude);
    result->fingerprint = fingerprint_of(*result);
  }
  return reading;
}

}  // namespace edgecase
