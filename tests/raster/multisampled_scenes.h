// SPDX-License-Identifier: MIT
//
// Scenes of multisampled targets for tests, and what they cover, as text.
#pragma once

#include <initializer_list>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "raster/rasterizer.h"

namespace edgecase {

// One draw of a primitive type on a square target of so many samples.
Scene multisampled_scene(int size, int samples, Primitive primitive, std::vector<Point> positions);

// The coverage masks of a scene's pixels under the policy of OpenGL, top row first, hexadecimal
// digits of as many places as the samples need, "." for none; of several fragments of a pixel all
// together. Rows end in "/".
std::string masks_drawn(const Rendering& rendering);

// Which samples of a pixel a primitive covers.
std::uint32_t mask_at(const SampleCoverage& coverage, PixelPosition pixel);

// The tie rules that move samples.
std::vector<std::string> perturbed_ties();

// Random numbers, the same on every machine for a seed.
class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : engine_(seed) {}
  // From low to high.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low +
           static_cast<std::int64_t>(engine_() % (static_cast<std::uint64_t>(high - low) + 1));
  }
  // A multiple of 1/parts from low to high pixels, in x and in y.
  Point point(int low, int high, int parts) {
    return {number(low, high, parts), number(low, high, parts)};
  }
  // Positions of samples, multiples of 1/parts.
  SamplePositions positions(int samples, int parts = 16);

 private:
  Fixed number(int low, int high, int parts) {
    return Fixed::from_raw(between(std::int64_t{low} * parts, std::int64_t{high} * parts) *
                           (Fixed::kOne / parts));
  }
  std::mt19937_64 engine_;
};

}  // namespace edgecase
