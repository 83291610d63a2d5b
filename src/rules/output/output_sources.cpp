// SPDX-License-Identifier: MIT
//
// Sources of the rulings on per-fragment operations.
#include "rules/catalogue.h"

namespace edgecase {

void add_output_sources(std::map<int, RulingSource>& of) {
  of[37] = {.clause = "17.3.6.1; 2.3.5.2; 17.4.2",
            .quotation =
                "performed with a precision and dynamic range no lower than that used to "
                "represent destination components",
            .khronos =
                "dEQP-GLES3.functional.fragment_ops.blend.* (es3fBlendTests.cpp): threshold 2.5 "
                "codes of the target + 3 (sRGB + 5), i.e. 5 codes of 8 bits; random fragment ops "
                "5 x + 2 when blending",
            .es = "15.1.5.1: same"};

  of[61] = {.clause = "17.3.6.1",
            .quotation =
                "performed with a precision and dynamic range no lower than that used to "
                "represent destination components",
            .basis = Basis::contested,
            .contest =
                "the letter states a precision and no bound for what a whole equation makes of it; "
                "the Khronos tests let results of 8 bits be 5 codes off",
            .khronos =
                "dEQP-GLES3.functional.fragment_ops.blend.* (es3fBlendTests.cpp): 2.5 codes of the "
                "target + 3, i.e. 5 codes of 8 bits",
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

  of[64] = {.clause = "14.6.5 (Depth Offset)",
            .quotation =
                "For fixed-point depth buffer representations, r is constant throughout the range "
                "of the entire depth buffer",
            .khronos =
                "Piglit read-depth-offset.c (2024): of fixed-point formats, r is the same for all "
                "depths; dEQP asks for no size of r",
            .es = "13.7.2: same words"};

  of[39] = {
      .clause =
          "15.2.3 (Shader Outputs); 17.3.4 (Depth Buffer Test); 13.8.1 (Controlling the Viewport)",
      .quotation =
          "depth written by a fragment shader is first clamped to [0, 1] and then converted to "
          "fixed-point as if it were a window z value",
      .khronos =
          "dEQP-GLES3.functional.depth_stencil.*, random fragment_ops (glsFragmentOpUtil, "
          "es3fRandomFragmentOpTests.cpp): equal tests against depths drawn by the same "
          "quads, images compared with threshold; they pass only if the same depth "
          "compares as equal in practice. None isolates it",
      .es =
          "14.2.3: the same sentence; 12.6.1: the same pair of sentences (fixed-point or "
          "floating-point; floating-point must be used for a floating-point depth buffer); 15.1.3 "
          "same"};

  of[41] = {.clause = "17.3.3 (Stencil Test); 17.4.2",
            .quotation =
                "Stencil tests and writes use the front set of stencil state when processing "
                "fragments rasterized from non-polygon primitives (points and lines) and "
                "front-facing polygon primitives",
            .khronos =
                "dEQP-GLES3.functional.fragment_ops.stencil.*, depth_stencil.*: exact stencil "
                "values through coloured passes, thresholds of colour only",
            .es = "15.1.2: same"};

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

  of[55] = of[39];
  of[55].basis = Basis::contested;
  of[55].contest =
      "13.8.1 lets window depths be floating-point numbers, and 17.3.4 names no conversion before "
      "the comparison; 15.2.3 and 14.6.5 read otherwise";
}

}  // namespace edgecase
