// SPDX-License-Identifier: MIT
//
// Rendering: what a renderer made of a scene. The same type for the exact side, for OpenGL and for
// any other program; doubles hold the float32 values of a GL without loss.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "model/names.h"
#include "model/sampling.h"
#include "model/texture.h"

namespace edgecase {

// Ways to take a derivative, in the order of FragmentDetail::derivatives.
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

// What a fragment is asked for beside colour and depth; null where the renderer does not tell it.
struct FragmentDetail {
  // gl_FragCoord: x, y in pixels, z in 0 to 1, 1/w.
  std::optional<std::array<double, 4>> coordinates;
  // Of the colour's four components, per pixel: dFdx, dFdy, dFdxFine, dFdyFine, dFdxCoarse,
  // dFdyCoarse. Of a textured draw: of s and t, and zeros.
  std::array<std::optional<std::array<double, 4>>, kDerivatives> derivatives;
  // Of a textured draw: s and t, as interpolated.
  std::optional<std::array<double, 2>> texture_coordinates;
  // Of a textured draw, as textureQueryLod tells them: the level that is accessed, 0 the base
  // level, and lambda' before it is clamped.
  std::optional<std::array<double, 2>> level_of_detail;
};

// One fragment shader invocation.
struct Fragment {
  int x = 0;          // pixel column, 0 to width - 1
  int y = 0;          // pixel row, 0 to height - 1, y up
  int primitive = 0;  // index in drawing order, see primitives_of
  // Bit s set: sample s is covered and in the draw's sample mask, as gl_SampleMaskIn tells it; of a
  // shader that runs for each sample, the samples it runs for. 1 without multisampling, whichever
  // samples are written. Alpha to coverage comes after the shader and clears nothing here.
  std::uint32_t coverage = 1;
  double depth = 0;  // window depth, 0 to 1
  std::array<double, 4>
      color{};            // as the shader writes it, before conversion to the target's format
  bool has_depth = true;  // false: the renderer tells no depth
  bool has_color = true;  // false: the renderer tells no per-fragment colour
  // Index into Rendering::details, where fragments that are told the same may share one; -1: none
  // was told.
  int detail = -1;
};

// Orders by pixel (row, then column), primitive and coverage: the order in which renderings are
// stored.
bool precedes(const Fragment& a, const Fragment& b);

struct Rendering {
  int width = 0;
  int height = 0;
  int samples = 1;
  // Where the renderer says that the samples of a pixel lie; empty where it says nothing.
  SamplePositions sample_positions;
  // RGBA8, row by row from the bottom, 4 * width * height; of a multisampled target, resolved.
  // Empty where coverage alone was asked for.
  std::vector<std::uint8_t> pixels;
  // Of a multisampled target, before it is resolved: one such plane for each sample. A renderer
  // need not tell them.
  std::vector<std::uint8_t> sample_pixels;
  // Fragments per pixel that pass all tests, from a pass of its own; of a multisampled target, per
  // sample: a plane for each. Empty: none.
  std::vector<std::uint32_t> hits;
  // All that the rasterizer makes, whatever tests they fail afterwards; sorted by `precedes`, equal
  // ones in drawing order.
  std::vector<Fragment> fragments;
  std::vector<FragmentDetail> details;  // of the fragments that point here
  // The depth buffer, 0 to 1, row by row from the bottom, a plane for each sample; empty where the
  // target has none.
  std::vector<double> depths;
  // The stencil buffer, in the same way.
  std::vector<std::uint8_t> stencils;
  // What the renderer made of the scene's textures whose levels it generates: whole chains, by the
  // texture's number. A renderer need not tell them.
  std::map<std::size_t, std::vector<TextureLevel>> mip_chains;
  // Of a supersampled scene: what each of its passes made, in their order, all of it. Fragments,
  // hits, depths and mip chains are told there alone.
  std::vector<Rendering> passes;
  // And the weighted mean of what they show, before conversion to 8 bits: red, green, blue, alpha,
  // row by row from the bottom. A pass shows the colour of the last fragment, as the shader writes
  // it, or the clear colour. `pixels` is to_unorm8 of it.
  std::vector<double> accumulated;

  std::size_t pixel_index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  // The same within planes of samples.
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

}  // namespace edgecase
