// SPDX-License-Identifier: MIT
//
// The sample positions of a pixel, and where in the pixel attributes are evaluated.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

#include "generate/random_shapes.h"
#include "profile/samples/samples.h"
#include "rules/samples/attribute_location.h"
#include "rules/samples/sample_mask.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

constexpr int kSize = 8;
constexpr PixelPosition kPixel{3, 3};

// The side of the triangle that the edge is.
enum class Side { left, right, bottom, top };
constexpr std::array kSides{Side::left, Side::right, Side::bottom, Side::top};

bool is_upright(Side side) {
  return side == Side::left || side == Side::right;
}

Fixed position_of_step(std::size_t step) {
  return Fixed::from_raw(static_cast<std::int64_t>(step) * Fixed::kOne / kSweepSteps);
}

Scene sweep_scene(Side side, std::size_t step, int samples) {
  const Fixed at = Fixed::from_integer(kPixel.x) + position_of_step(step);
  const Fixed near = Fixed::from_raw(Fixed::kOne / 16);
  const Fixed far = Fixed::from_integer(kSize) - near;
  const bool is_before = side == Side::left || side == Side::bottom;
  const Point tip{is_before ? far : near, Fixed::from_integer(kSize / 2)};
  std::array<Point, 3> points{Point{at, near}, Point{at, far}, tip};
  if (!is_upright(side))
    for (Point& p : points) std::swap(p.x, p.y);
  Scene scene = scene_of(Surface::fbo, kSize, Primitive::triangles, points);
  scene.target.samples = samples;
  return scene;
}

// Narrows intervals by observed edges.
class StepRange {
 public:
  // For an edge of a left or lower side, which excludes what lies before it; or of another side.
  void add(bool is_before, Fixed edge, bool is_covered) {
    if (is_before == is_covered)
      found_.low = std::max(found_.low, edge);
    else
      found_.high = std::min(found_.high, edge);
  }
  const SampleInterval& found() const { return found_; }
  bool is_whole() const { return found_.low <= found_.high; }

 private:
  SampleInterval found_{Fixed(), Fixed::from_integer(1)};
};

bool covers(const Observation& observation, std::size_t sample) {
  const auto& pixels = observation.samples[0][sample];
  return std::find(pixels.begin(), pixels.end(), kPixel) != pixels.end();
}

MeasuredPosition measured(std::span<const Observation> sweeps, std::size_t sample, Snap snap) {
  StepRange x;
  StepRange y;
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    const Side side = kSides[i];
    StepRange& interval = is_upright(side) ? x : y;
    const auto edges = sweeps.subspan(i * (kSweepSteps + 1), kSweepSteps + 1);
    for (std::size_t step = 0; step < edges.size(); ++step) {
      if (!edges[step].failure.empty()) continue;
      interval.add(side == Side::left || side == Side::bottom, snap(position_of_step(step)),
                   covers(edges[step], sample));
    }
  }
  // A sample that no edge covers, or every edge, has no interval.
  return {{}, x.found(), y.found(), x.is_whole() && y.is_whole()};
}

bool lies_at(const MeasuredPosition& position, Point point) {
  MeasuredPosition other = position;
  other.reported = point;
  return other.is_as_reported();
}

// The first placement that puts every sample where it was found.
std::string placement_of(const std::vector<MeasuredPosition>& positions,
                         const SamplePositions& reported) {
  for (const SamplePlacement& placement : placements_of(static_cast<int>(reported.size()))) {
    const SamplePositions at = placed(placement, reported);
    if (std::equal(positions.begin(), positions.end(), at.begin(), at.end(), lies_at))
      return name_of(placement);
  }
  return "";
}

}  // namespace

std::vector<Scene> sweep_scenes(int samples) {
  std::vector<Scene> scenes;
  for (const Side side : kSides)
    for (std::size_t step = 0; step <= kSweepSteps; ++step)
      scenes.push_back(sweep_scene(side, step, samples));
  return scenes;
}

MeasuredPositions measured_positions(std::span<const Observation> sweeps, Snap snap) {
  MeasuredPositions result;
  result.samples = sweeps.front().scene.target.samples;
  const auto drawn = std::find_if(sweeps.begin(), sweeps.end(), [](const Observation& one) {
    return one.failure.empty() && !one.positions.empty();
  });
  if (drawn == sweeps.end()) return result;
  const SamplePositions& reported = drawn->positions;
  for (std::size_t sample = 0; sample < reported.size(); ++sample) {
    result.positions.push_back(measured(sweeps, sample, snap));
    result.positions.back().reported = reported[sample];
  }
  result.placement = placement_of(result.positions, reported);
  return result;
}

// ------------------------------------------------------------------------------------ invocations

namespace {

constexpr double kNear = 1.0 / 64;  // pixels

struct Location {
  double x = 0;
  double y = 0;
};

Location in_pixels(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

bool is_near(Location a, Location b) {
  return std::abs(a.x - b.x) < kNear && std::abs(a.y - b.y) < kNear;
}

// Where in the pixel the colour was evaluated, by the planes of the colours.
Location location_of(const Fragment& fragment) {
  return {kPlainSize * fragment.color[0] - fragment.x, kPlainSize * fragment.color[1] - fragment.y};
}

Location mean_of(const SamplePositions& positions, std::uint32_t mask) {
  Location sum;
  for (std::size_t s = 0; s < positions.size(); ++s) {
    if ((mask >> s & 1) == 0) continue;
    sum.x += positions[s].x.to_double() / std::popcount(mask);
    sum.y += positions[s].y.to_double() / std::popcount(mask);
  }
  return sum;
}

// `mask`: the pixel's samples that the primitive covers, more than one.
const char* name_of_location(const Fragment& fragment, std::uint32_t mask,
                             const SamplePositions& positions) {
  const Location location = location_of(fragment);
  const auto sample = [&](std::uint32_t of) {
    return in_pixels(positions[static_cast<std::size_t>(std::countr_zero(of))]);
  };
  if (std::has_single_bit(fragment.coverage) && is_near(location, sample(fragment.coverage)))
    return kOwnSample;
  if (is_near(location, in_pixels(centre_of_pixel()))) return "centre";
  if (is_near(location, sample(mask))) return "first covered sample";
  if (is_near(location, mean_of(positions, mask))) return "mean of the covered samples";
  return "elsewhere";
}

}  // namespace

InvocationRow empty_row(const InvocationsAsked& asked, int samples) {
  InvocationRow row;
  row.asked = asked.name;
  row.location = name_of(asked.use.location);
  row.at_sample = is_at_sample(asked.use);
  row.least = least_invocations(asked.use, samples);
  return row;
}

void add_invocations(const Rendering& rendering, InvocationRow& row) {
  const auto& fragments = rendering.fragments;
  if (rendering.sample_positions.size() != static_cast<std::size_t>(rendering.samples)) return;
  for (std::size_t first = 0; first < fragments.size();) {
    std::size_t end = first;
    std::uint32_t mask = 0;
    while (end < fragments.size() && fragments[end].x == fragments[first].x &&
           fragments[end].y == fragments[first].y)
      mask |= fragments[end++].coverage;
    const int covered = std::popcount(mask);
    ++row.invocations[covered][static_cast<int>(end - first)];
    auto& locations = mask == mask_of_all(rendering.samples) ? row.whole : row.partial;
    // A single sample is the first, the mean and its own.
    for (std::size_t i = first; i < end && covered > 1; ++i)
      ++locations[name_of_location(fragments[i], mask, rendering.sample_positions)];
    first = end;
  }
}

}  // namespace edgecase
