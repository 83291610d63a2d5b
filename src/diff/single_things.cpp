// SPDX-License-Identifier: MIT
#include "diff/single_things.h"

#include <fmt/format.h>

#include <algorithm>

#include "diff/values/value_diff.h"
#include "rules/all_rules.h"
#include "rules/output/polygon_offset.h"
#include "rules/samples/sample_mask.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

using Kind = SingleThing::Kind;

std::string text_of(const SingleThing& thing) {
  switch (thing.kind) {
    case Kind::offset_unit:
      return fmt::format("a unit of polygon offset in a depth buffer of {} bits", thing.of);
    case Kind::alpha:
      return fmt::format("the least alpha of which pixel ({}, {}) keeps {} of {} samples", thing.x,
                         thing.y, thing.sample, thing.of);
    case Kind::sample_x:
    case Kind::sample_y:
    case Kind::sample_cells:
      break;
  }
  return fmt::format("{} of sample {} of {} in its pixel", thing.kind == Kind::sample_x ? 'x' : 'y',
                     thing.sample, thing.of);
}

Disagreement refutation_of(const SingleThing& thing) {
  switch (thing.kind) {
    case Kind::offset_unit:
      return value_disagreement({0, 0}, -1, RuleId::offset_unit, kRulingOnOneUnit);
    case Kind::alpha: {
      Disagreement d = value_disagreement({thing.x, thing.y}, -1, RuleId::sample_alpha_to_coverage,
                                          kRulingOnFallingNumbers);
      d.legality = legality_against(kRulingOnFallingNumbers);
      return d;
    }
    case Kind::sample_x:
    case Kind::sample_y:
    case Kind::sample_cells:
      break;
  }
  Disagreement d = value_disagreement({0, 0}, -1, RuleId::sample_positions, kRulingOnOnePlace);
  d.sample = thing.sample;
  return d;
}

std::optional<Disagreement> refutation_by_interval(const Result::Shown& shown,
                                                   const Meetings& meetings) {
  const auto found = meetings.find(shown.thing);
  if (found == meetings.end()) return std::nullopt;
  const Meeting& meeting = found->second;
  const bool is_lower = shown.high < meeting.where.low;
  if (!is_lower && shown.low <= meeting.where.high) return std::nullopt;
  Disagreement d = refutation_of(shown.thing);
  d.exact = {is_lower ? meeting.where.low : meeting.where.high};
  d.rendered = {is_lower ? shown.high : shown.low};
  d.explanation = fmt::format(
      "{} is {} {:.9g} by this answer, and {} {:.9g} by that to {}: both cannot be, since it is "
      "one. Ruling {}",
      text_of(shown.thing), is_lower ? "at most" : "at least", d.rendered[0],
      is_lower ? "at least" : "at most", d.exact[0], is_lower ? meeting.lowest : meeting.highest,
      d.ruling);
  return d;
}

std::optional<Disagreement> refutation_of_cells(const Result::Shown& shown,
                                                const Meetings& meetings) {
  const int of = shown.thing.of;
  const int sample = shown.thing.sample;
  const auto x = meetings.find({Kind::sample_x, of, sample});
  const auto y = meetings.find({Kind::sample_y, of, sample});
  if (x == meetings.end() || y == meetings.end()) return std::nullopt;
  const Interval across = x->second.where;
  const Interval up = y->second.where;
  if (shown.cells->meets(across.low, across.high, up.low, up.high)) return std::nullopt;
  Disagreement d = refutation_of(shown.thing);
  d.explanation = fmt::format(
      "sample {} of {} lies from ({:.9g}, {:.9g}) to ({:.9g}, {:.9g}) of its pixel by other "
      "answers, as by that to {}; with it there, some of what this answer covers or leaves out of "
      "it cannot be. Ruling {}",
      sample, of, across.low, up.low, across.high, up.high, x->second.lowest, d.ruling);
  return d;
}

}  // namespace

void SingleThings::add(const Result& result, const std::string& id) {
  for (const Result::Shown& shown : result.shown) {
    if (shown.thing.kind == Kind::sample_cells) continue;
    Saying& saying = sayings_[shown.thing][{shown.low, shown.high}];
    if (saying.answers++ == 0 || id < saying.first) saying.first = id;
  }
}

Meetings SingleThings::meetings() const {
  Meetings meetings;
  for (const auto& [thing, sayings] : sayings_) {
    std::vector<Weighed> all;
    for (const auto& [bounds, saying] : sayings)
      all.push_back({{bounds.first, bounds.second}, saying.answers});
    const Interval where = *where_most_meet(all);
    Meeting meeting{where, {}, {}};
    for (const auto& [bounds, saying] : sayings) {
      const bool meets = bounds.first <= where.low && where.high <= bounds.second;
      meeting.is_refuted = meeting.is_refuted || !meets;
      if (!meets) continue;
      if (bounds.first == where.low) meeting.lowest = saying.first;
      if (bounds.second == where.high) meeting.highest = saying.first;
    }
    meetings.emplace(thing, std::move(meeting));
  }
  return meetings;
}

namespace {

constexpr const char* kUnitTrait = "unit of polygon offset, ";
constexpr const char* kSampleTrait = "place of sample ";

}  // namespace

std::map<std::string, std::string> traits_of(const Meetings& meetings) {
  std::map<std::string, std::string> traits;
  for (const auto& [thing, meeting] : meetings) {
    const Interval where = meeting.where;
    if (thing.kind == Kind::offset_unit) {
      traits[fmt::format("{}{} bits", kUnitTrait, thing.of)] =
          fmt::format("{:.4g} to {:.4g}", where.low, where.high);
    } else if (const auto y = meetings.find({Kind::sample_y, thing.of, thing.sample});
               thing.kind == Kind::sample_x && y != meetings.end()) {
      const Interval up = y->second.where;
      traits[fmt::format("{}{} of {}", kSampleTrait, thing.sample, thing.of)] = fmt::format(
          "({:.3g}, {:.3g}) to ({:.3g}, {:.3g})", where.low, up.low, where.high, up.high);
    }
  }
  return traits;
}

bool is_of_a_thing(const std::string& trait) {
  return trait.starts_with(kUnitTrait) || trait.starts_with(kSampleTrait);
}

void report_refuted_things(const Meetings& meetings, Result& result) {
  std::erase_if(result.disagreements, [](const Disagreement& d) {
    return d.ruling == kRulingOnOneUnit || d.ruling == kRulingOnOnePlace ||
           d.ruling == kRulingOnFallingNumbers;
  });
  std::vector<Disagreement> refuted;
  for (const Result::Shown& shown : result.shown)
    if (auto d = shown.thing.kind == Kind::sample_cells ? refutation_of_cells(shown, meetings)
                                                        : refutation_by_interval(shown, meetings))
      refuted.push_back(*std::move(d));
  result.disagreements.insert(result.disagreements.begin(), refuted.begin(), refuted.end());
}

}  // namespace edgecase
