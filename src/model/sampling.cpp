// SPDX-License-Identifier: MIT
#include "model/sampling.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <string>

#include "exact/homogeneous.h"
#include "exact/numeral.h"
#include "model/scene.h"

namespace edgecase {

Point place_in(PixelPosition pixel, Point within) {
  return {Fixed::from_integer(pixel.x) + within.x, Fixed::from_integer(pixel.y) + within.y};
}

int least_invocations(const Multisampling& multisampling, int samples) {
  if (!multisampling.enabled) return 1;
  if (multisampling.location == AttributeLocation::sample) return samples;
  // The product of a float32 and a small integer is exact in double precision.
  const double share = static_cast<double>(multisampling.min_sample_shading.value_or(0));
  return std::clamp(static_cast<int>(std::ceil(share * samples)), 1, samples);
}

namespace {

constexpr int kFloat32Bits = 24;  // significant ones
constexpr int kGridBits = 30;     // grid of clip x and y below the leading bit of w

// The integer nearest to a quotient among those of at most 24 significant bits, ties to even. 0 <
// denominator <= 2^30; the quotient is at most 2^32.
std::int64_t nearest_float32(std::int64_t numerator, std::int64_t denominator) {
  const auto magnitude = static_cast<std::uint64_t>(std::abs(numerator));
  const auto below = static_cast<std::uint64_t>(denominator);
  assert(0 < denominator && denominator <= std::int64_t{1} << 30);
  assert(magnitude / below <= std::uint64_t{1} << 32);
  const int spare = std::max(0, static_cast<int>(std::bit_width(magnitude / below)) - kFloat32Bits);
  const std::uint64_t step = below << spare;
  const std::uint64_t twice_rest = 2 * (magnitude % step);
  std::uint64_t steps = magnitude / step;
  if (twice_rest > step || (twice_rest == step && steps % 2 == 1)) ++steps;
  const auto nearest = static_cast<std::int64_t>(steps << spare);
  return numerator < 0 ? -nearest : nearest;
}

// With 2^e the power of two at or below w, units are 2^(e-30): |value| <= w < 2^31, all whole. The
// sum's numerator is at most 2^31 2^15 2^15 + 2^17 2^31.
float moved_clip(float value, float w, Fixed shift, int size) {
  assert(std::fabs(value) <= w);
  const int exponent = std::ilogb(w) - kGridBits;
  const auto units = [&](float number) {
    return static_cast<std::int64_t>(std::ldexp(static_cast<double>(number), -exponent));
  };
  // The addend is 2 shift w / size, with the shift in units of 2^-16.
  const std::int64_t denominator = std::int64_t{size} * (Fixed::kOne / 2);
  const std::int64_t sum = units(value) * denominator + shift.raw() * units(w);
  return static_cast<float>(
      std::ldexp(static_cast<double>(nearest_float32(sum, denominator)), exponent));
}

}  // namespace

std::uint64_t pass_work(const Scene& scene) {
  std::uint64_t work = static_cast<std::uint64_t>(scene.target.width) *
                       static_cast<std::uint64_t>(scene.target.height);
  for (const auto& texture : scene.textures)
    if (texture->generated) work += texture->levels.front().texels.size() / 4;
  for (const Draw& draw : scene.draws) work += draw.vertices.size();
  return work * scene.supersampling.size();
}

Point shift_of(const ShadingPass& pass) {
  const Fixed centre = Fixed::centre_of(0);
  return {centre - pass.at.x, centre - pass.at.y};
}

Vertex moved_vertex(const Vertex& vertex, Point shift, const Viewport& viewport) {
  Vertex moved = vertex;
  if (moved.clip) {
    ClipPosition& clip = *moved.clip;
    clip.x = moved_clip(clip.x, clip.w, shift.x, viewport.width);
    clip.y = moved_clip(clip.y, clip.w, shift.y, viewport.height);
    moved.position = nearest_point(window_position(clip, viewport));
  } else {
    moved.position = {vertex.position.x + shift.x, vertex.position.y + shift.y};
  }
  return moved;
}

bool is_in_range(const Vertex& vertex) {
  if (!vertex.position.x.in_coordinate_range() || !vertex.position.y.in_coordinate_range())
    return false;
  if (!vertex.clip) return true;
  const ClipPosition& clip = *vertex.clip;
  return std::fabs(clip.x) <= clip.w && std::fabs(clip.y) <= clip.w;
}

Scene pass_of(const Scene& scene, std::size_t k) {
  Scene pass = scene;
  pass.supersampling.clear();
  const Point shift = shift_of(scene.supersampling.at(k));
  for (Draw& draw : pass.draws)
    for (Vertex& vertex : draw.vertices) vertex = moved_vertex(vertex, shift, scene.viewport);
  return pass;
}

std::string text_of_pass(const Supersampling& passes, std::size_t k) {
  const ShadingPass& pass = passes.at(k);
  return "pass " + std::to_string(k + 1) + " of " + std::to_string(passes.size()) + " (at " +
         to_decimal(pass.at.x) + ", " + to_decimal(pass.at.y) + "; weight " +
         std::to_string(pass.weight) + ")";
}

std::vector<Scene> passes_of(const Scene& scene) {
  std::vector<Scene> passes;
  passes.reserve(scene.supersampling.size());
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k) passes.push_back(pass_of(scene, k));
  return passes;
}

}  // namespace edgecase
