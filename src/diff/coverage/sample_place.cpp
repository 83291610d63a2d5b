// SPDX-License-Identifier: MIT
#include "diff/coverage/sample_place.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "diff/coverage/seam_hits.h"
#include "diff/coverage/size_latitude.h"
#include "diff/findings/patience.h"
#include "raster/samples.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

constexpr Fixed kHalfPixel = Fixed::from_raw(Fixed::kOne / 2);
// Half the sides of the last squares.
constexpr Fixed kFine = Fixed::from_raw(Fixed::kOne / 256);
constexpr Fixed kCoarse = Fixed::from_raw(Fixed::kOne / 32);

// Places no farther than `half` from the middle, along either axis.
struct Square {
  Point middle;
  Fixed half;
};

Square around_neighbour(int dx, int dy) {
  return {{Fixed::from_integer(dx) + kHalfPixel, Fixed::from_integer(dy) + kHalfPixel}, kHalfPixel};
}

// What a primitive may cover, with the sample anywhere in a square: a sample at most so far from
// another place is like one there with the vertices moved by as much.
struct LoosePrimitive {
  const ScenePrimitive& primitive;
  const Latitudes latitudes;

  bool may_be(bool covered, PixelPosition pixel, const Square& square) const {
    const Point sample = place_in(pixel, square.middle);
    Latitudes wider = latitudes;
    wider.reach = wider.reach + square.half;
    return covered ? possibly_covered(primitive, sample, wider)
                   : possibly_uncovered(primitive, sample, wider);
  }
};

// That a primitive covers the sample in a pixel, or leaves it out.
struct Observation {
  const LoosePrimitive* primitive = nullptr;
  PixelPosition pixel;
  bool is_covered = false;

  bool allows(const Square& square) const { return primitive->may_be(is_covered, pixel, square); }
};

// True if where the sample lies decides alone whether the primitive covers it: clipping, culling,
// masks and the alphas of other samples have no say.
bool is_told_by_place(const ScenePrimitive& primitive, int sample, const Target& target) {
  const Draw& state = *primitive.state;
  return is_multisampled(state, target) && !primitive.is_clipped && state.cull == CullMode::none &&
         (state.multisampling.mask >> sample & 1) != 0 && !state.multisampling.alpha_to_coverage;
}

// The pixels near the primitive whose sample nothing cuts away, wherever it lies: those with all
// neighbours inside the target, the viewport and the scissor rectangle.
PixelBounds pixels_inside(const ScenePrimitive& primitive, const Latitudes& latitudes,
                          const Target& target) {
  PixelBounds inside =
      common_part({0, 0, target.width - 1, target.height - 1}, pixels_in(primitive.viewport));
  if (primitive.state->scissor) inside = common_part(inside, pixels_in(*primitive.state->scissor));
  inside = {inside.x_min + 1, inside.y_min + 1, inside.x_max - 1, inside.y_max - 1};
  const Fixed size = primitive.kind == PrimitiveKind::triangle ? Fixed() : latitudes.sizes.high;
  const Fixed around = size + latitudes.reach + Fixed::from_integer(2);
  std::optional<PixelBounds> near;
  for (int v = 0; v < vertices_of(primitive.kind); ++v) {
    const Point p = latitudes.positions[static_cast<std::size_t>(v)];
    const auto pixel = [](Fixed f) {
      return static_cast<int>(std::clamp<std::int64_t>(f.floor(), -1, kMaxTargetSize));
    };
    const PixelBounds here{pixel(p.x - around), pixel(p.y - around), pixel(p.x + around),
                           pixel(p.y + around)};
    near = !near
               ? here
               : PixelBounds{std::min(near->x_min, here.x_min), std::min(near->y_min, here.y_min),
                             std::max(near->x_max, here.x_max), std::max(near->y_max, here.y_max)};
  }
  return common_part(inside, *near);
}

// Of large primitives some pixels are asked: fewer forbid no more.
int step_through(const PixelBounds& pixels) {
  constexpr std::int64_t kMost = 16'384;
  const std::int64_t area = (std::int64_t{pixels.x_max} - pixels.x_min + 1) *
                            (std::int64_t{pixels.y_max} - pixels.y_min + 1);
  int step = 1;
  while (area > kMost * step * step) ++step;
  return step;
}

class PlaceSearch {
 public:
  PlaceSearch(const CoverageContext& context, int sample, Fixed least) : least_(least) {
    for (const ScenePrimitive& primitive : context.primitives)
      if (is_told_by_place(primitive, sample, context.scene.target))
        observe(primitive, sample, context);
  }

