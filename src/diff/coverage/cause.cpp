// SPDX-License-Identifier: MIT
#include "diff/coverage/cause.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <string_view>
#include <utility>

#include "diff/coverage/alternatives.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/homogeneous_line.h"

namespace edgecase {
namespace {

// Does one fragment lack inside the run of those that were drawn, and nothing else differ?
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

// A set of changes that reproduces what was drawn.
using Changes = std::vector<Change>;

std::string text_of(const Changes& changes) {
  std::vector<std::string> parts;
  for (const Change& change : changes) parts.push_back(change.cause);
  return fmt::format("{}", fmt::join(parts, " + "));
}

CoverageChoice applied(const Changes& changes, CoverageChoice choice) {
  for (const Change& change : changes) change.apply(choice);
  return choice;
}

// Looks for sets of alternatives that draw a primitive as it was drawn.
class Search {
 public:
  Search(const CauseQuestion& question, const PrimitiveCoverage& coverage)
      : question_(question), coverage_(coverage) {
    if (question.profile != nullptr)
      profile_ =
          changes_between(question.primitive, question.target, question.chosen, *question.profile);
  }

  std::vector<Changes> operator()() const {
    auto found = beside({});
    if (found.empty()) return preferred(beside_profile());
    // What the renderer does elsewhere says more than what draws the same by chance.
    if (!knows_own(found) && !profile_.empty() && reproduces(profile_))
      if (Changes own = needed(profile_); is_open(own)) found.push_back(std::move(own));
    return preferred(std::move(found));
  }

  Changes of_profile() const {
    return !profile_.empty() && reproduces(profile_) ? needed(profile_) : Changes();
  }

 private:
  bool reproduces(const Changes& changes) const {
    return covered_samples(question_.primitive, question_.target,
                           applied(changes, question_.chosen),
                           question_.reported) == coverage_.drawn;
  }

  // `base` with one more alternative, in the place of its own of that rule if it has one.
  static Changes with(Changes base, const Change& change) {
    const auto rule_of = [](const Change& c) { return c.cause.substr(0, c.cause.find('=')); };
    std::erase_if(base, [&](const Change& c) { return rule_of(c) == rule_of(change); });
    base.push_back(change);
    return base;
  }

  static bool is_open(const Changes& changes) { return is_open_choice(text_of(changes)); }

  // Is there one that the specification leaves open, or that is what the renderer does elsewhere?
  bool has_answer(const std::vector<Changes>& found) const {
    return std::any_of(found.begin(), found.end(), [&](const Changes& changes) {
      return is_open(changes) || in_profile(changes);
    });
  }

  // All sets of one alternative; where none of them has an answer, those of two: all where there is
  // none of one, else those that are open.
  std::vector<Changes> beside(const Changes& base) const {
    auto rules =
        alternatives_beside(question_.primitive, question_.target, applied(base, question_.chosen));
    std::vector<Changes> found;
    for (const RuleAlternatives& rule : rules)
      for (const Change& change : rule) keep_if_it_reproduces(with(base, change), found);
    if (has_answer(found)) return found;
    if (!found.empty())
      for (RuleAlternatives& rule : rules)
        std::erase_if(rule, [](const Change& change) { return !is_open_choice(change.cause); });
    for (std::size_t i = 0; i < rules.size(); ++i)
      for (std::size_t j = i + 1; j < rules.size(); ++j)
        for (const Change& first : rules[i])
          for (const Change& second : rules[j])
            keep_if_it_reproduces(with(with(base, first), second), found);
    return found;
  }

  // What the profile differs in, or that and more, without what can be left out.
  std::vector<Changes> beside_profile() const {
    if (profile_.empty()) return {};
    if (reproduces(profile_)) return {needed(profile_)};
    auto found = beside(profile_);
    for (Changes& changes : found) changes = needed(std::move(changes));
    return found;
  }

  void keep_if_it_reproduces(Changes changes, std::vector<Changes>& found) const {
    if (reproduces(changes)) found.push_back(std::move(changes));
  }

  // Without those changes that can be left out.
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
    return std::all_of(changes.begin(), changes.end(), [&](const Change& change) {
      return std::any_of(profile_.begin(), profile_.end(),
                         [&](const Change& own) { return own.cause == change.cause; });
    });
  }

  bool knows_own(const std::vector<Changes>& found) const {
    return std::any_of(found.begin(), found.end(),
                       [&](const Changes& changes) { return in_profile(changes); });
  }

  std::vector<Changes> preferred(std::vector<Changes> found) const {
    if (knows_own(found))
      std::erase_if(found, [&](const Changes& changes) { return !in_profile(changes); });
    return found;
  }

  const CauseQuestion& question_;
  const PrimitiveCoverage& coverage_;
  Changes profile_;
};

// Would single changes of what is chosen draw what exact draws? Most answers agree, and are held
// against all alternatives: what cannot differ is not drawn.
class SingleChanges {
 public:
  // `drawn` must be what the choice draws.
  SingleChanges(const CauseQuestion& question, const SampleCoverage& drawn)
      : question_(question), drawn_(drawn) {}

  bool draw_so(const CoverageChoice& changed) {
    const CoverageChoice& chosen = question_.chosen;
    if (changed.snap != chosen.snap && decides_by_vertices()) return snapped_so(changed);
    const bool only_ties_differ =
        changed.ties.name != chosen.ties.name || (changed.rows != chosen.rows && is_seen_alike());
    if (only_ties_differ && decides_by_edges() && !has_ties()) return true;
    return covers_so(changed);
  }

 private:
  using Positions = std::array<Point, 3>;

  bool covers_so(const CoverageChoice& choice) const {
    return covered_samples(question_.primitive, question_.target, choice, question_.reported) ==
           drawn_;
  }

