// SPDX-License-Identifier: MIT
//
// Grid lines: all lines between points of a coarse grid, one after another.
//
// What a search finds with fine coordinates may be there with coarse ones, too, which people read
// at a glance. Random scenes can only fail to show that; these are all there are. Lines that differ
// by whole pixels count as one, the one that lies nearest to the origin.
#pragma once

#include <array>
#include <cstdint>

#include "model/scene.h"

namespace edgecase {

// The lines of a square target whose ends lie strictly inside it, on multiples of a fraction of a
// pixel. Lines of no length are among them.
class GridLines {
 public:
  // `size` pixels a side, at least 2; `steps` a pixel, a power of two of at most 2^16.
  constexpr GridLines(int size, int steps) : size_(size), steps_(steps) {}

  std::uint64_t count() const { return pairs() * pairs(); }
  // Start and end of a line, `number` below count(); each number has another.
  std::array<Point, 2> line(std::uint64_t number) const;
  // One after another these are all numbers, in an order that strays over all of them from the
  // start; `seed` tells where it begins. Beyond count() they come again.
  std::uint64_t strewn(std::uint64_t seed, std::uint64_t index) const;

 private:
  // Of the coordinates of both ends along one axis.
  std::uint64_t pairs() const;
  std::array<Fixed, 2> pair(std::uint64_t number) const;

  int size_;
  int steps_;
};

// What a person reads without a pencil: multiples of 1/16 within 16x16 pixels.
inline constexpr GridLines kReadableLines{16, 16};
inline constexpr std::uint64_t kGridLinesOfScene = 32;

// Lines of kReadableLines, as many in each scene. Scenes 0 to grid_line_scenes() - 1 of one seed
// hold every line once. The second draws them 2 pixels wide.
Scene grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index);
Scene wide_grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index);
std::uint64_t grid_line_scenes();

// The same with 4 samples a pixel, on framebuffer objects, one line in each scene: renderers answer
// sample by sample, and take as long for it as for a scene of 32 lines without.
Scene multisampled_grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index);
std::uint64_t multisampled_grid_line_scenes();

// Grid joints: two lines that meet, between points of a coarse grid.
//
// There are too many of them for a list of all (grid lines are lines alone), but what joints
// show with fine coordinates is found here with ones that people read.
inline constexpr int kGridJointsOfScene = 16;

// So many pairs of lines, in one draw: the first of a pair ends where the second starts. All points
// are multiples of 1/16 strictly inside a target of 16x16 pixels; half of the joints lie at
// multiples of 1/2, where ends are ties mostly. In one of four scenes lines are half a pixel wide,
// which are drawn as wide as a pixel.
Scene grid_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

}  // namespace edgecase
