// SPDX-License-Identifier: MIT
//
// What rulings rest on, by their numbers.
//
// Each was held against every place of the text that speaks of its subject, and against what the
// Khronos conformance tests (VK-GL-CTS, July 17, 2026) ask there. The texts of the rulings stand
// beside the conditions that judge by them, in the files of their rules; what they rest on stands
// here, so that it can be read and reviewed at one go. Quotations are of at most 25 words, "..."
// marks what is left out.
#include "rules/ruling_sources.h"

#include <map>

namespace edgecase {
namespace {

constexpr const char* kLanguage = "GLSL 4.60.8, August 14, 2023";

std::map<int, RulingSource> sources() {
  std::map<int, RulingSource> of;

  of[1] = {.clause = "14.5.1 (Basic Line Segment Rasterization)",
           .quotation =
               "may not deviate by more than one unit in either x or y window coordinates from "
               "a corresponding fragment produced by the diamond-exit rule",
           .khronos =
               "dEQP-GLES3.functional.rasterization.primitives.lines, line_strip, line_loop "
               "(verifySinglesampleLineGroupRasterization): each reference fragment has a drawn "
               "one within one pixel (image border free), total count within lines x width "
               "unless lines overlap; width of columns; stray fragments and clause 4 are not "
               "looked at (\"todo\")",
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
      .clause = "14.6.1 (Basic Polygon Rasterization); table 23.54",
      .quotation = "Fragment centers that lie inside of this polygon are produced by rasterization",
      .khronos =
          "dEQP-GLES3.functional.rasterization.primitives.triangles etc. "
          "(verifyTriangleGroupRasterization, calculateTriangleCoverage): pixels whose "
          "centre, within the sub-pixel precision that GL_SUBPIXEL_BITS reports, may lie "
          "either way are free; all others strict, no tolerance",
      .es = "13.7.1, table 21.40: same"};

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

  of[6] = {.clause = "14.4.1 (Basic Point Rasterization)",
           .quotation =
               "If an unsupported width is requested, the nearest supported width is used "
               "instead",
           .khronos =
               "dEQP-GLES3.functional.rasterization.primitives.points "
               "(es3fRasterizationTests.cpp, tcuRasterizationVerifier.cpp "
               "verifyMultisamplePointGroupRasterization): as two triangles per point, strict: "
               "pixels within one sub-pixel step of the boundary are free, no other may differ. "
               "Sizes are whole or the largest supported; none asks fractional sizes. "
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

  of[12] = {.clause = "14.5.2.2 (Wide Lines)",
            .quotation =
                "The actual width of non-antialiased lines is determined by rounding the "
                "supplied width to the nearest integer, then clamping it",
            .khronos =
                "dEQP-GLES3.functional.rasterization.primitives.lines_wide etc. "
                "(tcuRasterizationVerifier.cpp verifySinglesampleLineGroupRasterization): "
                "floor(w + 0.5), AND one less if the width has a fraction "
                "(\"lineWidthHasFrac\"); reference fragment within 1 pixel of a drawn one; count "
                "off by at most lines x width; never checks extra stray fragments or clause 4. "
                "The reference line rasterizer cuts columns at the viewport",
            .es = "13.6.2.1: same"};

  of[46] = {
      .clause = "14.5.1, equations 14.5 to 14.7; 14.5.2.2",
      .quotation = "Set t = (p_r - p_a) . (p_b - p_a) / |p_b - p_a|^2",
      .basis = Basis::contested,
      .contest =
          "J.4 (October 22, 2019) loosens 14.5.2.2 to \"allow diagonal interpolation of input "
          "attributes, bring the specification in line with Vulkan and shipping hardware\"",
      .khronos =
          "dEQP-GLES3.functional.rasterization.interpolation.*.lines, lines_wide: values by "
          "the major axis are accepted with a quality warning",
      .es = "13.6.1: the formula may be approximated by the major axis alone"};

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

  of[16] = {.clause = "8.14.1 (Derivative Functions)",
            .revision = kLanguage,
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
                "this value can be for any location within the pixel, or one of the fragment "
                "samples. The use of centroid does not further restrict",
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

  of[19] = {.clause = "8.14.1 (Scale Factor and Level-of-Detail)",
            .quotation =
                "an elliptical footprint in texture space. The ideal scale factor ρ should be "
                "the major axis of this ellipse",
            .khronos =
                "dEQP-GLES3.functional.texture.filtering.*, "
                "dEQP-GLES3.functional.texture.mipmap.*: tcuTexLookupVerifier.cpp "
                "`computeLodBoundsFromDerivates`: lambda from log2 of the largest partial to "
                "log2 of sqrt(2) times the larger sum (exactly the first bound; m_u + m_v is not "
                "used), rho with 18 bits of derivates (10 for cubes), lambda widened by 2^-6 "
                "(2^-5 for cubes), or 2^-4 with a quality warning",
            .es =
                "8.14.1: the first bound only; no 8.11, 8.12, no m_u + m_v; same ideal. So in ES "
                "the upper bound is sqrt(2) max(sum along x, sum along y) alone"};

  of[20] = {.clause = "8.14.1, equation 8.7; 2.3.4.1",
            .quotation = "λ_base(x, y) = log2[ρ(x, y)]",
            .khronos =
                "dEQP-GLES3.functional.texture.mipmap.2d.basic.*: lodBits 8 (6 projected); "
                "texture.filtering: 6, cubes 5, and 4 as quality warning; generated maps 6. "
                "KHR-GL4x texture_query_lod: colours within 15/255 of clamped log2",
            .es = "8.14.1, 8.6, same; no textureQueryLod"};

  of[21] = {
      .clause = "8.14.1 and 8.14.3, equation 8.14",
      .quotation = "If λ(x, y) is less than or equal to zero, the texture is said to be magnified",
      .khronos = "texture.mipmap.*: either level within lodBits of the tie",
      .es = "8.14.3, 8.11: same two"};

  of[22] = {.clause = "8.14.3",
            .quotation = "τ = [1 − frac(λ)]τ1 + frac(λ)τ2",
            .khronos =
                "lodBits 6, then 4 with a quality warning (texture.filtering); 8 in "
                "texture.mipmap",
            .es = "8.14.3: same; no query"};

  of[23] = {.clause = "8.14 (Texture Minification)",
            .quotation =
                "The anisotropic texture filtering scheme may only access mipmap levels if the "
                "minification filter is one that requires mipmaps",
            .khronos =
                "KHR-GL46.texture_filter_anisotropic.* (glcTextureFilterAnisotropicTests.cpp): "
                "queries; and, on a striped texture, that a count of blurred points falls "
                "strictly as anisotropy goes from 1 to 2 to the maximum (so a renderer whose "
                "anisotropy does nothing fails there; our R23 lets it pass: the maximum is a "
                "\"should\")",
            .es =
                "not in core; EXT_texture_filter_anisotropic (OpenGL-Registry) has the same "
                "sentences on mipmaps and base..max levels"};

  of[24] = {.clause =
                "8.14.2 (Coordinate Wrapping and Texel Selection); 8.24 (sRGB Texture Color "
                "Conversion); 2.3.4",
            .quotation =
                "implementations are allowed to perform this conversion after filtering (though "
                "this post-filtering approach is inferior to converting from sRGB prior to "
                "filtering)",
            .khronos =
                "dEQP-GLES3.functional.texture.filtering.* (es3fTextureFilteringTests.cpp): "
                "coordBits 20, uvwBits 7 (6 for cubes and 3D coordinates 7), colour threshold of "
                "the target's bits less 1 or 2; second try uvwBits 4 and lodBits 4 = quality "
                "warning \"Low-quality filtering result\". texture.mipmap.*: uvwBits 16 on "
                "single-coloured levels. "
                "dEQP-GLES31.functional.srgb_texture_decode.skip_decode.* "
                "(es31fSRGBDecodeTests.cpp): 0.005 in shader and CPU comparisons: an "
                "approximation off by 0.0012 passes",
            .es =
                "8.21: the same leave to convert after filtering; 8.14.2 same; no border clamp "
                "before 3.2; MIRROR_CLAMP_TO_EDGE missing"};

  of[25] = {.clause = "8.14.4 (Manual Mipmap Generation)",
            .quotation =
                "No particular filter algorithm is required, though a box filter is recommended "
                "as the default filter",
            .khronos =
                "dEQP-GLES3.functional.texture.mipmap.2d.generate.* (gluTextureTestUtil.cpp): "
                "level 0 unchanged; each level by bilinear or box within 4 bits of position; "
                "else \"very lenient\": within the least and most of the texels of the level "
                "above in a window of 1.5 texels = quality warning; beyond = failure",
            .es =
                "8.14.4: same; sRGB formats must be colour-renderable and filterable, else an "
                "error"};

  of[26] = {.clause = "8.14.1 (Scale Factor and Level-of-Detail)",
            .quotation =
                "Different implementations have chosen to perform clamping on intermediate and "
                "final terms ... different results may otherwise occur",
            .khronos =
                "dEQP-GLES3.functional.texture.mipmap.*.bias.* (es3fTextureMipmapTests.cpp): "
                "shader biases 1, -2, 0.8, -0.5, 1.5, 0.9, 2 and 4 with lodBits 8 (6 with "
                "projection; 4 is beyond the least limit of 2.0 and is not treated otherwise); "
                "none asks what lies beyond the limit of the implementation, and none has the "
                "sampler's bias (ES has none)",
            .es =
                "8.14.1, equation 8.7: bias_shader alone (ES has no TEXTURE_LOD_BIAS), the same "
                "clamp; the sentence on different clamping is missing, so beyond the limit ES is "
                "strict"};

  of[27] = {
      .clause = "14.3.1 (Multisampling)",
      .quotation =
          "These sample points do not necessarily correspond to the shading sample "
          "locations ... Their locations cannot be queried, and may lie inside or outside",
      .khronos =
          "dEQP-GLES31.functional.shaders.sample_variables.sample_pos.correctness/distribution "
          "(es31fSampleVariableTests.cpp): gl_SamplePosition lies in the pixel and the "
          "interpolated coordinate at the sample agrees with it; distribution: not all in "
          "one place. dEQP-GLES3.functional.multisample.*.num_samples, polygon/line "
          "patterns: at least samples + 1 shades are seen (quality warning on large "
          "targets). None asks that coverage follow GL_SAMPLE_POSITION. "
          "dEQP-GLES3.functional.rasterization.fbo.*.primitives multisampled targets "
          "(dEQP-GLES3.functional.rasterization.fbo.rbo_multisample_*.primitives): pixels "
          "that the primitive covers wholly must be full, pixels that it does not meet "
          "must be empty, all others are free: so they take sample points to lie within "
          "the pixel, and no more",
      .es =
          "13.4: same words; adds that the told place is where depth and data are "
          "evaluated"};

  of[28] = {.clause =
                "14.5.4 (Line Multisample Rasterization); 14.5.2.3 (Antialiasing); 14.4.1 "
                "(widths)",
            .quotation =
                "Two of the edges are parallel to the specified line segment; each is at a "
                "distance of one-half the current width",
            .khronos =
                "dEQP-GLES3.functional.rasterization.fbo.rbo_multisample_*.primitives.lines(_wide) "
                "and .interpolation: verifyMultisampleLineGroupRasterization: as two triangles "
                "of the rectangle, with the edges free; wide multisampled failing is a "
                "compatibility warning only. (The functions' `strictMode`/Bresenham branches "
                "serve Vulkan.)",
            .es =
                "13.6.4: same rectangle; MULTISAMPLE_LINE_WIDTH_RANGE and _GRANULARITY; \"If an "
                "unsupported width is requested, the nearest supported width is used instead. "
                "Width 1.0 segments must be supported.\""};

  of[29] = {.clause = "14.3.1 (Multisampling)",
            .quotation =
                "set to the values that would have been assigned by single-sample rasterization, "
                "or they may be assigned as described below for multisample rasterization",
            .khronos =
                "dEQP-GLES31.functional.shaders.multisample_interpolation.* "
                "(es31fShaderMultisampleInterpolationTests.cpp): sample and interpolateAt* only, "
                "within rounding of 8-bit colours; shaders.sample_variables.sample_pos.*: "
                "gl_SamplePosition in [0,1] and varied. None asks where an unqualified attribute "
                "lies, none disables GL_MULTISAMPLE",
            .es =
                "13.4, same, but there is no GL_MULTISAMPLE to disable (only "
                "EXT_multisample_compatibility); 13.4 adds that the queried place is that \"at "
                "which depth and associated data for that sample are evaluated\". 13.6.4: same "
                "for lines, and the major-axis approximation of R9 may not be used there"};

  of[30] = {
      .clause = "4.5 (Interpolation Qualifiers)",
      .revision = kLanguage,
      .quotation =
          "interpolated at a location that lies in both the pixel and in the primitive "
          "being rendered, including any of the pixel's samples covered",
      .khronos =
          "dEQP-GLES31.functional.shaders.multisample_interpolation.interpolate_at_centroid.* "
          "and glcShaderMultisampleInterpolationTests.cpp: barycentrics of narrow "
          "triangles stay within [0,1] with a small epsilon; consistency of both ways; "
          "sample qualifier at samples",
      .es = "ESSL 4.5: same"};

  of[31] = {.clause = "18.3.1 (Blitting Pixel Rectangles)",
            .quotation =
                "If the source formats are floating-point or normalized types, the sample values "
                "for each pixel are resolved in an implementation-dependent manner",
            .khronos =
                "dEQP-GLES3.functional.fbo.msaa.* (es3fFboMultisampleTests.cpp): resolved image "
                "compared with the image of the reference, threshold 12/255 and more; uniform "
                "areas (green) within 12/255. So equal samples must resolve to within 12 codes",
            .es = "16.2.1: same words"};

  of[32] = {.clause = "14.9.3; 15.2.2",
            .quotation =
                "Bits in the sample mask corresponding to covered samples that will be killed "
                "due to SAMPLE_COVERAGE or SAMPLE_MASK will not be set",
            .khronos =
                "es31cTextureStorageMultisampleSampleMaskiTests.cpp; "
                "dEQP-GLES31.functional.shaders.sample_variables.sample_mask_in.* "
                "(bit_count_per_pixel etc.), texture.multisample.*.use_texture... sample_mask_*",
            .es = "13.8.3, 14.2.2: same; skipped only if SAMPLE_BUFFERS is not one"};

  of[33] = {.clause = "17.3.1 (Alpha To Coverage); 14.9.3 (Multisample Fragment Operations)",
            .quotation =
                "The function need not be identical, but it must have the same properties of "
                "proportionality and invariance",
            .khronos =
                "dEQP-GLES3.functional.multisample.*.proportionality_alpha_to_coverage "
                "(es3fMultisampleTests.cpp MaskProportionalityCase): image's sum never falls as "
                "alpha grows, 0 makes black, 1 makes all red; constancy_alpha_to_coverage: same "
                "alpha and pixel, same mask",
            .es = "15.1.1: same, no alpha to one; 13.8.3 same intent"};

  of[34] = {
      .clause = "14.3.1.1 (Sample Shading); 15.2.2",
      .quotation =
          "unique sets of fragment shader inputs for each fragment ... These are "
          "associated with the samples in an implementation-dependent manner",
      .khronos =
          "dEQP-GLES31.functional.sample_shading.min_sample_shading.multisample_*_{color,discard} "
          "(es31fSampleShadingTests.cpp): at least m + 1 shades over whole pixels (the "
          "triangles' edge is skipped); sample_variables.sample_mask_in.bits_unique*: "
          "every bit in one invocation",
      .es =
          "13.4.1: same, \"If the value of SAMPLE_BUFFERS is zero or SAMPLE_SHADING is "
          "disabled\""};

  of[35] = {.clause =
                "14.3.1 (Multisampling); 15.2.2 (Shader Inputs); 17.3.10 (Additional Multisample "
                "Fragment Operations)",
            .quotation =
                "multisample rasterization of all primitives is equivalent to single-sample "
                "(fragment-center) rasterization, except that the fragment coverage value is set "
                "to full coverage",
            .khronos =
                "none asks this (glDisable(GL_MULTISAMPLE) occurs only in tests that do not look "
                "at samples: glcFramebufferBlitTests.cpp, gl4cPostDepthCoverageTests.cpp)",
            .es =
                "no such state (13.4: multisample rasterization whenever SAMPLE_BUFFERS is one; "
                "14.2.2: bit 0 for a non-multisample buffer). With EXT_multisample_compatibility "
                "its own text holds: do not judge"};

  of[36] = {
      .clause = "17.3.6.1 (Blend Equation); GLSL 4.60, 4.7.1",
      .quotation =
          "performed with a precision and dynamic range no lower than that used to "
          "represent destination components",
      .khronos = "none asks this (float blending is tested with 8-bit style thresholds)",
      .es = "15.1.5.1: same sentence; blending of 32-bit float targets needs EXT_float_blend"};

  of[37] = {.clause = "17.3.6.1; 2.3.5.2; 17.4.2",
            .quotation =
                "performed with a precision and dynamic range no lower than that used to "
                "represent destination components",
            .khronos =
                "dEQP-GLES3.functional.fragment_ops.blend.* (es3fBlendTests.cpp): threshold 2.5 "
                "codes of the target + 3 (sRGB + 5), i.e. 5 codes of 8 bits; random fragment ops "
                "5 x + 2 when blending",
            .es = "15.1.5.1: same"};

  of[38] = {.clause = "14.6.5 (Depth Offset)",
            .quotation =
                "The minimum resolvable difference r is an implementation-dependent parameter "
                "that depends on the depth buffer representation",
            .khronos =
                "dEQP-GLES3.functional.polygon_offset.{default,fixed16,fixed24,float32}_* "
                "(es3fPolygonOffsetTests.cpp): that units of -1 beat depth 0 ties, that the "
                "result is clamped, that factor 0 and 1 slopes order triangles; images within 1 "
                "pixel, no size of r is asked. glcPolygonOffsetClampTests.cpp: min/max of the "
                "clamp, and depth compared through rendering. The reference (rrRenderer.cpp) has "
                "r = 2^-n for n fixed bits (which backs our lower bound 2^-n) and 2^(e - 23) for "
                "float32, e of the largest vertex depth. Piglit read-depth-offset.c (2024): for "
                "fixed-point formats only that r is the same for all depths; floats by the "
                "formula",
            .es =
                "13.7.2: same formulas without the clamp parameter (EXT_polygon_offset_clamp), "
                "same clamping"};

  of[39] = {.clause = "13.8.1 (Controlling the Viewport); 17.3.4 (Depth Buffer Test)",
            .quotation =
                "z_w may be represented using either a fixed-point or floating-point "
                "representation",
            .khronos =
                "dEQP-GLES3.functional.depth_stencil.*, random fragment_ops (glsFragmentOpUtil, "
                "es3fRandomFragmentOpTests.cpp): equal tests against depths drawn by the same "
                "quads, images compared with threshold; they pass only if the same depth "
                "compares as equal in practice. None isolates it",
            .es =
                "12.6.1: the same pair of sentences (fixed-point or floating-point; "
                "floating-point must be used for a floating-point depth buffer); 15.1.3 same"};

  of[40] = {.clause = "14.6.1 (Basic Polygon Rasterization)",
            .quotation =
                "based on the sign of the (clipped or unclipped) polygon's area computed in "
                "window coordinates",
            .khronos =
                "dEQP-GLES3.functional.rasterization.culling.* (unclipped triangles); none with "
                "clipped ones",
            .es = "13.7.1: same words"};

  of[41] = {.clause = "17.3.3 (Stencil Test); 17.4.2",
            .quotation =
                "Stencil tests and writes use the front set of stencil state when processing "
                "fragments rasterized from non-polygon primitives (points and lines) and "
                "front-facing polygon primitives",
            .khronos =
                "dEQP-GLES3.functional.fragment_ops.stencil.*, depth_stencil.*: exact stencil "
                "values through coloured passes, thresholds of colour only",
            .es = "15.1.2: same"};

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

  of[45] = {.clause = "14.6.5 (Depth Offset)",
            .quotation =
                "Fragment depth values are clamped even when the depth buffer uses a "
                "floating-point representation",
            .basis = Basis::contested,
            .contest =
                "14.6.5 clamps depths once they are offset; 15.2.2 says of gl_FragCoord only "
                "that the offset is added in, and drivers clamp where depths are tested",
            .khronos = "none asks this: no test reads gl_FragCoord.z after an offset",
            .es =
                "13.7.2: same formulas without the clamp parameter (EXT_polygon_offset_clamp), "
                "same clamping"};

  of[47] = {
      .clause = "14.3.1 (Multisampling)",
      .quotation =
          "These sample points do not necessarily correspond to the shading sample "
          "locations ... Their locations cannot be queried, and may lie inside or outside",
      .basis = Basis::contested,
      .contest =
          "the points at which coverage is found cannot be asked for; no test of coverage "
          "follows GL_SAMPLE_POSITION, and the Khronos tests leave all partly covered "
          "pixels free",
      .khronos =
          "dEQP-GLES31.functional.shaders.sample_variables.sample_pos.correctness/distribution "
          "(es31fSampleVariableTests.cpp): gl_SamplePosition lies in the pixel and the "
          "interpolated coordinate at the sample agrees with it; distribution: not all in "
          "one place. dEQP-GLES3.functional.multisample.*.num_samples, polygon/line "
          "patterns: at least samples + 1 shades are seen (quality warning on large "
          "targets). None asks that coverage follow GL_SAMPLE_POSITION. "
          "dEQP-GLES3.functional.rasterization.fbo.*.primitives multisampled targets "
          "(dEQP-GLES3.functional.rasterization.fbo.rbo_multisample_*.primitives): pixels "
          "that the primitive covers wholly must be full, pixels that it does not meet "
          "must be empty, all others are free: so they take sample points to lie within "
          "the pixel, and no more",
      .es =
          "13.4: same words; adds that the told place is where depth and data are "
          "evaluated"};

  of[48] = {.clause = "8.14.4 (Manual Mipmap Generation)",
            .quotation =
                "No particular filter algorithm is required, though a box filter is recommended "
                "as the default filter",
            .basis = Basis::contested,
            .contest =
                "no particular filter is required, and filters with negative weights lead beyond "
                "the range of the texels",
            .khronos =
                "dEQP-GLES3.functional.texture.mipmap.2d.generate.* (gluTextureTestUtil.cpp): "
                "level 0 unchanged; each level by bilinear or box within 4 bits of position; "
                "else \"very lenient\": within the least and most of the texels of the level "
                "above in a window of 1.5 texels = quality warning; beyond = failure",
            .es =
                "8.14.4: same; sRGB formats must be colour-renderable and filterable, else an "
                "error"};

  of[50] = {.clause =
                "8.14.1 (Scale Factor and Level-of-Detail); 8.14.2 (Coordinate Wrapping and "
                "Texel Selection); 2.3.4.1",
            .quotation =
                "individual results of floating-point operations are accurate to about 1 part in "
                "10^5",
            .basis = Basis::contested,
            .contest =
                "the letter states 1 part in 10^5 of each operation and no precision of "
                "samplers; the Khronos tests ask for 6 bits of the level and 7 of coordinates, "
                "and let 4 and 4 pass with a warning",
            .khronos =
                "dEQP-GLES3.functional.texture.filtering.* (es3fTextureFilteringTests.cpp): "
                "coordBits 20, uvwBits 7 (6 for cubes and 3D coordinates 7), colour threshold of "
                "the target's bits less 1 or 2; second try uvwBits 4 and lodBits 4 = quality "
                "warning \"Low-quality filtering result\". texture.mipmap.*: uvwBits 16 on "
                "single-coloured levels. "
                "dEQP-GLES31.functional.srgb_texture_decode.skip_decode.* "
                "(es31fSRGBDecodeTests.cpp): 0.005 in shader and CPU comparisons: an "
                "approximation off by 0.0012 passes",
            .es = "8.14.1, 8.14.2, 2.3.4.1: same"};

  of[51] = {.clause = "18.3.1 (Blitting Pixel Rectangles)",
            .quotation =
                "If the source formats are floating-point or normalized types, the sample values "
                "for each pixel are resolved in an implementation-dependent manner",
            .basis = Basis::contested,
            .contest =
                "the letter leaves the method to the implementation; the Khronos tests do not "
                "pass what is farther off",
            .khronos =
                "dEQP-GLES3.functional.fbo.msaa.* (es3fFboMultisampleTests.cpp): resolved image "
                "compared with the image of the reference, threshold 12/255 and more; uniform "
                "areas (green) within 12/255. So equal samples must resolve to within 12 codes",
            .es = "16.2.1: same words"};

  of[52] = {.clause = "17.3.1 (Alpha To Coverage); 14.9.3 (Multisample Fragment Operations)",
            .quotation =
                "The function need not be identical, but it must have the same properties of "
                "proportionality and invariance",
            .basis = Basis::contested,
            .contest =
                "17.3.1 says that the function must have the properties of proportionality of "
                "14.9.3, and 14.9.3 calls them intended",
            .khronos =
                "dEQP-GLES3.functional.multisample.*.proportionality_alpha_to_coverage "
                "(es3fMultisampleTests.cpp MaskProportionalityCase): image's sum never falls as "
                "alpha grows, 0 makes black, 1 makes all red; constancy_alpha_to_coverage: same "
                "alpha and pixel, same mask",
            .es = "15.1.1: same, no alpha to one; 13.8.3 same intent"};

  of[53] = {.clause =
                "8.14.2 (Coordinate Wrapping and Texel Selection); 8.24 (sRGB Texture Color "
                "Conversion); 2.3.4",
            .quotation =
                "implementations are allowed to perform this conversion after filtering (though "
                "this post-filtering approach is inferior to converting from sRGB prior to "
                "filtering)",
            .basis = Basis::contested,
            .contest =
                "no precision is stated for the conversion of 8.24 but 1 part in 10^5 of each "
                "operation, formats of 8 bits limit it by 2.3.4, and the Khronos tests take "
                "0.005",
            .khronos =
                "dEQP-GLES3.functional.texture.filtering.* (es3fTextureFilteringTests.cpp): "
                "coordBits 20, uvwBits 7 (6 for cubes and 3D coordinates 7), colour threshold of "
                "the target's bits less 1 or 2; second try uvwBits 4 and lodBits 4 = quality "
                "warning \"Low-quality filtering result\". texture.mipmap.*: uvwBits 16 on "
                "single-coloured levels. "
                "dEQP-GLES31.functional.srgb_texture_decode.skip_decode.* "
                "(es31fSRGBDecodeTests.cpp): 0.005 in shader and CPU comparisons: an "
                "approximation off by 0.0012 passes",
            .es =
                "8.21: the same leave to convert after filtering; 8.14.2 same; no border clamp "
                "before 3.2; MIRROR_CLAMP_TO_EDGE missing"};

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

  of[55] = {.clause = "13.8.1 (Controlling the Viewport); 17.3.4 (Depth Buffer Test)",
            .quotation =
                "z_w may be represented using either a fixed-point or floating-point "
                "representation",
            .basis = Basis::contested,
            .contest =
                "13.8.1 lets window depths be floating-point numbers, and 17.3.4 names no "
                "conversion before the comparison; 15.2.3 and 14.6.5 read otherwise",
            .khronos =
                "dEQP-GLES3.functional.depth_stencil.*, random fragment_ops (glsFragmentOpUtil, "
                "es3fRandomFragmentOpTests.cpp): equal tests against depths drawn by the same "
                "quads, images compared with threshold; they pass only if the same depth "
                "compares as equal in practice. None isolates it",
            .es =
                "12.6.1: the same pair of sentences (fixed-point or floating-point; "
                "floating-point must be used for a floating-point depth buffer); 15.1.3 same"};

  of[56] = {.clause = "14.5.2.2 (Wide Lines)",
            .quotation =
                "The actual width of non-antialiased lines is determined by rounding the "
                "supplied width to the nearest integer, then clamping it",
            .basis = Basis::contested,
            .contest =
                "the Khronos tests take the next smaller width, too, where the width asked for "
                "has a fraction",
            .khronos =
                "dEQP-GLES3.functional.rasterization.primitives.lines_wide etc. "
                "(tcuRasterizationVerifier.cpp verifySinglesampleLineGroupRasterization): "
                "floor(w + 0.5), AND one less if the width has a fraction "
                "(\"lineWidthHasFrac\"); reference fragment within 1 pixel of a drawn one; count "
                "off by at most lines x width; never checks extra stray fragments or clause 4. "
                "The reference line rasterizer cuts columns at the viewport",
            .es = "13.6.2.1: same"};

  of[57] = {.clause = "8.14 (Texture Minification)",
            .quotation =
                "The anisotropic texture filtering scheme may only access mipmap levels if the "
                "minification filter is one that requires mipmaps",
            .basis = Basis::contested,
            .contest =
                "the scheme is the implementation's, and filters with negative weights lead "
                "beyond the range of the texels",
            .khronos =
                "KHR-GL46.texture_filter_anisotropic.* (glcTextureFilterAnisotropicTests.cpp): "
                "queries; and, on a striped texture, that a count of blurred points falls "
                "strictly as anisotropy goes from 1 to 2 to the maximum (so a renderer whose "
                "anisotropy does nothing fails there; our R23 lets it pass: the maximum is a "
                "\"should\")",
            .es =
                "not in core; EXT_texture_filter_anisotropic (OpenGL-Registry) has the same "
                "sentences on mipmaps and base..max levels"};

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

  return of;
}

}  // namespace

RulingSource source_of(int ruling) {
  static const std::map<int, RulingSource> known = sources();
  const auto found = known.find(ruling);
  return found == known.end() ? RulingSource{} : found->second;
}

}  // namespace edgecase
