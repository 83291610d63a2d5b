// SPDX-License-Identifier: MIT
#include "diff/coverage/cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "diff/findings/patience.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/change_search.h"
#include "rules/coverage/homogeneous_line.h"

namespace edgecase {
namespace {

// True if exactly one fragment is missing between others that were drawn, and nothing else differs.
bool is_interior_gap(const ScenePrimitive& line, const PrimitiveCoverage& coverage) {
  if (line.state->line_width != Fixed::from_integer(1)) return false;
  if (coverage.drawn.size() != 1) return false;
  const auto differing = differences(coverage);
  if (differing.size() != 1 || differing[0].drawn != 0) return false;
  const bool x_major = HomogeneousSegment{line.positions[0], line.positions[1]}.x_major();
  const auto along = [&](PixelPosition p) { return x_major ? p.x : p.y; };
  const int gap = along(differing[0].pixel);
  const auto drawn_where = [&](auto where) {
    return std::any_of(coverage.drawn[0].begin(), coverage.drawn[0].end(),
                       [&](PixelPosition p) { return where(along(p)); });
  };
  return drawn_where([&](int at) { return at < gap; }) &&
         drawn_where([&](int at) { return at > gap; });
}

// The samples of a large drawing at one pixel, as they were drawn. To draw one pixel is cheap, and
// a choice that draws it otherwise does not draw the whole as it was drawn.
class Witness {
 public:
  Witness(const ScenePrimitive& primitive, const SampleCoverage& drawn, PixelPosition pixel)
      : state_(*primitive.state), primitive_(primitive) {
    state_.vertices.clear();
    Viewport box{pixel.x, pixel.y, 1, 1};
    if (state_.scissor && !pixels_in(*state_.scissor).contains(pixel)) box.width = 0;
    state_.scissor = box;
    for (const auto& pixels : drawn) {
      const auto [first, last] = std::equal_range(
          pixels.begin(), pixels.end(), pixel,
          [](auto a, auto b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); });
      drawn_.emplace_back(first, last);
    }
  }

  bool is_drawn_so(const CauseQuestion& question, const CoverageChoice& choice) const {
    ScenePrimitive primitive = primitive_;
    primitive.state = &state_;
    return covered_samples(primitive, question.target, choice, question.reported) == drawn_;
  }

 private:
  Draw state_;  // that of the primitive, with the pixel as its scissor rectangle
  ScenePrimitive primitive_;
  SampleCoverage drawn_;
};

// A few of the pixels that differ, if the drawing is large; else none. What lines cover at a pixel
// may depend on the scissor rectangle, where an algorithm begins at its border.
std::vector<Witness> witnesses_of(const CauseQuestion& question,
                                  const PrimitiveCoverage& coverage) {
  constexpr std::size_t kLarge = 4096;  // samples: drawing them takes longer than a few pixels do
  constexpr std::size_t kWitnesses = 8;
  if (question.primitive.kind == PrimitiveKind::line) return {};
  std::size_t size = 0;
  for (std::size_t s = 0; s < coverage.exact.size(); ++s)
    size += coverage.exact[s].size() + coverage.drawn[s].size();
  if (size < kLarge) return {};
  std::size_t found = 0;
  for_each_difference(coverage, [&](const CoverageDifference&) { ++found; });
  const std::size_t step = std::max<std::size_t>(1, found / kWitnesses);
  std::vector<Witness> witnesses;
  std::size_t at = 0;
  for_each_difference(coverage, [&](const CoverageDifference& difference) {
    if (at++ % step == step / 2)
      witnesses.emplace_back(question.primitive, coverage.drawn, difference.pixel);
  });
  return witnesses;
}

// Searches for sets of alternatives that draw a primitive as it was drawn.
class Search {
 public:
  Search(const CauseQuestion& question, const PrimitiveCoverage& coverage)
      : question_(question), coverage_(coverage), witnesses_(witnesses_of(question, coverage)) {
    if (question.profile != nullptr)
      profile_ = coverage_changes_between(question.primitive, question.target, question.chosen,
                                          *question.profile);
  }

  std::vector<Changes> operator()() const {
    auto found = beside({});
    if (found.empty()) return preferred(beside_profile());
    // What the renderer does elsewhere is stronger evidence than a set that fits by chance.
    if (!knows_own(found))
      if (Changes own = of_profile(); is_open(own)) found.push_back(std::move(own));
    return preferred(std::move(found));
  }

  Changes of_profile() const {
    return !profile_.empty() && reproduces(profile_) ? needed(profile_) : Changes();
  }

 private:
  bool reproduces(const Changes& changes) const {
    Patience::check();
    const RuleChoices choices = applied(changes, question_.chosen);
    const CoverageChoice& choice = choices.of(question_.primitive.kind);
    return std::ranges::all_of(
               witnesses_,
               [&](const Witness& witness) { return witness.is_drawn_so(question_, choice); }) &&
           covered_samples(question_.primitive, question_.target, choice, question_.reported) ==
               coverage_.drawn;
  }

