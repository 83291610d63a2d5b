// SPDX-License-Identifier: MIT
#include "casefile/clip_space.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "casefile/float_numeral.h"
#include "exact/homogeneous.h"

namespace edgecase {
namespace {

constexpr int kGridBits = 30;  // of x, y and z below the leading bit of w

// n with 2^(e-30) the unit of the grid: its exponent.
int grid_exponent(float w) {
  int exponent = 0;  // w = m 2^exponent, m from 1/2 on
  std::frexp(w, &exponent);
  return exponent - 1 - kGridBits;
}

// Values of magnitude w at most: 2^31 units. Float32 numbers above 2^24 units are whole already.
float rounded(float value, int exponent) {
  const double units = std::nearbyint(std::ldexp(static_cast<double>(value), -exponent));
  return static_cast<float>(std::ldexp(units, exponent)) + 0.0F;
}

}  // namespace

ClipPosition round_to_grid(const ClipPosition& clip) {
  const int exponent = grid_exponent(clip.w);
  return {rounded(clip.x, exponent), rounded(clip.y, exponent), rounded(clip.z, exponent), clip.w};
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
  if (!(clip.w > 0))
    return Inexactness{
        fmt::format("{} lies at or behind the eye: its w is {}, and clipping is not supported yet",
                    subject, short_decimal(clip.w)),
        "move it in front of the eye, where w is above 0"};
  const std::pair<char, float> axes[] = {{'x', clip.x}, {'y', clip.y}, {'z', clip.z}};
  for (const auto& [axis, value] : axes)
    if (!(std::fabs(value) < clip.w))
      return Inexactness{
          fmt::format("{} lies outside the clip volume: its clip coordinates are {}, {} is not "
                      "strictly between -w and w, and clipping is not supported yet",
                      subject, words_of(clip), axis),
          axis == 'z' ? "move it between the near and the far plane" : "move it into the view"};
  if (clip.w < kMinW || clip.w > kMaxW)
    return Inexactness{
        fmt::format("{} has w = {}, out of range", subject, short_decimal(clip.w)),
        fmt::format("keep w from {} to {}", exact_decimal(kMinW), exact_decimal(kMaxW))};
  return std::nullopt;
}

void place_clip_vertex(const Viewport& viewport, Vertex& vertex) {
  const ClipPosition& clip = *vertex.clip;
  vertex.position = nearest_point(window_position(clip, viewport));
  const int exponent = grid_exponent(clip.w);
  const auto units = [&](float value) {
    return static_cast<std::int64_t>(std::ldexp(static_cast<double>(value), -exponent));
  };
  vertex.z = nearest_point({units(clip.z), 0, units(clip.w)}).x;
  vertex.w = clip.w;
}

}  // namespace edgecase
