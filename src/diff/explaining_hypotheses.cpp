// SPDX-License-Identifier: MIT
#include "diff/explaining_hypotheses.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <utility>

#include "diff/coverage/coverage_diff.h"
#include "diff/findings/patience.h"
#include "raster/rasterizer.h"
#include "rules/coverage/tie_rule.h"
#include "rules/coverage/window.h"
#include "rules/hypotheses.h"

namespace edgecase {
namespace {

constexpr int kPlaces = CoverageHypothesis::kPlaces;
constexpr int kGrids = CoverageHypothesis::kGrids;
constexpr int kLeftOuts = CoverageHypothesis::kLeftOuts;
constexpr int kTies = CoverageHypothesis::kTies;

bool is_empty(const SampleCoverage& coverage) {
  return std::ranges::all_of(coverage, [](const auto& pixels) { return pixels.empty(); });
}

std::size_t size_of(const SampleCoverage& coverage) {
  std::size_t size = 0;
  for (const auto& pixels : coverage) size += pixels.size();
  return size;
}

// True if each pixel of `part` is one of `whole`; both sorted.
bool is_within(const SampleCoverage& part, const SampleCoverage& whole) {
  const auto reads_before = [](PixelPosition a, PixelPosition b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  };
  for (std::size_t s = 0; s < part.size(); ++s)
    if (part[s].size() > whole[s].size() || !std::ranges::includes(whole[s], part[s], reads_before))
      return false;
  return true;
}

SampleCoverage turned_over(SampleCoverage coverage, int height) {
  for (auto& pixels : coverage) {
    for (PixelPosition& pixel : pixels) pixel.y = height - 1 - pixel.y;
    std::ranges::sort(pixels, [](PixelPosition a, PixelPosition b) {
      return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    });
  }
  return coverage;
}

// The rows that something covers.
std::pair<int, int> rows_of(const SampleCoverage& coverage) {
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();
  for (const auto& pixels : coverage)
    if (!pixels.empty()) {
      low = std::min(low, pixels.front().y);
      high = std::max(high, pixels.back().y);
    }
  return {low, high};
}

SampleCoverage without_row(SampleCoverage coverage, int row) {
  for (auto& pixels : coverage)
    std::erase_if(pixels, [row](PixelPosition pixel) { return pixel.y == row; });
  return coverage;
}

using LeftOuts = std::bitset<kLeftOuts>;
constexpr std::size_t index_of(LeftOut left_out) {
  return static_cast<std::size_t>(left_out);
}

// What is known of one way to place samples and vertices, primitive by primitive: under which tie
// rules everything so far is drawn so, if these are left out.
struct Survivors {
  std::array<LeftOuts, kTies> left{};
  // For small_ones: the sizes of the largest primitive that is missing, and of the smallest that is
  // there, by tie rule.
  std::array<std::size_t, kTies> largest_missing{};
  std::array<std::size_t, kTies> smallest_drawn{};

  bool any() const {
    return std::ranges::any_of(left, [](const LeftOuts& one) { return one.any(); });
  }
};

class Explaining {
 public:
  explicit Explaining(const Drawing& drawing)
      : scene_(drawing.scene),
        choices_(drawing.policy.on(drawing.scene.target.surface)),
        exact_(drawing.exact),
        rendered_(drawing.rendered),
        bits_(drawing.facts.reported_subpixel_bits),
        primitives_(primitives_of(drawing.scene)),
        coverage_(match_coverage(primitives_.size(), exact_, rendered_)) {}

  std::vector<NumberRun> run() {
    const bool covers_right = std::ranges::all_of(
        coverage_, [](const PrimitiveCoverage& one) { return one.exact == one.drawn; });
    if (!covers_right) {
      explain_coverage();
    } else if (exact_.pixels.size() == rendered_.pixels.size() &&
               exact_.pixels != rendered_.pixels) {
      found_.push_back(kAskedOfColors);
      explain_colors();
    }
    std::ranges::sort(found_);
    std::vector<NumberRun> runs;
    for (const std::uint16_t number : found_)
      if (!runs.empty() && runs.back().last + 1 == number)
        runs.back().last = number;
      else
        runs.push_back({number, number});
    runs.shrink_to_fit();
    return runs;
  }

 private:
  // ----------------------------------------------------------------------------------- coverage

