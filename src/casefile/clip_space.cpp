// SPDX-License-Identifier: MIT
#include "casefile/clip_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "casefile/float_numeral.h"
#include "exact/homogeneous.h"

namespace edgecase {
namespace {

constexpr int kGridBits = 30;  // of each coordinate below the leading bit of the largest

float largest_of(const ClipPosition& clip) {
  return std::max({std::fabs(clip.x), std::fabs(clip.y), std::fabs(clip.z), std::fabs(clip.w)});
}

// n with 2^(e-30) the unit of the grid: its exponent.
int grid_exponent(const ClipPosition& clip) {
  int exponent = 0;  // the largest = m 2^exponent, m from 1/2 on
  std::frexp(largest_of(clip), &exponent);
  return exponent - 1 - kGridBits;
}

// Values of the largest magnitude at most: 2^31 units. Float32 numbers above 2^24 units are whole
// already.
float rounded(float value, int exponent) {
  const double units = std::nearbyint(std::ldexp(static_cast<double>(value), -exponent));
  return static_cast<float>(std::ldexp(units, exponent)) + 0.0F;
}

}  // namespace

ClipPosition round_to_grid(const ClipPosition& clip) {
  const int exponent = grid_exponent(clip);
  return {rounded(clip.x, exponent), rounded(clip.y, exponent), rounded(clip.z, exponent),
          rounded(clip.w, exponent)};
}

std::string words_of(const ClipPosition& clip) {
  return fmt::format("({}, {}, {}, {})", short_decimal(clip.x), short_decimal(clip.y),
                     short_decimal(clip.z), short_decimal(clip.w));
}

std::optional<Inexactness> find_clip_fault(const ClipPosition& clip, const std::string& subject) {
  if (!std::isfinite(clip.w) || !std::isfinite(clip.x) || !std::isfinite(clip.y) ||
      !std::isfinite(clip.z))
    return Inexactness{
        fmt::format("{} has clip coordinates beyond float32, {}", subject, words_of(clip)),
        "use smaller numbers"};
  const float largest = largest_of(clip);
  if (largest >= kMinW && largest <= kMaxW) return std::nullopt;
  return Inexactness{
      fmt::format("{} has clip coordinates {}, out of range", subject, words_of(clip)),
      fmt::format("keep the largest of |x|, |y|, |z| and |w| from {} to {}", exact_decimal(kMinW),
                  exact_decimal(kMaxW))};
}

std::optional<Inexactness> find_volume_fault(const ClipPosition& clip, const std::string& subject) {
  if (!(clip.w > 0))
    return Inexactness{
        fmt::format("{} lies at or behind the eye: its w is {}", subject, short_decimal(clip.w)),
        "move it in front of the eye, where w is above 0"};
  const std::pair<char, float> axes[] = {{'x', clip.x}, {'y', clip.y}, {'z', clip.z}};
  for (const auto& [axis, value] : axes)
    if (std::fabs(value) > clip.w)
      return Inexactness{
          fmt::format("{} lies outside the clip volume: its clip coordinates are {}, and {} is not "
                      "within -w and w",
                      subject, words_of(clip), axis),
          axis == 'z' ? "move it between the near and the far plane" : "move it into the view"};
  return std::nullopt;
}

// A coordinate counts at most 2^31 units, twice over: its window coordinate, times w, at most 2^31
// times the sum below (model/scene.h's window_position), and is to be at most 2^46.
bool fits_clipping(const Viewport& viewport) {
  constexpr int kMostUnits = 1 << 15;
  return viewport.width + std::abs(2 * viewport.x + viewport.width) <= kMostUnits &&
         viewport.height + std::abs(2 * viewport.y + viewport.height) <= kMostUnits;
}

void place_clip_vertex(const Viewport& viewport, Vertex& vertex) {
  const ClipPosition& clip = *vertex.clip;
  vertex.w = clip.w;
  vertex.position = {};
  vertex.z = {};
  if (!is_in_clip_volume(clip)) return;
  vertex.position = nearest_point(window_position(clip, viewport));
  const int exponent = grid_exponent(clip);
  const auto units = [&](float value) {
    return static_cast<std::int64_t>(std::ldexp(static_cast<double>(value), -exponent));
  };
  vertex.z = nearest_point({units(clip.z), 0, units(clip.w)}).x;
}

}  // namespace edgecase