  // Does snapping decide on where vertices are, and on nothing else?
  bool decides_by_vertices() const {
    return question_.target.samples == 1 && !question_.primitive.is_clipped &&
           !has_clip_positions(question_.primitive) && question_.chosen.rows == RowOrder::bottom_up;
  }

  Positions snapped(Snap snap) const {
    const auto& p = question_.primitive.positions;
    return {snap(p[0]), snap(p[1]), snap(p[2])};
  }

  // Grids that take the vertices to the same places draw the same.
  bool snapped_so(const CoverageChoice& changed) {
    if (known_.empty()) known_.emplace_back(snapped(question_.chosen.snap), true);
    const Positions positions = snapped(changed.snap);
    const auto found = std::find_if(known_.begin(), known_.end(),
                                    [&](const auto& known) { return known.first == positions; });
    if (found != known_.end()) return found->second;
    return known_.emplace_back(positions, covers_so(changed)).second;
  }

  // Is a sample covered where all edge functions are positive?
  bool decides_by_edges() const {
    return question_.target.samples == 1 && !question_.primitive.is_clipped &&
           question_.primitive.kind == PrimitiveKind::triangle &&
           question_.chosen.triangle_algorithm == TriangleAlgorithm::edge_functions;
  }

  // Is it the same triangle in a target that is seen upside down, but for ties?
  bool is_seen_alike() const {
    return question_.chosen.snap.is_none() && question_.primitive.state->cull == CullMode::none;
  }

  // Does a sample lie on an edge, and in the triangle? Open edges draw the least that any rule on
  // ties does, closed ones the most.
  bool has_ties() {
    if (ties_ == Ties::unknown) {
      CoverageChoice open = question_.chosen;
      open.ties = *find_tie_rule("open");
      CoverageChoice closed = question_.chosen;
      closed.ties = *find_tie_rule("closed");
      ties_ = covers_so(open) && covers_so(closed) ? Ties::none : Ties::some;
    }
    return ties_ == Ties::some;
  }

  enum class Ties { unknown, none, some };

  const CauseQuestion& question_;
  const SampleCoverage& drawn_;
  std::vector<std::pair<Positions, bool>> known_;
  Ties ties_ = Ties::unknown;
};

// A single alternative, and its place among alternative_names().
struct PlacedChange {
  std::size_t place;
  Change change;
};

std::vector<PlacedChange> placed(const std::vector<RuleAlternatives>& rules) {
  static const auto places = [] {
    std::map<std::string, std::size_t> map;
    for (const std::string& name : alternative_names()) map.emplace(name, map.size());
    return map;
  }();
  std::vector<PlacedChange> changes;
  for (const RuleAlternatives& rule : rules)
    for (const Change& change : rule) changes.push_back({places.at(change.cause), change});
  return changes;
}

// The alternatives beside what is chosen. Nearly all primitives of a run ask for one of a few
// lists, which are made once.
const std::vector<PlacedChange>& placed_alternatives(const CauseQuestion& question) {
  struct Known {
    CoverageTraits traits;
    CoverageChoice chosen;
    std::vector<PlacedChange> changes;
  };
  constexpr std::size_t kMostKnown = 32;
  thread_local std::deque<Known> lists;
  const CoverageTraits traits = coverage_traits(question.primitive, question.target);
  const auto found = std::find_if(lists.begin(), lists.end(), [&](const Known& known) {
    return known.traits == traits && known.chosen == question.chosen;
  });
  if (found != lists.end()) return found->changes;
  if (lists.size() == kMostKnown) lists.pop_back();
  lists.push_front({traits, question.chosen, placed(alternatives_beside(traits, question.chosen))});
  return lists.front().changes;
}

}  // namespace

std::vector<std::string> find_causes(const CauseQuestion& question,
                                     const PrimitiveCoverage& coverage) {
  std::vector<std::string> causes;
  for (const Changes& changes : Search(question, coverage)()) causes.push_back(text_of(changes));
  if (causes.empty() && question.primitive.kind == PrimitiveKind::line &&
      is_interior_gap(question.primitive, coverage))
    causes.push_back(kInteriorGap);
  return causes;
}

std::string cause_in_profile(const CauseQuestion& question, const PrimitiveCoverage& coverage) {
  return text_of(Search(question, coverage).of_profile());
}

void mark_refuted(const CauseQuestion& question, const PrimitiveCoverage& coverage,
                  std::string& refuted) {
  // Several changes may bear one name, as all swapped pairs of samples do: it is refuted where none
  // of them draws so.
  enum class Tried : char { no, draws_otherwise, draws_so };
  std::vector<Tried> tried(alternative_names().size(), Tried::no);
  SingleChanges changes(question, coverage.drawn);
  for (const auto& [place, change] : placed_alternatives(question)) {
    if (refuted[place] == '1' || tried[place] == Tried::draws_so) continue;
    const bool same = changes.draw_so(change.applied_to(question.chosen));
    tried[place] = same ? Tried::draws_so : Tried::draws_otherwise;
  }
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i] == Tried::draws_otherwise) refuted[i] = '1';
}

std::vector<std::string> parts_of(const std::string& cause) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < cause.size();) {
    const std::size_t end = std::min(cause.find(" + ", at), cause.size());
    parts.push_back(cause.substr(at, end - at));
    at = end + 3;
  }
  return parts;
}

bool is_open_choice(const std::string& cause) {
  for (const std::string& part : parts_of(cause)) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    const Rule* rule = find_rule(part.substr(0, equals));
    const Alternative* alternative =
        rule != nullptr ? find_alternative(*rule, part.substr(equals + 1)) : nullptr;
    if (alternative == nullptr || alternative->openness == Openness::illegal) return false;
  }
  return !cause.empty();
}

}  // namespace edgecase
