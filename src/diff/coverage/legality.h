// SPDX-License-Identifier: MIT
//
// Legality: is a difference inside the specification? Computed from the scene and from what was
// drawn alone, without any policy or profile.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/supported_sizes.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// b of ruling 4: the larger of 4 and what the renderer reports, and no finer than our coordinates.
int latitude_bits(int reported_subpixel_bits);

// The rule of lines of multisampled draws; the others' is coverage_rule_of.
inline constexpr RuleId kMultisampledLine = RuleId::line_multisampled;
// The rule of primitives that reach out of the clip volume.
inline constexpr RuleId kClipVolume = RuleId::clip_volume;
// The rule that says what the primitive covers.
RuleId rule_on_coverage(const ScenePrimitive& primitive, const Target& target);

// Whether one difference of one primitive is allowed, by which rule and ruling.
struct CoverageLegality {
  bool legal = false;  // by the letter
  int ruling = 0;
  RuleId rule;         // the rule that is broken or under which the difference is allowed
  std::string reason;  // one clause, why
};

// Points, triangles and multisampled lines: `difference` judged by itself. `within`: where in its
// pixel the sample lies. `sizes`: that the renderer supports.
CoverageLegality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              Point within, int bits, const SupportedSizes& sizes = {});

// The same of triangles of draws that cull: which way they face may be what differs (ruling 40).
// `whole`: nothing of the triangle was drawn. `otherwise`: what judge_sample says.
CoverageLegality judge_facing(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              bool whole, CoverageLegality otherwise, int bits);

// The ruling on coverage at other places than are reported, and the one on fragments of points and
// lines that are left out beyond the viewport's sides.
inline constexpr int kRulingOnOtherPlaces = 47;
inline constexpr int kRulingOnViewport = 54;

// What judge_sample does not allow, but by one of these: the ruling becomes theirs. Of multisampled
// draws where the points lie by which coverage is found is not told, and they may lie beyond the
// pixel (14.3.1): ruling 47 is broken where a sample elsewhere in the pixel, or less than a pixel
// beyond it, would be covered, or not, as the difference has it.
struct ContestTerms {
  bool is_multisampled = false;
  int bits = 4;
  const SupportedSizes& sizes;
};
void contest(const ScenePrimitive& primitive, const CoverageDifference& difference,
             const ContestTerms& terms, CoverageLegality& legality);

// The ruling on wide lines that are as wide as the next smaller integer.
inline constexpr int kRulingOnSmallerWidth = 56;
// The ruling on a single fragment of a line of which the diamond-exit rule has none.
inline constexpr int kRulingOnEmptyLine = 58;
// Lines that break a ruling: the contested ruling that they break alone, if there is one, since
// they hold all others under more of the catalogued snaps; else 0.
int contested_ruling_on_line(const ScenePrimitive& line, std::span<const PixelPosition> drawn,
                             const Scene& scene);

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
