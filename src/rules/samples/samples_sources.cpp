// SPDX-License-Identifier: MIT
//
// Sources of the rulings on samples of a pixel.
#include "rules/catalogue.h"

namespace edgecase {

void add_samples_sources(std::map<int, RulingSource>& of) {
  of[27] = {
      .clause = "14.3.1 (Multisampling)",
      .quotation =
          "The location at which shading is performed for a given sample (the shading sample "
          "location) is queried",
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
          "13.4: same words; adds that the reported place is where depth and data are "
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
                "The location for evaluating such associated data can be anywhere within the pixel "
                "including the fragment center or any of the sample locations",
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
      .revision = kLanguageRevision,
      .quotation =
          "interpolated at a location that lies in both the pixel and in the primitive "
          "being rendered, including any of the pixel's samples covered",
      .khronos =
          "dEQP-GLES31.functional.shaders.multisample_interpolation.interpolate_at_centroid.* "
          "and glcShaderMultisampleInterpolationTests.cpp: barycentrics of narrow "
          "triangles stay within [0,1] but for a small margin; consistency of both ways; "
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
                "pseudo-random in nature, to avoid image artifacts due to regular coverage sample "
                "locations. The algorithm can and probably should be different at different pixel "
                "locations",
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

  of[60] = {
      .clause = "14.3.1.1 (Sample Shading)",
      .quotation =
          "unique sets of fragment shader inputs for each fragment ... These are "
          "associated with the samples in an implementation-dependent manner",
      .basis = Basis::contested,
      .contest =
          "the samples that share an invocation are the implementation's, and no sentence "
          "makes shares equal: all that is covered of a pixel may share one",
      .khronos =
          "dEQP-GLES31.functional.sample_shading.min_sample_shading.*: shades are counted over "
          "whole pixels, those at the triangles' edge are skipped",
      .es = "13.4.1: same"};

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

  of[47] = {
      .clause = "14.3.1 (Multisampling)",
      .quotation =
          "These sample points do not necessarily correspond to the shading sample locations "
          "returned by GetMultisamplefv. Their locations cannot be queried",
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
          "13.4: same words; adds that the reported place is where depth and data are "
          "evaluated"};

  of[51] = {.clause = "18.3.1 (Blitting Pixel Rectangles)",
            .quotation =
                "If the source formats are floating-point or normalized types, the sample values "
                "for each pixel are resolved in an implementation-dependent manner",
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

  of[69] = {.clause = of[52].clause,
            .quotation =
                "It is intended that the number of 1's in this value be proportional to the sample "
                "coverage value",
            .basis = Basis::contested,
            .contest = of[52].contest,
            .khronos = of[52].khronos,
            .es = of[52].es};

  of[62] = {.clause = "14.3.1 (Multisampling)",
            .quotation =
                "Their locations cannot be queried, and may lie inside or outside of the unit "
                "square that is considered to bound the pixel",
            .basis = Basis::contested,
            .contest =
                "the letter leaves the places of samples to the renderer, and does not say that "
                "they differ; the Khronos tests count shades along edges",
            .khronos =
                "dEQP-GLES3.functional.multisample.*.num_samples (es3fMultisampleTests.cpp): "
                "polygons and lines show at least samples + 1 shades, else fail, or a quality "
                "warning on large targets; "
                "dEQP-GLES31.functional.shaders.sample_variables.sample_pos.distribution: not all "
                "samples at one place",
            .es = "13.4: same words"};

  of[65] = {.clause = "8.8 (Multisample Textures); 14.3.1 (Multisampling)",
            .quotation =
                "If fixedsamplelocations is TRUE, the image will use identical sample locations "
                "and the same number of samples for all texels in the image",
            .khronos =
                "none compares the coverage of two answers; "
                "dEQP-GLES3.functional.rasterization.fbo.rbo_multisample_*.primitives lets partly "
                "covered pixels be free, with each primitive judged alone",
            .es = "8.8: same words; renderbuffers say nothing of their locations, and are exempt"};
}

}  // namespace edgecase
