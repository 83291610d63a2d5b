// SPDX-License-Identifier: MIT
#include "diff/coverage/shared_edge_blame.h"

#include <fmt/format.h>

#include <algorithm>

#include "diff/coverage/sample_legality.h"
#include "diff/findings/add_disagreement.h"
#include "rules/all_rules.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

bool is_about_triangles(const DisagreementClass& d) {
  return d.rule == RuleId::triangle_fill_rule || d.rule == RuleId::triangle_shared_edge ||
         d.rule == RuleId::clip_volume;
}

void turn(bool is_certain, int ruling, DisagreementClass& d) {
  if (is_certain || is_legal(d)) d.ruling = ruling;
  d.legality = Legality::illegal;
  d.rule = RuleId::triangle_shared_edge;
}

// `runs` are sorted by row and column, as differences in coverage come.
bool contains(const std::vector<PixelRun>& runs, PixelPosition pixel) {
  auto after =
      std::ranges::upper_bound(runs, std::pair(pixel.y, pixel.x), {},
                               [](const PixelRun& run) { return std::pair(run.y, run.begin); });
  if (after == runs.begin()) return false;
  const PixelRun& run = *--after;
  return run.y == pixel.y && pixel.x < run.end;
}

}  // namespace

int ruling_on(const SharedEdgeFault& fault) {
  return fault.is_certain ? rule_of(RuleId::triangle_shared_edge).ruling : kRulingOnOtherPlaces;
}

SharedEdgeBlame::SharedEdgeBlame(Result& result) : result_(result) {
  for (std::size_t i = 0; i < result.counted.size(); ++i)
    if (const CountedDisagreements& counted = result.counted[i]; is_about_triangles(counted))
      counted_[{counted.primitive, counted.sample}].push_back(i);
}

void SharedEdgeBlame::index_new() {
  for (; indexed_ < result_.disagreements.size(); ++indexed_) {
    const Disagreement& d = result_.disagreements[indexed_];
    if (is_about_triangles(d)) in_full_.emplace(Sample(d.primitive, d.sample, d.y, d.x), indexed_);
  }
}

bool SharedEdgeBlame::add(const SharedEdgeFault& fault, const std::string& reason) {
  index_new();
  bool found = false;
  for (const int primitive : {fault.first, fault.second}) {
    const auto [begin, end] =
        in_full_.equal_range({primitive, fault.sample, fault.pixel.y, fault.pixel.x});
    for (auto at = begin; at != end; ++at) {
      Disagreement& d = result_.disagreements[at->second];
      turn(fault.is_certain, ruling_on(fault), d);
      d.explanation += fmt::format(" Ruling {}: {}.", ruling_on(fault), reason);
      found = true;
    }
    found = blame_counted(primitive, fault) || found;
  }
  return found;
}

bool SharedEdgeBlame::blame_counted(int primitive, const SharedEdgeFault& fault) {
  bool found = false;
  const auto counted = counted_.find({primitive, fault.sample});
  if (counted == counted_.end()) return false;
  for (const std::size_t i : counted->second)
    if (contains(result_.counted[i].runs, fault.pixel)) {
      blamed_[i].push_back({fault.pixel, fault.is_certain, ruling_on(fault)});
      found = true;
    }
  return found;
}

// Moves the blamed pixels to disagreements of the class that they turn into.
void SharedEdgeBlame::split(CountedDisagreements& counted, std::vector<Blamed> blamed,
                            std::vector<CountedDisagreements>& turned) const {
  const auto place_of = [](const Blamed& one) { return std::pair(one.pixel.y, one.pixel.x); };
  std::ranges::stable_sort(blamed, {}, place_of);
  auto next = blamed.begin();
  std::vector<PixelRun> left;
  for (const PixelRun& run : counted.runs)
    for (int x = run.begin; x < run.end; ++x) {
      const PixelPosition pixel{x, run.y};
      if (next == blamed.end() || next->pixel != pixel) {
        append_pixel(left, pixel);
        continue;
      }
      DisagreementClass of = counted;
      for (; next != blamed.end() && next->pixel == pixel; ++next)
        turn(next->is_certain, next->ruling, of);
      const auto same = [&](const DisagreementClass& other) { return other == of; };
      auto place = std::ranges::find_if(turned, same);
      if (place == turned.end()) place = turned.insert(turned.end(), {of, {}});
      append_pixel(place->runs, pixel);
    }
  counted.runs = std::move(left);
}

void SharedEdgeBlame::finish() {
  std::vector<CountedDisagreements> turned;
  for (auto& [i, blamed] : blamed_) split(result_.counted[i], std::move(blamed), turned);
  std::erase_if(result_.counted, [](const auto& counted) { return counted.runs.empty(); });
  for (CountedDisagreements& counted : turned) add_counted(result_, std::move(counted));
}

}  // namespace edgecase