  // Calls `visit` with each of the last squares that remains. Where `is_known`, a square need not
  // be visited.
  template <class IsKnown, class Visit>
  void run(const IsKnown& is_known, const Visit& visit) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) search(around_neighbour(dx, dy), is_known, visit);
  }

 private:
  // Notes what the primitive covers, where the place of the sample matters.
  void observe(const ScenePrimitive& primitive, int sample, const CoverageContext& context) {
    const PrimitiveCoverage& coverage = context.coverage[static_cast<std::size_t>(primitive.index)];
    const std::vector<PixelPosition>& drawn = coverage.drawn[static_cast<std::size_t>(sample)];
    const SupportedSizes sizes = sizes_that_excuse(primitive, coverage, context);
    const LoosePrimitive& loose = primitives_.emplace_back(
        LoosePrimitive{primitive, latitudes_of(primitive, context.bits, sizes)});
    const PixelBounds inside = pixels_inside(primitive, loose.latitudes, context.scene.target);
    const int step = step_through(inside);
    constexpr Square kEverywhere{{kHalfPixel, kHalfPixel}, Fixed::from_raw(3 * Fixed::kOne / 2)};
    for (int y = inside.y_min; y <= inside.y_max; y += step) {
      Patience::check();
      for (int x = inside.x_min; x <= inside.x_max; x += step) {
        const bool is_covered = hits_at(drawn, {x, y}) > 0;
        if (loose.may_be(!is_covered, {x, y}, kEverywhere))
          observations_.push_back({&loose, {x, y}, is_covered});
      }
    }
  }

  // The observation that forbids most is asked first.
  template <class IsKnown, class Visit>
  void search(const Square& square, const IsKnown& is_known, const Visit& visit) {
    if (is_known(square)) return;
    const auto forbids = std::ranges::find_if(
        observations_, [&](const Observation& one) { return !one.allows(square); });
    if (forbids != observations_.end()) {
      std::swap(*forbids, observations_.front());
      return;
    }
    if (square.half <= least_) return visit(square);
    const Fixed half = Fixed::from_raw(square.half.raw() / 2);
    for (const Fixed dy : {-half, half})
      for (const Fixed dx : {-half, half})
        search({{square.middle.x + dx, square.middle.y + dy}, half}, is_known, visit);
  }

  const Fixed least_;
  std::deque<LoosePrimitive> primitives_;
  std::vector<Observation> observations_;
};

PlaceBox box_of(const Square& square) {
  const auto around = [&](Fixed middle) {
    return Interval((middle - square.half).to_double(), (middle + square.half).to_double());
  };
  return {around(square.middle.x), around(square.middle.y)};
}

bool contains(const Interval& whole, const Interval& part) {
  return whole.low <= part.low && part.high <= whole.high;
}

std::optional<PlaceBox> box_around(PlaceSearch search) {
  std::optional<PlaceBox> box;
  search.run(
      [&](const Square& square) {  // it would not grow the box
        const PlaceBox one = box_of(square);
        return box && contains(box->x, one.x) && contains(box->y, one.y);
      },
      [&](const Square& square) {
        const PlaceBox one = box_of(square);
        box = box ? PlaceBox{hull(box->x, one.x), hull(box->y, one.y)} : one;
      });
  return box;
}

}  // namespace

const std::optional<PlaceBox>& SamplePlaces::of(int sample) {
  const auto [known, is_new] = known_.try_emplace(sample);
  if (is_new) known->second = box_around(PlaceSearch(context_, sample, kFine));
  return known->second;
}

std::optional<PlaceBox> SamplePlaces::about(int sample) const {
  return box_around(PlaceSearch(context_, sample, kCoarse));
}

PlaceCells SamplePlaces::cells(int sample) const {
  PlaceCells cells;
  PlaceSearch(context_, sample, kCoarse)
      .run([](const Square&) { return false; },
           [&](const Square& square) {
             cells.add(square.middle.x.to_double(), square.middle.y.to_double());
           });
  return cells;
}

bool have_one_place(const CoverageContext& context) {
  return context.scene.target.surface == Surface::fbo && !context.reported.empty();
}

namespace {

// True if finding where samples lie is cheap: a run needs no more than its small scenes.
bool is_small(const CoverageContext& context) {
  constexpr std::size_t kMost = 4096;  // samples of all primitives
  const Target& target = context.scene.target;
  return context.primitives.size() * static_cast<std::size_t>(target.samples) *
             static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height) <=
         kMost;
}

}  // namespace

void note_places(const CoverageContext& context, SamplePlaces& places, Result& result) {
  // Samples that a case places lie elsewhere in the next.
  if (!have_one_place(context) || !context.scene.target.sample_positions.empty()) return;
  constexpr double kTelling = 0.5;  // pixels
  using Kind = SingleThing::Kind;
  const int samples = context.scene.target.samples;
  for (int sample = 0; sample < samples; ++sample) {
    const bool is_elsewhere = any_class(result, [&](const DisagreementClass& d) {
      return d.ruling == kRulingOnOtherPlaces && d.sample == sample;
    });
    if (!is_elsewhere && !is_small(context)) continue;
    const auto place = is_elsewhere ? places.of(sample) : places.about(sample);
    if (!place) continue;
    if (is_elsewhere)
      result.shown.push_back({{Kind::sample_cells, samples, sample}, 0, 0, places.cells(sample)});
    for (const auto& [kind, where] :
         {std::pair(Kind::sample_x, place->x), std::pair(Kind::sample_y, place->y)})
      if (is_elsewhere || where.high - where.low < kTelling)
        result.shown.push_back({{kind, samples, sample}, where.low, where.high, {}});
  }
}

}  // namespace edgecase
