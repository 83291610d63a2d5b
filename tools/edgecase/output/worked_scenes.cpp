// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/worked_scenes.h"

#include <array>

namespace edgecase {
namespace {

constexpr auto kScenes = std::to_array<WorkedScene>({
    {"point.snap", "points/just-below-integer-by-1-256", 3, 2},
    {"clip.volume", "clipping/near/row-of-centres:z=-16", 2, 4},
    {"clip.volume", "clipping/eye/w-is-zero:x=0:y=1:z=0", 2, 7},
    {"point.ownership", "points/horizontal-edge", 2, 4},
    {"point.ownership", "points/corner", 3, 3},
    {"line.diamond-exit", "lines/diamonds/start-right-corner", 3, 3},
    {"line.diamond-exit", "lines/diamonds/end-left-corner-eastward", 2, 3},
    {"line.diamond-exit", "lines/diagonals/rising-on-edges", 0, 1},
    {"line.diamond-exit", "lines/slopes/one-half-rising", 2, 2},
    {"line.algorithm", "lines/ends/one-pixel-short", 12, 1},
    {"line.algorithm", "lines/short/between-diamonds", 3, 3},
    {"line.joint", "lines/joints/turn-tail-to-tail", 5, 1},
    {"triangle.fill-rule", "triangles/ties/flat-top", 3, 3},
    {"triangle.fill-rule", "triangles/ties/flat-bottom", 3, 3},
    {"triangle.fill-rule", "triangles/single/degenerate-collinear", 3, 3},
    {"triangle.shared-edge", "triangles/shared-edges/vertical", 3, 4},
    {"triangle.shared-edge", "triangles/shared-edges/hole-where-x-is-a-third", 6, 6},
    {"polygon.facing", "output/culling/both-windings:cull=back:face=ccw", 6, 4},
    {"sample.positions", "samples/patterns/left-edge:edge=0.375", 1, 1},
    {"sample.enable", "samples/enable/triangle-on-and-off:multisample=false:edge=0.5", 1, 1},
});

}  // namespace

std::span<const WorkedScene> worked_scenes() {
  return kScenes;
}

}  // namespace edgecase
