// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/worked_scenes.h"

#include <array>

namespace edgecase {
namespace {

constexpr auto kScenes = std::to_array<WorkedScene>({
    {RuleId::point_snap, "points/just-below-integer-by-1-256", 3, 2},
    {RuleId::clip_volume, "clipping/near/row-of-centres:z=-16", 2, 4},
    {RuleId::clip_volume, "clipping/eye/w-is-zero:x=0:y=1:z=0", 2, 7},
    {RuleId::point_ownership, "points/horizontal-edge", 2, 4},
    {RuleId::point_ownership, "points/corner", 3, 3},
    {RuleId::line_diamond_exit, "lines/diamonds/start-right-corner", 3, 3},
    {RuleId::line_diamond_exit, "lines/diamonds/end-left-corner-eastward", 2, 3},
    {RuleId::line_diamond_exit, "lines/diagonals/rising-on-edges", 0, 1},
    {RuleId::line_diamond_exit, "lines/slopes/one-half-rising", 2, 2},
    {RuleId::line_algorithm, "lines/ends/one-pixel-short", 12, 1},
    {RuleId::line_algorithm, "lines/short/between-diamonds", 3, 3},
    {RuleId::line_joint, "lines/joints/turn-tail-to-tail", 5, 1},
    {RuleId::triangle_fill_rule, "triangles/ties/flat-top", 3, 3},
    {RuleId::triangle_fill_rule, "triangles/ties/flat-bottom", 3, 3},
    {RuleId::triangle_fill_rule, "triangles/single/degenerate-collinear", 3, 3},
    {RuleId::triangle_shared_edge, "triangles/shared-edges/vertical", 3, 4},
    {RuleId::triangle_shared_edge, "triangles/shared-edges/hole-where-x-is-a-third", 6, 6},
    {RuleId::polygon_facing, "output/culling/both-windings:cull=back:face=ccw", 6, 4},
    {RuleId::sample_positions, "samples/patterns/left-edge:edge=0.375", 1, 1},
    {RuleId::sample_enable, "samples/enable/triangle-on-and-off:multisample=false:edge=0.5", 1, 1},
});

}  // namespace

std::span<const WorkedScene> worked_scenes() {
  return kScenes;
}

}  // namespace edgecase
