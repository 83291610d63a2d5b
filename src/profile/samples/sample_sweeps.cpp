// SPDX-License-Identifier: MIT
#include "profile/samples/sample_sweeps.h"

#include <algorithm>
#include <array>
#include <utility>

#include "generate/scene_parts.h"
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

Fixed place_of_step(std::size_t step) {
  return Fixed::from_raw(static_cast<std::int64_t>(step) * Fixed::kOne / kSweepSteps);
}

Scene sweep_scene(Side side, std::size_t step, int samples) {
  const Fixed at = Fixed::from_integer(kPixel.x) + place_of_step(step);
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

// Narrows intervals as edges are seen.
class StepRange {
 public:
  // An edge of a left or lower side, that leaves out what lies before it; or of the other sides.
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
      interval.add(side == Side::left || side == Side::bottom, snap(place_of_step(step)),
                   covers(edges[step], sample));
    }
  }
  // What no edge covers, or every edge, contradicts itself.
  return {{}, x.found(), y.found(), x.is_whole() && y.is_whole()};
}

bool has_place(const MeasuredPosition& position, Point place) {
  MeasuredPosition other = position;
  other.reported = place;
  return other.is_as_reported();
}

// The first placement that puts every sample where it was found.
std::string placement_of(const std::vector<MeasuredPosition>& positions,
                         const SamplePositions& reported) {
  for (const SamplePlacement& placement : placements_of(static_cast<int>(reported.size()))) {
    const SamplePositions at = placed(placement, reported);
    if (std::equal(positions.begin(), positions.end(), at.begin(), at.end(), has_place))
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

}  // namespace edgecase
