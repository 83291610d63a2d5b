// SPDX-License-Identifier: MIT
//
// Sources of the rulings on textures.
#include "rules/catalogue.h"

namespace edgecase {

void add_textures_sources(std::map<int, RulingSource>& of) {
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

  of[20] = {.clause = "8.14.1 (Scale Factor and Level-of-Detail), equation 8.7; 2.3.4.1",
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
                "The contents of the derived images are computed by repeated, filtered reduction "
                "of the level_base image. ... No particular filter algorithm is required",
            .khronos =
                "dEQP-GLES3.functional.texture.mipmap.2d.generate.* (gluTextureTestUtil.cpp): "
                "level 0 unchanged; each level by bilinear or box within 4 bits of position; "
                "else \"very lenient\": within the least and most of the texels of the level "
                "above that lie up to half a texel beyond its area, ends included, without "
                "tolerance = quality warning; beyond = failure",
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
                "above that lie up to half a texel beyond its area, ends included, without "
                "tolerance = quality warning; beyond = failure",
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
}

}  // namespace edgecase
