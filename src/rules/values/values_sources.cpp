// SPDX-License-Identifier: MIT
//
// Sources of the rulings on values of fragments and of pixels.
#include "rules/catalogue.h"

namespace edgecase {

void add_values_sources(std::map<int, RulingSource>& of) {
  of[8] = {.clause = "14.6.1; 14.5.1; 13.6 (Flatshading)",
           .quotation =
               "When the flat keyword is specified, no interpolation is performed, and outputs "
               "are taken from the corresponding input value of the provoking vertex",
           .khronos =
               "dEQP-GLES3.functional.rasterization.flatshading.* : colours within the target's "
               "threshold",
           .es =
               "13.7.1 of ES says otherwise for polygons: \"The equation collapses to f = f_p, "
               "but note that since interpolation is still performed, precision may be lost\" "
               "(floating-point outputs); integers exact; lines (13.6.1): no interpolation. "
               "Provoking vertex: last, table 12.3"};

  of[9] = {.clause = "14.5.1 equations 14.5 to 14.7; 14.6.1 equations 14.9, 14.10; 2.3.4.1",
           .quotation =
               "a, b, and c must correspond precisely to the exact coordinates of the center of "
               "the fragment",
           .khronos =
               "dEQP-GLES3.functional.rasterization.interpolation.* "
               "(tcuRasterizationVerifier.cpp): value anywhere in the central two sub-pixel "
               "steps (2^-b round the centre), division 3 ULP; lines: major axis = "
               "QP_TEST_RESULT_QUALITY_WARNING \"Interpolation was calculated using projected "
               "coordinateds\" (accepted); multisampled lines by two triangles, anywhere in the "
               "pixel, else failure (wide: compatibility warning)",
           .es =
               "13.6.1: \"the formula given in equation 13.3 may be approximated by replacing "
               "(p_r, p_a, p_b) with (x_r, x_a, x_b) for x-major lines\": the major axis is "
               "OPEN in ES without multisampling; 13.6.4: \"may not be used during multisampled "
               "line rasterization\". No noperspective (NV extension). Else same"};

  of[10] = {.clause = "2.3.5.2; 17.3.8 (Dithering)",
            .quotation =
                "one of the two values above is selected, in an implementation-dependent manner "
                "that must not depend on the x_w and y_w coordinates",
            .khronos =
                "dEQP-GLES3.functional.dither.{enabled,disabled} (es3fDitheringTests.cpp): each "
                "channel is one of the two neighbouring codes (a third within 0.0001 of a whole "
                "code); disabled: a unicoloured quad has one colour; most colour tests allow the "
                "target's threshold of one code and more",
            .es = "2.3.5.2, 15.1.7: same"};

  of[11] = {.clause = "2.1 (Execution Model)",
            .quotation =
                "Commands are always processed in the order in which they are received ... one "
                "primitive must be drawn completely before any subsequent one",
            .khronos = "nearly every overdraw test relies on it; none by itself",
            .es = "2.1: same words"};

  of[13] = {.clause = "14.5.2.2 (Wide Lines)",
            .quotation =
                "generate the same attribute values for all fragments in the row or column "
                "described above, as if the adjusted line were used for interpolation",
            .khronos =
                "dEQP-GLES3.functional.rasterization.interpolation.*.lines_wide "
                "(verifySinglesampleWideLineGroupInterpolation = replicated; "
                "verifyLineGroupInterpolationWithNonProjectedWeights = each its own; both "
                "\"strictly correct\"); projected weights on the major axis: quality warning",
            .es = "13.6.2.1: same two methods; plus 13.6.1's leave to use the major axis alone"};

  of[16] = {.clause = "8.14.1 (Derivative Functions)",
            .revision = kLanguageRevision,
            .quotation =
                "an implementation may approximate the true derivatives by using a fast but not "
                "entirely accurate derivative computation",
            .khronos =
                "dEQP-GLES3.functional.shaders.derivate.* (es3fShaderDerivateTests.cpp): linear "
                "functions: within the mantissa less the lost bits (INTERPOLATION_LOST_BITS; "
                "more with a warning); texture and varying functions: interval of the divided "
                "differences over neighbours within 1 pixel, the surface's threshold; "
                "multisampled FBOs the same",
            .es =
                "ESSL 8.14.1: dFdx, dFdy, fwidth only; the same dx <= 1 and < 2; no Fine or "
                "Coarse, and no sentence that ties dFdx to them (\"local differencing\"): so for "
                "dFdx in ES R16's coarse set holds"};

  of[17] = {.clause = "15.2.2 (Shader Inputs); GLSL 4.60, 7.1.5",
            .quotation =
                "Unless otherwise specified by layout qualifiers ... the fragment processing "
                "pixel-center convention is half-integer and the fragment processing origin "
                "convention is lower left",
            .khronos =
                "KHR-GL4x.*.FragCoord conventions (glcFragCoordConventionsTests.cpp): colours "
                "from gl_FragCoord.xy compared by image; "
                "dEQP-GLES3.functional.shaders.builtin_variable.fragcoord_xyz / fragcoord_w "
                "(es3fShaderBuiltinVarTests.cpp): colour threshold of the target + 1",
            .es =
                "14.2.2, same; \"The z_w component of gl_FragCoord undergoes an implied "
                "conversion to floating-point. This conversion must leave the values 0 and 1 "
                "invariant\" (so z may be that of fixed-point depths: off by one code of the "
                "buffer). ESSL 7.2: same sentence on locations"};

  of[63] = {
      .clause = "14.3.1.1 (Sample Shading); GLSL 4.60, 7.1.5",
      .quotation =
          "a separate set of colors and other associated data are evaluated for each sample, "
          "and each set of values is evaluated at the sample location",
      .basis = Basis::contested,
      .contest =
          "GLSL 4.60, 7.1.5, lets gl_FragCoord be \"for any location within the pixel, or one "
          "of the fragment samples\", whatever the share is, and has z be the depth that the "
          "fragment would have",
      .khronos =
          "dEQP-GLES31.functional.shaders.sample_variables.sample_pos.* reads "
          "gl_SamplePosition; no test compares gl_FragCoord with the sample's place",
      .es = "13.4.1: same; ESSL 7.2: same sentence on locations"};

  of[18] = {.clause =
                "2.3.5.2 (Conversion from Floating-Point to Normalized Fixed-Point); 13.8.1 "
                "(Controlling the Viewport); 14.6.5 (Depth Offset)",
            .quotation =
                "one of the two unsigned binary integer values with exactly b bits which are "
                "closest to the floating-point value r",
            .khronos =
                "dEQP-GLES3.functional.fbo.depth.* and depth.* compare images of colours, not "
                "depths; glcFragDepthTests.cpp and es3fFragDepthTests.cpp read depths back "
                "through a shader with a tolerance of about 1 in 2^-8 to 2^-16 of range; none "
                "asks the last bit",
            .es = "2.3.5.2, 12.6.1, 13.7.2: same"};

  of[49] = {.clause = "8.14.1 (Derivative Functions)",
            .revision = kLanguageRevision,
            .quotation =
                "over a given area, the implementation can compute y derivatives in fewer unique "
                "locations than would be allowed for dFdyFine",
            .basis = Basis::contested,
            .contest =
                "the area has no stated size: a 2x2 square is called typical, and only the fine "
                "forms name immediate neighbours",
            .khronos =
                "dEQP-GLES3.functional.shaders.derivate.*: divided differences of neighbours "
                "within 1 pixel for functions that are not linear; none asks for an area's size",
            .es = "ESSL 8.14.1: no Coarse; dFdx by \"local differencing\", of no stated area"};

  of[59] = {.clause = "13.8.1 (Controlling the Viewport); 2.3.5.2; 15.2.2 (Shader Inputs)",
            .quotation =
                "z_w may be represented using either a fixed-point or floating-point "
                "representation",
            .basis = Basis::contested,
            .contest =
                "a fixed-point depth reaches gl_FragCoord.z by a conversion, of which 15.2.2 and "
                "ES 3.2 (14.2.2) ask no more than that 0 and 1 stay: the reported depth may be a "
                "code off what was converted",
            .khronos = "none asks the last bit of a stored depth",
            .es =
                "14.2.2: the implied conversion of gl_FragCoord's depth \"must leave the values 0 "
                "and 1 invariant\""};

  of[46] = {.clause = "14.5.1, equations 14.5 to 14.7; 14.5.2.2",
            .quotation = "Set t = (p_r - p_a) . (p_b - p_a) / |p_b - p_a|^2",
            .basis = Basis::contested,
            .contest =
                "J.4 (October 22, 2019) loosens 14.5.2.2 to \"allow diagonal interpolation of "
                "input attributes, bring the specification in line with Vulkan and shipping "
                "hardware\"",
            .khronos =
                "dEQP-GLES3.functional.rasterization.interpolation.*.lines, lines_wide: values "
                "by the major axis are accepted with a quality warning",
            .es = "13.6.1: the formula may be approximated by the major axis alone"};
}

}  // namespace edgecase
