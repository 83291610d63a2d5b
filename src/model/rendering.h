// SPDX-License-Identifier: MIT
//
// Rendering: what a renderer made of a scene. The same type for the exact side, for OpenGL and for
// any other program; doubles hold the float32 values of a GL without loss.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "model/texture.h"

namespace edgecase {

// Ways to take a derivative, in the order of FragmentDetail::derivatives.
enum class Derivative { x, y, x_fine, y_fine, x_coarse, y_coarse };
constexpr std::size_t kDerivatives = 6;

// What a fragment is asked for beside colour and depth.
struct FragmentDetail {
  std::array<double, 4> coordinates{};  // gl_FragCoord: x, y in pixels, z in 0 to 1, 1/w
  bool has_coordinates = false;
  // Of the colour's four components, per pixel: dFdx, dFdy, dFdxFine, dFdyFine, dFdxCoarse,
  // dFdyCoarse. Of a textured draw: of s and t, and zeros.
  std::array<std::array<double, 4>, kDerivatives> derivatives{};
  std::array<bool, kDerivatives> has_derivative{};
  // Of a textured draw: s and t, as interpolated.
  std::array<double, 2> texture_coordinates{};
  bool has_texture_coordinates = false;
  // Of a textured draw, as textureQueryLod tells them: the level that is accessed, 0 the base
  // level, and lambda' before it is clamped.
  std::array<double, 2> level_of_detail{};
  bool has_level_of_detail = false;
};

// One fragment shader invocation.
struct Fragment {
  int x = 0;                   // pixel column, 0 to width - 1
  int y = 0;                   // pixel row, 0 to height - 1, y up
  int primitive = 0;           // index in drawing order, see primitives_of
  std::uint32_t coverage = 1;  // bit s set: sample s is covered
  double depth = 0;            // window depth, 0 to 1
  std::array<double, 4>
      color{};            // as the shader writes it, before conversion to the target's format
  bool has_depth = true;  // false: the renderer tells no depth
  bool has_color = true;  // false: the renderer tells no per-fragment colour
  int detail = -1;        // index into Rendering::details; -1: none was told
};

// Orders by pixel (row, then column) and primitive: the order in which renderings are stored.
bool precedes(const Fragment& a, const Fragment& b);

struct Rendering {
  int width = 0;
  int height = 0;
  int samples = 1;
  // RGBA8, row by row from the bottom, 4 * width * height; empty where coverage alone was asked
  // for.
  std::vector<std::uint8_t> pixels;
  std::vector<std::uint32_t> hits;      // fragments per pixel from a pass of its own; empty: none
  std::vector<Fragment> fragments;      // sorted by `precedes`, equal ones in drawing order
  std::vector<FragmentDetail> details;  // of the fragments that point here
  // The depth buffer, 0 to 1, row by row from the bottom; empty where the target has none.
  std::vector<double> depths;
  // What the renderer made of the scene's textures whose levels it generates: whole chains, by the
  // texture's number. A renderer need not tell them.
  std::map<std::size_t, std::vector<TextureLevel>> mip_chains;

  std::size_t pixel_index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

// Sorts the fragments by `precedes`, stably.
void sort_fragments(Rendering& rendering);

// The unsigned 8-bit value nearest to a colour component, which is clamped to [0, 1] first; a tie
// goes to the even value; NaN becomes 0. GL 4.6 core, 2.3.5.2.
std::uint8_t to_unorm8(double component);

}  // namespace edgecase
