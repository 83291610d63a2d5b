// SPDX-License-Identifier: MIT
//
// Scenes that ask what a renderer makes of fragments: their depths, stencil values and colours.
//
// A cell is a pixel with triangles of its own round its centre, strictly inside it, their vertices
// multiples of 1/4 pixel: neither snapping nor ties have a say, and each makes one fragment. Every
// triangle has one colour and, but for those of offset scenes with a slope, one depth. Each scene
// is a function of what it is made with alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/pixel.h"
#include "model/scene.h"

namespace edgecase {

constexpr int kCellColumns = 16;  // of a scene, and rows
constexpr std::size_t kCells = std::size_t{kCellColumns} * kCellColumns;

// Formats of depth buffers, none not among them.
inline constexpr std::array kDepthFormats{DepthFormat::depth16, DepthFormat::depth24,
                                          DepthFormat::depth32f};

// ---------------------------------------------------------------------------------------- colours

// Plain colours: the float32 numbers beside every border between two codes, multiples of 1/256, and
// numbers beyond 0 to 1.
std::vector<Scene> plain_color_scenes(Surface surface);

// Every set of masked components, over codes of every kind.
std::vector<Scene> color_mask_scenes(std::uint64_t seed, Surface surface);

// Codes that are blended with random colours, half of these codes, too: every equation with every
// pair of factors, and for the over operator every alpha with every fourth code. Alpha is blended
// by a term of its own. Scenes of one factor of the destination follow each other.
std::vector<Scene> blend_scenes(std::uint64_t seed, Surface surface);

// ----------------------------------------------------------------------------------------- depths

// Depths swept over all codes, close to borders between two of them and to whole ones.
std::vector<Scene> depth_code_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function of the depth test between depths that are one and the same number, or apart by
// more than any rounding makes up. What they are lies below the middle between two codes, where
// converting to the nearest and truncating have the same.
std::vector<Scene> depth_test_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function and operation of the stencil test on triangles of either facing, with masks, and
// stored values from 0 to 255. With a depth buffer the depth test passes and fails, too.
std::vector<Scene> stencil_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ----------------------------------------------------------------------------------------- offset

// Units alone, many enough to tell one step of a fixed-point buffer from 2^-n; of floating-point
// ones over depths of many exponents.
std::vector<Scene> offset_unit_scenes(Surface surface, DepthFormat format);

// Factors alone, on depths that rise by different amounts in x and in y.
std::vector<Scene> offset_slope_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

}  // namespace edgecase
