// SPDX-License-Identifier: MIT
//
// Legality: is a difference inside the specification? Computed from the scene and from what was
// drawn alone, without any policy or profile.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// b of ruling 4: the larger of 4 and what the renderer reports, and no finer than our coordinates.
int latitude_bits(int reported_subpixel_bits);

// The rule of lines of multisampled draws; the others' is coverage_rule_of.
inline constexpr const char* kMultisampledLine = "line.multisampled";
// The rule of primitives that reach out of the clip volume.
inline constexpr const char* kClipVolume = "clip.volume";
// The rule that says what the primitive covers.
const char* rule_on_coverage(const ScenePrimitive& primitive, const Target& target);

// Whether one difference of one primitive is allowed, by which rule and ruling.
struct CoverageLegality {
  bool legal = false;  // by the letter
  int ruling = 0;
  std::string rule;    // the rule that is broken or under which the difference is allowed
  std::string reason;  // one clause, why
};

// Points, triangles and multisampled lines: `difference` judged by itself. `within`: where in its
// pixel the sample lies.
CoverageLegality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              Point within, int bits);

// The same of triangles of draws that cull: which way they face may be what differs (ruling 40).
// `whole`: nothing of the triangle was drawn. `otherwise`: what judge_sample says.
CoverageLegality judge_facing(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              bool whole, CoverageLegality otherwise, int bits);

// Lines: names of the catalogued snaps under which the segment's drawn pixels break a ruling.
std::vector<std::string> illegal_line_snaps(const ScenePrimitive& line,
                                            std::span<const PixelPosition> drawn,
                                            const Scene& scene);

// The clause of rulings 1 and 2 that the segment as given breaks, or empty.
std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Scene& scene);

// The ruling that speaks of the line as given: 12 for a wide one, 2 where the diamond-exit rule
// draws nothing of it, else 1.
int ruling_on_line(const ScenePrimitive& line, const Scene& scene);

// Is a disagreement judged by the rulings on lines, which speak of whole segments?
bool is_about_a_line(const Disagreement& disagreement);

}  // namespace edgecase