  // `base` with more alternatives, each of which replaces the one of the same rule if there is one.
  static Changes with(Changes base, const Changes& more) {
    for (const Change& change : more) {
      std::erase_if(base, [&](const Change& c) { return c.id.rule == change.id.rule; });
      base.push_back(change);
    }
    return base;
  }

  static bool is_open(const Changes& changes) { return is_open_choice(cause_of(changes)); }

  // True if one of the sets is left open by the specification or lies in the profile.
  bool has_answer(const std::vector<Changes>& found) const {
    return std::any_of(found.begin(), found.end(), [&](const Changes& changes) {
      return is_open(changes) || in_profile(changes);
    });
  }

  // All sets of one alternative. If none of them is an answer, also sets of two: all of them if
  // there is none of one, else only open ones. Sets that lie in the profile come alone (preferred),
  // so they are asked first.
  std::vector<Changes> beside(const Changes& base) const {
    std::vector<Changes> rules = coverage_changes(
        coverage_traits(question_.primitive, question_.target), applied(base, question_.chosen));
    const bool likely_first = question_.likely_first && base.empty();
    if (likely_first)
      if (auto likely = fitting(base, singles_of(in_profile(rules))); !likely.empty())
        return likely;
    std::vector<Changes> found = fitting(base, singles_of(rules));
    if (has_answer(found)) return found;
    if (!found.empty())
      for (Changes& rule : rules)
        std::erase_if(rule, [](const Change& change) { return !is_open_choice(change.id); });
    if (likely_first)
      if (auto likely = fitting(base, pairs_of(in_profile(rules))); !likely.empty()) return likely;
    if (question_.is_gross) return found;
    for (Changes& pair : fitting(base, pairs_of(rules))) found.push_back(std::move(pair));
    return found;
  }

  // Those of the sets that, together with `base`, draw the primitive as it was drawn.
  std::vector<Changes> fitting(const Changes& base, std::vector<Changes> sets) const {
    for (Changes& set : sets) set = with(base, set);
    std::erase_if(sets, [&](const Changes& set) { return !reproduces(set); });
    return sets;
  }

  // The alternatives that the profile has.
  std::vector<Changes> in_profile(std::vector<Changes> rules) const {
    for (Changes& rule : rules)
      std::erase_if(rule, [&](const Change& change) { return !in_profile({change}); });
    return rules;
  }

  // The profile's differences, with more if needed, without those that can be left out.
  std::vector<Changes> beside_profile() const {
    if (profile_.empty()) return {};
    if (reproduces(profile_)) return {needed(profile_)};
    auto found = beside(profile_);
    for (Changes& changes : found) changes = needed(std::move(changes));
    return found;
  }

  // Drops changes that can be left out.
  Changes needed(Changes changes) const {
    for (std::size_t i = 0; i < changes.size();) {
      Changes without = changes;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (reproduces(without))
        changes = std::move(without);
      else
        ++i;
    }
    return changes;
  }

  bool in_profile(const Changes& changes) const {
    return std::ranges::all_of(changes, [&](const Change& change) {
      return std::ranges::find(profile_, change.id, &Change::id) != profile_.end();
    });
  }

  bool knows_own(const std::vector<Changes>& found) const {
    return std::ranges::any_of(found, [&](const Changes& changes) { return in_profile(changes); });
  }

  std::vector<Changes> preferred(std::vector<Changes> found) const {
    if (knows_own(found))
      std::erase_if(found, [&](const Changes& changes) { return !in_profile(changes); });
    return found;
  }

  const CauseQuestion& question_;
  const PrimitiveCoverage& coverage_;
  const std::vector<Witness> witnesses_;
  Changes profile_;
};

}  // namespace

std::vector<Cause> find_causes(const CauseQuestion& question, const PrimitiveCoverage& coverage) {
  std::vector<Cause> causes;
  for (const Changes& changes : Search(question, coverage)()) causes.push_back(cause_of(changes));
  if (causes.empty() && question.primitive.kind == PrimitiveKind::line &&
      is_interior_gap(question.primitive, coverage))
    causes.push_back(kInteriorGap);
  return causes;
}

std::string swapped_pairs(const CauseQuestion& question, const PrimitiveCoverage& coverage) {
  CoverageChoice choice = question.chosen.of(question.primitive.kind);
  std::string pairs;
  for (const SamplePlacement& placement : placements_of(question.target.samples)) {
    choice.placement = placement;
    if (placement.kind == SamplePlacement::Kind::swapped &&
        covered_samples(question.primitive, question.target, choice, question.reported) ==
            coverage.drawn)
      pairs += fmt::format("{}{} and {}", pairs.empty() ? "" : ", or ", placement.first,
                           placement.second);
  }
  return pairs;
}

Cause cause_in_profile(const CauseQuestion& question, const PrimitiveCoverage& coverage) {
  return cause_of(Search(question, coverage).of_profile());
}

}  // namespace edgecase