  void explain_coverage() {
    std::vector<SampleCoverage> turned;
    for (const PrimitiveCoverage& one : coverage_)
      turned.push_back(turned_over(one.drawn, scene_.target.height));
    // A large drawing is too dear, and moved clip coordinates would not be those of the scene.
    constexpr std::size_t kLarge = std::size_t{1} << 16;  // samples
    std::size_t size = 0;
    for (const PrimitiveCoverage& one : coverage_) size += size_of(one.exact) + size_of(one.drawn);
    const bool may_move = size <= kLarge && std::ranges::none_of(primitives_, cannot_be_moved);
    for (int grid = 0; grid < (may_move ? kGrids : 1); ++grid)
      for (int place = 0; place < (may_move ? kPlaces : 1); ++place) {
        Patience::check();
        explain_by(static_cast<VertexGrid>(grid), static_cast<SampledPlace>(place), turned);
      }
    explain_by_tests();
    if (may_move || !found_.empty()) found_.push_back(kAskedOfCoverage);
  }

  static bool cannot_be_moved(const ScenePrimitive& primitive) {
    if (primitive.is_clipped || primitive.is_cut) return true;
    const int count = vertices_of(primitive.kind);
    for (int i = 0; i < count; ++i)
      if (primitive.positions[static_cast<std::size_t>(i)].w != Fixed::kOne) return true;
    return false;
  }

  void explain_by(VertexGrid grid, SampledPlace place, const std::vector<SampleCoverage>& turned) {
    const bool is_identity = grid == VertexGrid::as_chosen && place == SampledPlace::centre;
    std::array<Survivors, 2> survivors;
    for (Survivors& side : survivors) {
      for (LeftOuts& left : side.left) left.set();
      side.smallest_drawn.fill(std::numeric_limits<std::size_t>::max());
      for (LeftOuts& left : side.left) left.reset(index_of(LeftOut::failing));
      if (!is_identity)
        for (LeftOuts& left : side.left) left.reset(index_of(LeftOut::everything));
    }
    for (std::size_t i = 0; i < primitives_.size(); ++i) {
      const Predicted predicted(*this, primitives_[i], grid, place);
      narrow(predicted, coverage_[i].drawn, survivors[0]);
      narrow(predicted, turned[i], survivors[1]);
      if (!survivors[0].any() && !survivors[1].any()) return;
    }
    for (const bool is_upside_down : {false, true})
      add(grid, place, is_upside_down, survivors[is_upside_down ? 1 : 0]);
  }

  // What a primitive covers, moved, under each tie rule; made when it is asked.
  class Predicted {
   public:
    Predicted(const Explaining& all, const ScenePrimitive& primitive, VertexGrid grid,
              SampledPlace place)
        : all_(all), primitive_(all.moved(primitive, grid, place)), grid_(grid), place_(place) {
      low = under(open_ties());
      high = has_ties() ? under(closed_ties()) : low;
    }

    bool has_ties() const { return primitive_.kind != PrimitiveKind::line; }
    const ScenePrimitive& primitive() const { return primitive_; }
    SampleCoverage of(int ties) const {
      const CoverageChoice& chosen = all_.choices_.of(primitive_.kind);
      return under(ties == 0 ? chosen.ties : all_tie_rules()[static_cast<std::size_t>(ties - 1)]);
    }

    SampleCoverage low;   // with the fewest ties
    SampleCoverage high;  // with the most

   private:
    SampleCoverage under(const TieRule& ties) const {
      CoverageChoice choice = all_.choices_.of(primitive_.kind);
      choice.ties = ties;
      if (grid_ != VertexGrid::as_chosen || place_ != SampledPlace::centre) choice.snap = Snap{};
      return covered_samples(primitive_, all_.scene_.target, choice,
                             all_.rendered_.sample_positions);
    }

    const Explaining& all_;
    ScenePrimitive primitive_;
    VertexGrid grid_;
    SampledPlace place_;
  };

