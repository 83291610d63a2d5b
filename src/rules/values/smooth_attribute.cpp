// SPDX-License-Identifier: MIT
#include "rules/values/smooth_attribute.h"

namespace edgecase {

bool divides_by_w(Interpolation interpolation, PerspectiveChoice choice) {
  switch (choice) {
    case PerspectiveChoice::as_set:
    case PerspectiveChoice::w_of_centre:
      return interpolation == Interpolation::smooth;
    case PerspectiveChoice::always:
      return true;
    case PerspectiveChoice::never:
      return false;
  }
  return false;
}

Rule smooth_attribute_rule() {
  Rule rule;
  rule.id = RuleId::attribute_smooth;
  rule.title = "A smooth attribute is interpolated linearly between the vertices";
  rule.spec = "14.5.1 and 14.6.1, with the floating-point clause of 2.3";
  rule.latitude =
      "about 1 part in 10^5 per operation; vertices may have been moved to the sub-pixel grid";
  rule.standard = "projection";
  rule.alternatives = alternatives_of<LineParameter>();
  rule.rulings = {
      {9,
       "Smooth attributes and depth: permitted is what the interpolation formula yields when every "
       "operation may err by 1 part in 10^5 and every vertex may have moved by less than 2^-b (b "
       "as in ruling 4). Equal to the correctly rounded exact value is agreement. Where the exact "
       "value is a number, NaN and infinity are violations. A point's attributes are its vertex's; "
       "they may err by a division and a multiplication by a w that is not 1, unless they are "
       "flat. Depths and 1/w of vertices err by the division by w, the scaling and the addition "
       "that make them, where ruling 15 lets places err, and depths by the latter two where the "
       "depth range is not 0 to 1."},
      {13,
       "Attributes across a wide line: preferred are those of the adjusted line at the column's "
       "lowest fragment, for all fragments of the column, which is what the line has in the middle "
       "of the column, and exact takes these; each fragment may have those of its own centre "
       "instead (14.5.2.2). Permitted is what lies between both, in whichever row of its column a "
       "fragment may be: at most (w - 1)/2 away along the minor axis. gl_FragCoord and depth are "
       "interpolated as usual, and given the same leave; derivatives are differences of any values "
       "that fragments may have."},
      {46,
       "Values along a line go by the sample's projection onto it (equation 14.5), and not by its "
       "coordinate on the major axis alone (on either axis where the line is as long in x as in y, "
       "or vertices that move as ruling 9 has it can make it so); those of a wide line are none "
       "that only another fragment of the column may have under ruling 13."}};
  return rule;
}

Rule perspective_rule() {
  Rule rule;
  rule.id = RuleId::attribute_perspective;
  rule.title = "Smooth attributes are interpolated with perspective, noperspective ones without";
  rule.spec = "14.5.1 and 14.6.1, equations for attributes and for noperspective";
  rule.latitude = "none; where all clip w of a primitive are equal there is no difference";
  rule.standard = "as-set";
  rule.alternatives = alternatives_of<PerspectiveChoice>();
  return rule;
}

Rule attribute_positions_rule() {
  Rule rule;
  rule.id = RuleId::attribute_positions;
  rule.title = "Weights of the vertices are computed from their positions in the window";
  rule.spec = "14.6.1, with the latitude of sub-pixel positions";
  rule.latitude = "vertices may have been moved to the sub-pixel grid (ruling 9)";
  rule.standard = "unsnapped";
  rule.alternatives = alternatives_of<AttributePositions>();
  return rule;
}

Rule depth_rule() {
  return {RuleId::fragment_depth,
          "A fragment's depth is interpolated linearly in window space",
          "14.5.1 and 14.6.1, with the floating-point clause of 2.3",
          "as for smooth attributes (ruling 9)",
          "",
          {},
          {}};
}

Rule fragment_coordinates_rule() {
  return {RuleId::fragment_coordinates,
          "gl_FragCoord is the pixel's centre, the fragment's depth and the interpolated 1/w",
          "15.2.2 (shader inputs)",
          "x and y: none; z and w as smooth attributes (ruling 9)",
          "",
          {},
          {{17,
            "gl_FragCoord.xy of a target without multisampling is the pixel's centre, a number of "
            "halves that float32 holds: any other value is a violation. gl_FragCoord.z is the "
            "fragment's depth, gl_FragCoord.w is 1/w interpolated linearly in the window."}}};
}

}  // namespace edgecase
