// SPDX-License-Identifier: MIT
#include "rules/values/attributes.h"

namespace edgecase {

std::size_t provoking_index(const ScenePrimitive& primitive, ProvokingChoice choice) {
  const bool first = choice == ProvokingChoice::first ||
                     (choice == ProvokingChoice::as_set &&
                      primitive.state->provoking_vertex == ProvokingVertex::first);
  return static_cast<std::size_t>(first ? primitive.provoking_first : primitive.provoking_last);
}

Rule flat_attribute_rule() {
  return {RuleId::attribute_flat,
          "A flat attribute has the value of the provoking vertex, unchanged",
          "13 (flat shading)",
          "none",
          "",
          {},
          {{8,
            "Flat attributes are copied, not computed: any other value than that of the provoking "
            "vertex, to the bit, is a violation. OpenGL ES interpolates those of polygons even so, "
            "and precision may be lost (ES 3.2, 13.7.1): of a renderer that reports OpenGL ES, "
            "floats of polygons may be off by 1 part in 10^5 for each operation of the formula, 10 "
            "parts in all."}}};
}

Rule provoking_vertex_rule() {
  return {RuleId::attribute_provoking_vertex,
          "The provoking vertex is the one that the convention in force names",
          "13 (flat shading)",
          "none where the convention can be set, as in OpenGL",
          "as-set",
          alternatives_of<ProvokingChoice>(),
          {}};
}

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
      {kRulingOnInterpolation,
       "Smooth attributes and depth: a value is permitted if the interpolation formula can yield "
       "it when every operation may err by 1 part in 10^5 and every vertex may have moved by "
       "less than 2^-b (b as in ruling 4). A value equal to the correctly rounded exact value "
       "agrees. Where the exact value is a number, NaN and infinity are violations. A point's "
       "attributes are its vertex's; they may err by a division and a multiplication by a w that "
       "is not 1, unless they are flat. Where ruling 15 lets positions err, depths and 1/w of "
       "vertices err by the division by w, the scaling and the addition that make them; where "
       "the depth range is not 0 to 1, depths err by the latter two."},
      {13,
       "Attributes across a wide line: the preferred values are those of the adjusted line at "
       "the column's lowest fragment, for all fragments of the column. These are the line's "
       "values in the middle of the column, and exact takes them; each fragment may have those "
       "of its own centre instead (14.5.2.2). Everything between both is permitted, in whichever "
       "row of its column a fragment may be: at most (w - 1)/2 away along the minor axis. "
       "gl_FragCoord and depth are interpolated as usual, and have the same latitude; "
       "derivatives are differences of any values that fragments may have."},
      {kRulingOnLineValues,
       "Contested: a value along a line follows its coordinate on the major axis alone, and not "
       "its projection onto the line. It may be either axis if the line is as long in x as in y, "
       "or if moves of its vertices by less than a sub-pixel step can make it so. Or a wide line's "
       "fragment has a value that ruling 13 permits only for another fragment of its column (row, "
       "if y-major). Equation 14.5 takes the projection. But J.4 (October 22, 2019) says that "
       "14.5.2.2 was changed to \"allow diagonal interpolation of input attributes, bring the "
       "specification in line with Vulkan and shipping hardware\". The Khronos tests "
       "(dEQP-GLES3.functional.rasterization.interpolation.*.lines, lines_wide) accept the major "
       "axis with a warning about quality. OpenGL ES lets values of lines without multisampling "
       "follow the major axis (ES 3.2, 13.6.1): of a renderer that reports it they are "
       "permitted."}};
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
            "fragment's depth, gl_FragCoord.w is 1/w interpolated linearly in the window."},
           {kRulingOnCoordinatePlaces,
            "Contested: with GL_SAMPLE_SHADING and a share of 1, gl_FragCoord is not that of the "
            "sample for which the shader runs, but x and y are those of another place in the "
            "pixel, w is that of any such place, or z is that of the place that x and y name. "
            "14.3.1.1 evaluates all values at the sample's location. But GLSL 4.60, 7.1.5, lets "
            "gl_FragCoord be for any location within the pixel, whatever the share, and so does "
            "the language of OpenGL ES (7.2). The Khronos tests "
            "(dEQP-GLES31.functional.shaders.sample_variables.sample_pos.*) read "
            "gl_SamplePosition, and none compares gl_FragCoord with it. Where x and y are the "
            "sample's, z is the depth of the sample, and any other is a violation."}}};
}

}  // namespace edgecase