  ScenePrimitive moved(ScenePrimitive primitive, VertexGrid grid, SampledPlace place) const {
    if (grid == VertexGrid::as_chosen && place == SampledPlace::centre) return primitive;
    const HalfPixels move = move_of(place);
    const Snap snap =
        grid == VertexGrid::as_chosen ? choices_.of(primitive.kind).snap : snap_of(grid, bits_);
    for (int i = 0; i < vertices_of(primitive.kind); ++i) {
      HomogeneousPoint& position = primitive.positions[static_cast<std::size_t>(i)];
      Point at = nearest_point(position);
      if (place == SampledPlace::shrunk) at = resized(at, 1, 1);
      if (place == SampledPlace::limited) at = limited(at);
      at = snap(at);
      const auto half = Fixed::kOne / 2;
      position = homogeneous({Fixed::from_raw(at.x.raw() + move.dx * half),
                              Fixed::from_raw(at.y.raw() + move.dy * half)});
    }
    return primitive;
  }

  // Where the point lies in a viewport of the same corner, smaller by so many pixels.
  Point resized(Point at, int less_width, int less_height) const {
    const auto scaled = [](Fixed value, int origin, int size, int less) {
      if (size <= less) return value;
      const std::int64_t from = std::int64_t{origin} * Fixed::kOne;
      return Fixed::from_raw(from + (value.raw() - from) * (size - less) / size);
    };
    const Viewport& viewport = scene_.viewport;
    return {scaled(at.x, viewport.x, viewport.width, less_width),
            scaled(at.y, viewport.y, viewport.height, less_height)};
  }

  Point limited(Point at) const {
    const Viewport& viewport = scene_.viewport;
    return resized(at, std::max(0, viewport.x + viewport.width - scene_.target.width),
                   std::max(0, viewport.y + viewport.height - scene_.target.height));
  }

  // Keeps what is true of one more primitive, which was drawn so.
  void narrow(const Predicted& predicted, const SampleCoverage& drawn, Survivors& survivors) const {
    const bool is_decided = predicted.low == predicted.high;
    // Whatever the ties are.
    const LeftOuts decided = is_decided ? allowed(predicted, predicted.low, drawn) : LeftOuts();
    for (int ties = 0; ties < kTies; ++ties) {
      const auto at = static_cast<std::size_t>(ties);
      LeftOuts& left = survivors.left[at];
      if (left.none()) continue;
      if (is_decided) {
        left &= decided;
        narrow_small(predicted.low, drawn, at, survivors);
        continue;
      }
      if (!is_empty(drawn) && !is_within(drawn, predicted.high)) {
        left.reset();
        continue;
      }
      const SampleCoverage covered = predicted.of(ties);
      left &= allowed(predicted, covered, drawn);
      narrow_small(covered, drawn, at, survivors);
    }
  }

  // What may be left out so that of `covered` just `drawn` is there.
  LeftOuts allowed(const Predicted& predicted, const SampleCoverage& covered,
                   const SampleCoverage& drawn) const {
    LeftOuts left;
    const ScenePrimitive& primitive = predicted.primitive();
    const bool is_same = covered == drawn;
    const bool is_nothing = is_empty(drawn);
    left[index_of(LeftOut::nothing)] = is_same;
    left[index_of(LeftOut::everything)] = is_nothing;
    left[index_of(LeftOut::small_ones)] = is_same || is_nothing;
    left[index_of(LeftOut::later_draws)] = primitive.draw > 0 ? is_nothing : is_same;
    const int turn = turn_of(primitive);
    left[index_of(LeftOut::clockwise)] = turn < 0 ? is_nothing : is_same;
    left[index_of(LeftOut::counter_clockwise)] = turn > 0 ? is_nothing : is_same;
    const std::pair rows = rows_of(covered);
    const auto is_without = [&](int row) {
      return rows.first > rows.second ? is_nothing : without_row(covered, row) == drawn;
    };
    left[index_of(LeftOut::lowest_row)] = is_without(rows.first);
    left[index_of(LeftOut::highest_row)] = is_without(rows.second);
    left[index_of(LeftOut::first_row)] = is_without(0);
    return left;
  }

  static void narrow_small(const SampleCoverage& covered, const SampleCoverage& drawn,
                           std::size_t ties, Survivors& survivors) {
    const std::size_t size = size_of(covered);
    if (size == 0) return;
    if (is_empty(drawn))
      survivors.largest_missing[ties] = std::max(survivors.largest_missing[ties], size);
    else
      survivors.smallest_drawn[ties] = std::min(survivors.smallest_drawn[ties], size);
  }

  // Above 0: counter-clockwise; below 0: clockwise; 0: neither, or no triangle.
  static int turn_of(const ScenePrimitive& primitive) {
    if (primitive.kind != PrimitiveKind::triangle || primitive.is_clipped) return 0;
    const Int128 area =
        cross(primitive.positions[0], primitive.positions[1], primitive.positions[2]);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }

