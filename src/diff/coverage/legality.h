// SPDX-License-Identifier: MIT
//
// Legality: is a difference inside the specification? Computed only from the scene and the drawing,
// without any policy or profile.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/vertex_latitude.h"
#include "model/scene.h"
#include "model/verdict.h"
#include "rules/renderer_claims.h"

namespace edgecase {

// b of ruling 4: the larger of 4 and the reported bits, but no finer than our coordinates.
int latitude_bits(int reported_subpixel_bits);

// The rule of lines of multisampled draws; coverage_rule_of has the rules of others.
inline constexpr RuleId kMultisampledLine = RuleId::line_multisampled;
// The rule of primitives that reach out of the clip volume.
inline constexpr RuleId kClipVolume = RuleId::clip_volume;
// The rule that decides what the primitive covers.
RuleId rule_on_coverage(const ScenePrimitive& primitive, const Target& target);

// Whether one difference of one primitive is allowed, and by which rule and ruling.
struct CoverageLegality {
  bool legal = false;  // by the letter
  int ruling = 0;
  RuleId rule;         // the rule that is broken or under which the difference is allowed
  std::string reason;  // the reason, one clause
};
// By the rule and its own ruling.
CoverageLegality legality_under(RuleId rule, bool legal, std::string reason = "");

// For lines that break a ruling: the only ruling they break, if it is contested, which means that
// they satisfy all others under more of the catalogued snaps; else 0.
int contested_ruling_on_line(const ScenePrimitive& line, std::span<const PixelPosition> drawn,
                             const Scene& scene);

// Lines: the catalogued snaps under which the segment's drawn pixels break a ruling.
std::vector<std::string> illegal_line_snaps(const ScenePrimitive& line,
                                            std::span<const PixelPosition> drawn,
                                            const Scene& scene);

// True if a line of OpenGL ES is drawn as OpenGL has it, which cuts it at the viewport's sides
// (ruling 68), though perhaps without what lies beyond them (ruling 54).
bool is_cut_at_sides(const ScenePrimitive& line, std::span<const PixelPosition> drawn,
                     const Scene& scene);

// The clause of rulings 1 and 2 that the unsnapped segment breaks, or empty.
std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Scene& scene);

// The ruling on the line as given: 12 for a wide line, 2 if the diamond-exit rule draws nothing of
// it, else 1.
int ruling_on_line(const ScenePrimitive& line, const Scene& scene);

// True if the rulings on lines, which are about whole segments, decide the disagreement.
bool is_about_a_line(const DisagreementClass& disagreement);

}  // namespace edgecase
