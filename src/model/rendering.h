// SPDX-License-Identifier: MIT
//
// Rendering: what a renderer made of a scene. Exact, OpenGL and other programs share this type;
// doubles hold the float32 values of a GL without loss.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "model/names.h"
#include "model/sampling.h"
#include "model/texture.h"

namespace edgecase {

// The derivative functions, in the order of FragmentDetail::derivatives.
enum class Derivative { x, y, x_fine, y_fine, x_coarse, y_coarse };
template <>
inline constexpr auto kNames<Derivative> =
    std::to_array<Named<Derivative>>({{Derivative::x, "dFdx"},
                                      {Derivative::y, "dFdy"},
                                      {Derivative::x_fine, "dFdxFine"},
                                      {Derivative::y_fine, "dFdyFine"},
                                      {Derivative::x_coarse, "dFdxCoarse"},
                                      {Derivative::y_coarse, "dFdyCoarse"}});
constexpr std::size_t kDerivatives = kNames<Derivative>.size();

// For each derivative function the values of four components, per pixel; null: not reported. Most
// fragments report none, and then this takes little memory.
class DerivativeValues {
 public:
  using Value = std::optional<std::array<double, 4>>;

  const Value& operator[](std::size_t function) const {
    static constexpr Value kNone;
    return values_.empty() ? kNone : values_[function];
  }
  Value& operator[](std::size_t function) {
    values_.resize(kDerivatives);
    return values_[function];
  }
  bool has_any() const {
    return std::ranges::any_of(values_, [](const Value& value) { return value.has_value(); });
  }
  friend bool operator==(const DerivativeValues& a, const DerivativeValues& b) {
    for (std::size_t i = 0; i < kDerivatives; ++i)
      if (a[i] != b[i]) return false;
    return true;
  }

 private:
  std::vector<Value> values_;  // kDerivatives, or none
};

// Further values of a fragment; null if the renderer does not report them.
struct FragmentDetail {
  // gl_FragCoord: x, y in pixels, z in 0 to 1, 1/w.
  std::optional<std::array<double, 4>> coordinates;
  // Of the colour's four components. For a textured draw: s, t and zeros.
  DerivativeValues derivatives;
  // For a textured draw: s and t, as interpolated.
  std::optional<std::array<double, 2>> texture_coordinates;
  // For a textured draw, the results of textureQueryLod: the level that is accessed, with 0 for the
  // base level, and lambda' before clamping.
  std::optional<std::array<double, 2>> level_of_detail;
};

// One fragment shader invocation.
struct Fragment {
  int x = 0;          // pixel column, 0 to width - 1
  int y = 0;          // pixel row, 0 to height - 1, y up
  int primitive = 0;  // index in drawing order, see primitives_of
  // Bit s: sample s is covered and in the draw's sample mask, as in gl_SampleMaskIn; if the shader
  // runs per sample, the samples of this invocation. 1 without multisampling, whichever samples are
  // written. Alpha to coverage follows the shader and clears no bits here.
  std::uint32_t coverage = 1;
  double depth = 0;  // window depth, 0 to 1
  std::array<double, 4>
      color{};            // as the shader writes it, before conversion to the target's format
  bool has_depth = true;  // false: the renderer reports no depth
  bool has_color = true;  // false: the renderer reports no colour per fragment
  // Index into Rendering::details, which fragments with equal details may share; -1: none reported.
  int detail = -1;
};

// The order in which renderings are stored: by pixel (row, then column), primitive and coverage.
bool precedes(const Fragment& a, const Fragment& b);

// Where an image of the scene is drawn otherwise than a law has it (diff/invariance.h).
struct Variance {
  PixelPosition pixel;  // of the scene
  int primitive = -1;   // -1: the pixel as a whole
  int ruling = 0;       // that judges it
  std::string what;     // what differs, and how the image does
};

// Images of a scene that were held against it, and those that the renderer does not support.
struct ImageCounts {
  int drawn = 0;
  int refused = 0;
  friend bool operator==(const ImageCounts&, const ImageCounts&) = default;
};

struct Rendering {
  int width = 0;
  int height = 0;
  int samples = 1;
  // The sample positions of a pixel, as reported by the renderer; empty if not reported.
  SamplePositions sample_positions;
  // RGBA8, row by row from the bottom, 4 * width * height; resolved if the target is multisampled.
  // Empty if only coverage was requested.
  std::vector<std::uint8_t> pixels;
  // Of a multisampled target before it is resolved: one such plane per sample. Optional.
  std::vector<std::uint8_t> sample_pixels;
  // Fragments per pixel that pass all tests, counted in a separate pass; one plane per sample if
  // the target is multisampled. Empty if not counted.
  std::vector<std::uint32_t> hits;
  // All fragments that the rasterizer makes, including those that later fail tests; sorted by
  // `precedes`, equal ones in drawing order.
  std::vector<Fragment> fragments;
  std::vector<FragmentDetail> details;  // indexed by Fragment::detail
  // The depth buffer, 0 to 1, row by row from the bottom, one plane per sample; empty if the target
  // has none.
  std::vector<double> depths;
  // The stencil buffer, laid out in the same way.
  std::vector<std::uint8_t> stencils;
  // Whole mip chains as the renderer made them, keyed by the number of the texture, for textures
  // with generated levels. Optional.
  std::map<std::size_t, std::vector<TextureLevel>> mip_chains;
  // The complete renderings of a supersampled scene's passes, in order. Only they have fragments,
  // hits, depths and mip chains.
  std::vector<Rendering> passes;
  // The weighted mean of what the passes show, before conversion to 8 bits: red, green, blue,
  // alpha, row by row from the bottom. A pass shows the colour of the last fragment, as the shader
  // writes it, or the clear colour. `pixels` is to_unorm8 of this.
  std::vector<double> accumulated;
  ImageCounts images;  // of the scene (run/invariant_renderer.h)
  std::vector<Variance> variances;

  std::size_t pixel_index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  // The same within the planes of samples.
  std::size_t sample_index(int x, int y, int sample) const {
    return static_cast<std::size_t>(sample) * static_cast<std::size_t>(width) *
               static_cast<std::size_t>(height) +
           pixel_index(x, y);
  }
};

// Sorts the fragments by `precedes`, stably.
void sort_fragments(Rendering& rendering);

// The unsigned 8-bit value nearest to a colour component, which is clamped to [0, 1] first; a tie
// goes to the even value; NaN becomes 0. GL 4.6 core, 2.3.5.2.
std::uint8_t to_unorm8(double component);

// Lists of fragments: comparison to the bit, and sorting by small numbers.

// Comparison to the bit: NaN equals itself, and 0 differs from -0.
inline std::uint64_t bit_pattern(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

// Whether they cover the same samples of one pixel, for one primitive.
inline bool cover_alike(const Fragment& a, const Fragment& b) {
  return a.x == b.x && a.y == b.y && a.primitive == b.primitive && a.coverage == b.coverage;
}

// Whether they have the same depth and colour.
inline bool have_equal_values(const Fragment& a, const Fragment& b) {
  return bit_pattern(a.depth) == bit_pattern(b.depth) &&
         std::ranges::equal(a.color, b.color, {}, bit_pattern, bit_pattern);
}

// Sorts the items by index_of(item), which is below `count`, in linear time and stably.
template <class Item, class IndexOf>
void distribute(std::vector<Item>& items, std::size_t count, IndexOf index_of) {
  std::vector<std::size_t> first(count + 1);
  for (const Item& item : items) ++first[index_of(item) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[first[index_of(item)]++] = item;
  items = std::move(sorted);
}

}  // namespace edgecase