  void add(VertexGrid grid, SampledPlace place, bool is_upside_down, const Survivors& survivors) {
    for (int ties = 0; ties < kTies; ++ties) {
      const auto at = static_cast<std::size_t>(ties);
      for (int i = 0; i < kLeftOuts; ++i) {
        const auto left_out = static_cast<LeftOut>(i);
        if (!survivors.left[at][index_of(left_out)]) continue;
        if (left_out == LeftOut::small_ones &&
            (survivors.largest_missing[at] == 0 ||
             survivors.largest_missing[at] >= survivors.smallest_drawn[at]))
          continue;
        const CoverageHypothesis hypothesis{grid, place, ties, is_upside_down, left_out};
        if (left_out == LeftOut::everything && hypothesis.parts() > 1) continue;
        if (hypothesis.parts() > 0) found_.push_back(hypothesis.number());
      }
    }
  }

  // Fragments that fail a test are not told: at each pixel there are as many as were written.
  void explain_by_tests() {
    if (scene_.target.samples > 1 || exact_.hits.empty() || !has_fragment_operations(scene_))
      return;
    for (const PrimitiveCoverage& one : coverage_)
      if (!is_within(one.drawn, one.exact)) return;
    std::vector<std::uint32_t> told(exact_.hits.size());
    for (const Fragment& fragment : rendered_.fragments)
      ++told[rendered_.pixel_index(fragment.x, fragment.y)];
    if (told == exact_.hits)
      found_.push_back(CoverageHypothesis{.left_out = LeftOut::failing}.number());
  }

  // ------------------------------------------------------------------------------------- colours

  void explain_colors() {
    const std::vector<std::uint8_t>& right = exact_.pixels;
    const std::vector<std::uint8_t>& stored = rendered_.pixels;
    // Tolerates the rounding that a colour may have.
    const auto holds = [&](const auto& expected, int tolerance) {
      for (std::size_t i = 0; i < right.size(); i += 4)
        for (std::size_t c = 0; c < 4; ++c)
          if (std::abs(expected(&right[i], c) - int{stored[i + c]}) > tolerance) return false;
      return true;
    };
    using Pixel = const std::uint8_t*;
    const auto add_if = [&](ColorHypothesis hypothesis, int tolerance, const auto& expected) {
      if (holds(expected, tolerance)) found_.push_back(static_cast<std::uint16_t>(hypothesis));
    };
    const auto is_right = holds([](Pixel p, std::size_t c) { return int{p[c]}; }, 1);
    add_if(ColorHypothesis::at_most_254, 0,
           [](Pixel p, std::size_t c) { return std::min(int{p[c]}, 254); });
    if (is_right) return;
    add_if(ColorHypothesis::red_and_blue_exchanged, 1, [](Pixel p, std::size_t c) {
      return int{p[c == 0 ? 2 : c == 2 ? 0 : c]};
    });
    add_if(ColorHypothesis::alpha_first, 1,
           [](Pixel p, std::size_t c) { return int{p[(c + 3) % 4]}; });
    add_if(ColorHypothesis::alpha_always_255, 1,
           [](Pixel p, std::size_t c) { return c == 3 ? 255 : int{p[c]}; });
    add_if(ColorHypothesis::alpha_always_0, 1,
           [](Pixel p, std::size_t c) { return c == 3 ? 0 : int{p[c]}; });
    add_if(ColorHypothesis::all_black, 0,
           [](Pixel p, std::size_t c) { return c == 3 ? int{p[c]} : 0; });
    add_if(ColorHypothesis::inverted, 1,
           [](Pixel p, std::size_t c) { return c == 3 ? int{p[c]} : 255 - p[c]; });
  }

  const Scene& scene_;
  const RuleChoices& choices_;
  const Rendering& exact_;
  const Rendering& rendered_;
  const int bits_;
  const std::vector<ScenePrimitive> primitives_;
  const std::vector<PrimitiveCoverage> coverage_;
  std::vector<std::uint16_t> found_;
};

}  // namespace

std::vector<NumberRun> explaining_hypotheses(const Drawing& drawing) {
  if (!drawing.scene.supersampling.empty()) return {};
  return Explaining(drawing).run();
}

}  // namespace edgecase
