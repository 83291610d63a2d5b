// SPDX-License-Identifier: MIT
//
// Sources of the rulings on what primitives cover.
#include "rules/catalogue.h"

namespace edgecase {

void add_coverage_sources(std::map<int, RulingSource>& of) {
  of[1] = {.clause = "14.5.1 (Basic Line Segment Rasterization)",
           .quotation =
               "may not deviate by more than one unit in either x or y window coordinates from "
               "a corresponding fragment produced by the diamond-exit rule",
           .khronos =
               "dEQP-GLES3.functional.rasterization.primitives.lines, line_strip, line_loop "
               "(verifySinglesampleLineGroupRasterization): each reference fragment has a drawn "
               "one within one pixel (image border free), total count within lines x width unless "
               "lines overlap; two fragments in a column of an x-major line fail, two in a row of "
               "a y-major one pass (the loop over rows never assigns `lineID`); stray fragments "
               "and clause 4 are not looked at (\"todo\")",
           .es = "13.6.1: same"};

  of[2] = {.clause = "14.5.1, rules 1 and 2",
           .quotation =
               "The total number of fragments produced by the algorithm may differ from that "
               "produced by the diamond-exit rule by no more than one",
           .khronos = "none asks this (all test lines are long)",
           .es = "13.6.1, same"};

  of[3] = {.clause = "14.5.1, rules 1 to 3",
           .quotation =
               "The total number of fragments produced by the algorithm may differ from that "
               "produced by the diamond-exit rule by no more than one",
           .khronos =
               "lines and line_strip accept it: a missing fragment passes if a drawn one lies "
               "within one pixel, and the count is off by one a line",
           .es = "13.6.1, same"};

  of[4] = {
      .clause = "14.6.1 (Basic Polygon Rasterization); appendix B, corollary 6; table 23.54",
      .quotation = "Fragment centers that lie inside of this polygon are produced by rasterization",
      .khronos =
          "dEQP-GLES3.functional.rasterization.primitives.triangles etc. "
          "(verifyTriangleGroupRasterization, calculateTriangleCoverage): pixels whose centre "
          "lies within five steps of GL_SUBPIXEL_BITS of an edge are free, for \"3 subpixel "
          "fuzz\"; all others strict. That is room for what a verifier cannot know, and no "
          "sentence of the text: two steps off stay a violation. Nor do they ask what covers all "
          "samples of one triangle at once, or draw one without area",
      .es = "13.7.1, table 21.40; appendix B, corollary 6: same"};

  of[5] = {
      .clause = "14.6.1; appendix B, corollary 8",
      .quotation =
          "each fragment intersecting the interior of the shared edge is produced exactly "
          "once",
      .khronos =
          "dEQP-GLES3.functional.rasterization.fill_rules.{basic_quad, basic_quad_reverse, "
          "clipped_full, clipped_partly, projected} (es3fRasterizationTests.cpp "
          "FillRuleCase): no overdraw (sum of colours above one triangle's by more than "
          "the threshold), and in clipped_full no hole; single- and multisampled. "
          "dEQP-GLES3.functional.multisample.*.common_edge_{small_quads,big_quad,viewport_quad}: "
          "no doubled pixel at the inner edge, also where the quad fills the viewport",
      .es = "13.7.1 same; appendix B, corollary 8 too"};

  of[6] = {
      .clause = "14.4.1 (Basic Point Rasterization)",
      .quotation =
          "If an unsupported width is requested, the nearest supported width is used "
          "instead",
      .khronos =
          "dEQP-GLES3.functional.rasterization.primitives.points "
          "(es3fRasterizationTests.cpp, tcuRasterizationVerifier.cpp "
          "verifyMultisamplePointGroupRasterization): as two triangles per point, so that "
          "pixels within five sub-pixel steps of the boundary are free (ruling 4), no other may "
          "differ; a square that is always 1/8 pixel off is no matter of precision. Sizes are "
          "whole or the largest supported; none asks fractional sizes. "
          "clipping.point: 1 pixel",
      .es =
          "13.5, 13.5.1: same square; sizes are clamped to ALIASED_POINT_SIZE_RANGE and no "
          "granularity or \"nearest supported\" is mentioned: sizes within the range are "
          "exact. Size comes from gl_PointSize only. No fade"};

  of[7] = {
      .clause = "14.4.1, 14.5.1, 14.6.1; 15.2 for what is not meant",
      .quotation = "Fragment centers that lie inside of this polygon are produced by rasterization",
      .khronos =
          "fill_rules (overdraw of the pieces of clipped quads by blending), clipping "
          "polygon fill tests; occlusion-query tests count samples of quads",
      .es = "14.2: same leave (\"execute additional fragment shader invocations\")"};

  of[67] = {
      .clause = "14.2 (Invariance); A.3 (Invariance Rules)",
      .quotation =
          "each fragment f' produced from p' is identical to a corresponding fragment f from p "
          "except that the center of f' is offset",
      .khronos =
          "dEQP-GLES3.functional.shaders.invariance.* draws the same geometry with two shaders and "
          "wants no pixel to differ; none moves a primitive or masks colours",
      .es = "13.3 and A.3: same words"};
  of[70] = {
      .clause = "A.3 (Invariance Rules)",
      .quotation =
          "Fragment generation is invariant with respect to the state values marked with • in Rule "
          "2",
      .basis = Basis::contested,
      .contest =
          "the letter lists the parameters of blending as strongly suggested; corollary 1 says "
          "that fragments are invariant to all that rule 2 marks",
      .khronos = "no test draws a scene twice with other parameters of blending",
      .es = "A.3: same words"};

  of[12] = {
      .clause = "14.5.2.2 (Wide Lines)",
      .quotation =
          "The actual width of non-antialiased lines is determined by rounding the "
          "supplied width to the nearest integer, then clamping it",
      .khronos =
          "dEQP-GLES3.functional.rasterization.primitives.lines_wide etc. "
          "(tcuRasterizationVerifier.cpp verifySinglesampleLineGroupRasterization): floor(w + "
          "0.5), AND one less if the width has a fraction (\"lineWidthHasFrac\"), of columns of "
          "x-major lines alone: the loop over rows never assigns `lineID`; reference fragment "
          "within 1 pixel of a drawn one; count off by at most lines x width; never checks extra "
          "stray fragments or clause 4. The reference line rasterizer cuts columns at the viewport",
      .es = "13.6.2.1: same"};

  of[14] = {
      .clause = "14.5.1, rule 4",
      .quotation =
          "rasterizing both segments may not produce duplicate fragments, nor may any "
          "fragments be omitted so as to interrupt continuity of the connected segments",
      .khronos = "none asks this (\"todo ... Requirement 4\" in tcuRasterizationVerifier.cpp)",
      .es = "13.6.1, same"};

  of[15] = {.clause = "2.3.4.1 (Floating-Point Computation); 13.8 and 13.8.1",
            .quotation =
                "individual results of floating-point operations are accurate to about 1 part in "
                "10^5",
            .khronos =
                "none asks this; verifiers give vertices the sub-pixel step only (double "
                "precision inside), so the tests are stricter here than the clause",
            .es = "2.3.4.1, 12.6: same"};

  of[40] = {.clause = "14.6.1 (Basic Polygon Rasterization)",
            .quotation =
                "based on the sign of the (clipped or unclipped) polygon's area computed in "
                "window coordinates",
            .khronos =
                "dEQP-GLES3.functional.rasterization.culling.* (unclipped triangles); none with "
                "clipped ones",
            .es = "13.7.1: same words"};

  of[42] = {.clause = "13.7 (Primitive Clipping); 14.6.1 (Basic Polygon Rasterization)",
            .quotation =
                "clipping passes it unchanged if it lies within the near and far clip planes ... "
                "implementations may discard points that lie outside the view volume",
            .khronos =
                "dEQP-GLES3.functional.clipping.point.* (es3fClippingTests.cpp): against the "
                "reference renderer (rrRenderer.cpp clips points by z only, and rasterizes into "
                "the intersection of viewport and buffer), within 1 pixel, no faulty pixel "
                "allowed: pop-free points are demanded, and so is the cut at the viewport. "
                "clipping.line.*: 1 pixel, 6 faulty pixels allowed; wide lines under "
                "multisampling only a compatibility warning. clipping.polygon.*: coverage within "
                "1 pixel; poly_attrib_clip colours within 1 pixel and 6 faulty pixels (0.3 fuzzy "
                "under MSAA). gl4cClipControlTests: near and far of both depth modes",
            .es =
                "differs, 12.5: a point is passed if it lies between near and far, \"otherwise, "
                "it is discarded\"; there is no leave to discard at the sides. So in ES a point "
                "outside of the sides whose square reaches in MUST be drawn. Lines in ES are "
                "clipped at near and far only (12.5, \"the near and/or far clip planes\"): "
                "beyond the sides of the viewport their fragments are to be drawn. Polygons: "
                "same; hull: 13.7.1, same. WebGL 1.0, section on wide point primitives (PR 2940, "
                "WebGL 2 inherits it), makes the sides optional again: on a browser treat points "
                "as in GL"};

  of[68] = {
      .clause = "12.5 (Primitive Clipping)",
      .revision = "OpenGL ES 3.2, May 5, 2022",
      .quotation =
          "clipping does nothing to it if it lies entirely within the near and far clip planes",
      .khronos =
          "dEQP-GLES3.functional.clipping.point.wide_point_clip, "
          "wide_point_clip_viewport_center, _corner and line.wide_line_clip, "
          "wide_line_clip_viewport_center, _corner (es3fClippingTests.cpp): points and lines "
          "a pixel beyond the sides, \"wide points have fragments in the viewport\"; the "
          "reference renderer clips both by z only (rrRenderer.cpp, clipPrimitives) and "
          "rasterizes into the intersection of viewport and buffer. Points: within 1 pixel, "
          "no faulty pixel; lines: within 1 pixel, 6 faulty pixels",
      .es =
          "12.5: this is the text; of a point: \"clipping passes it unchanged if it lies "
          "within the near and far clip planes; otherwise, it is discarded\""};

  of[43] = {.clause = "14 (Rasterization); 13.8.1 (Controlling the Viewport)",
            .quotation =
                "fragment is located by its lower left corner, which lies on integer grid "
                "coordinates",
            .khronos = "every test that compares images with a reference relies on it",
            .es = "13 and 12.6.1: same"};

  of[44] = {
      .clause = "14.6.1 (Basic Polygon Rasterization), equation 14.10",
      .quotation = "depth values for polygons must be interpolated by z = a z_a + b z_b + c z_c",
      .basis = Basis::contested,
      .contest =
          "14.6.1 asks for a convex combination of what the polygon's vertices carry where "
          "a polygon has more than three edges, and names depth among the data of a vertex",
      .khronos =
          "dEQP-GLES3.functional.clipping.point.* (es3fClippingTests.cpp): against the "
          "reference renderer (rrRenderer.cpp clips points by z only, and rasterizes into "
          "the intersection of viewport and buffer), within 1 pixel, no faulty pixel "
          "allowed: pop-free points are demanded, and so is the cut at the viewport. "
          "clipping.line.*: 1 pixel, 6 faulty pixels allowed; wide lines under "
          "multisampling only a compatibility warning. clipping.polygon.*: coverage within "
          "1 pixel; poly_attrib_clip colours within 1 pixel and 6 faulty pixels (0.3 fuzzy "
          "under MSAA). gl4cClipControlTests: near and far of both depth modes",
      .es = "13.7.1: same"};

  of[66] = {
      .clause = "14.6.1 (Basic Polygon Rasterization)",
      .quotation =
          "we require only that a convex combination of the values of the datum at the polygon's "
          "vertices can be used",
      .basis = Basis::contested,
      .contest =
          "14.6.1 asks for no more of a polygon with more than three edges; the Khronos tests "
          "want the colours of the plane, within a pixel",
      .khronos =
          "dEQP-GLES3.functional.clipping.polygon.* (es3fClippingTests.cpp): poly_attrib_clip "
          "takes colours from the plane, within 1 pixel, with 6 faulty pixels allowed",
      .es = "13.7.1: same words"};

  of[54] = {
      .clause = "14.4.1 (Basic Point Rasterization); 14.5.2.2 (Wide Lines)",
      .quotation =
          "Point rasterization produces a fragment for each framebuffer pixel whose center "
          "lies inside a square centered at the point's (x_w, y_w)",
      .basis = Basis::contested,
      .contest =
          "OpenGL-API issue 57 asks whether fragments beyond the viewport are to be cut, "
          "and is open; implementations and the Khronos reference rasterizer cut them",
      .khronos =
          "dEQP-GLES3.functional.clipping.point.* and line.* compare with a reference that "
          "cuts at the intersection of viewport and buffer, within 1 pixel",
      .es = "13.5.1 and 13.6.2.1: the same; WebGL 1.0 makes points beyond the sides optional"};

  of[56] = {
      .clause = "14.5.2.2 (Wide Lines)",
      .quotation =
          "The actual width of non-antialiased lines is determined by rounding the "
          "supplied width to the nearest integer, then clamping it",
      .basis = Basis::contested,
      .contest =
          "the Khronos tests take the next smaller width, too, where the width asked for "
          "has a fraction",
      .khronos =
          "dEQP-GLES3.functional.rasterization.primitives.lines_wide etc. "
          "(tcuRasterizationVerifier.cpp verifySinglesampleLineGroupRasterization): floor(w + "
          "0.5), AND one less if the width has a fraction (\"lineWidthHasFrac\"), of columns of "
          "x-major lines alone: the loop over rows never assigns `lineID`; reference fragment "
          "within 1 pixel of a drawn one; count off by at most lines x width; never checks extra "
          "stray fragments or clause 4. The reference line rasterizer cuts columns at the viewport",
      .es = "13.6.2.1: same"};

  of[58] = {.clause = "14.5.1, rules 1 and 2",
            .quotation =
                "The total number of fragments produced by the algorithm may differ from that "
                "produced by the diamond-exit rule by no more than one",
            .basis = Basis::contested,
            .contest =
                "rule 1 asks for a corresponding fragment of the diamond-exit rule, of which "
                "there is none here; rule 2 lets one more be produced; neither speaks of the "
                "closed diamond",
            .khronos = "none asks this (all test lines are long)",
            .es = "13.6.1, same"};
}

}  // namespace edgecase
