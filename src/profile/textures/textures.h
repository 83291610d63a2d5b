// SPDX-License-Identifier: MIT
//
// Textures: which alternatives of the rules for lookups, levels of detail and mip chains a renderer
// follows, and how far its levels of detail are from the formulas.
//
//   probes -> filters and their weights -> ramps -> level of detail -> ties of levels, biases,
//   anisotropy, mip chains -> more ramps -> residuals
//
// Renderings are discarded once counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "generate/random_scenes.h"
#include "model/names.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "raster/attributes.h"
#include "rules/choices.h"

namespace edgecase {

// Scenes for measuring textures.
//
// Each depends only on its seed and index, like those of generate/random_scenes.h. Vertices lie on
// whole pixels, or points on pixels' centres, so that no snapping moves them; for questions about
// ties, texture coordinates are short binary fractions.

// --------------------------------------------------------------------------------------- questions

// The question of a scene; everything else that could matter is constant.
enum class TextureQuestion {
  level_weight,    // the weight of the second level, at levels given by the shader
  texel_grid,      // texels, and their weights, across a texel or a border
  wrap,            // mirrored repetition
  implicit_tie,    // the nearest level, with ties made by footprints
  bias_tie,        // ... by a bias
  explicit_tie,    // ... by the shader
  crossover,       // filters just beyond a level of 0
  sampler_bias,    // the sampler's bias, for levels given by the shader
  gradients_bias,  // the same, for gradients
  bias_sum,        // both biases, together beyond their limit
  anisotropy,      // levels of elongated footprints
};

struct TextureProbes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  TextureQuestion question = TextureQuestion::level_weight;
  TextureFormat format = TextureFormat::rgba8;  // of the first two questions; others have their own
};
Scene texture_probe(const TextureProbes& of, std::uint64_t index);

// A texture with generated levels, of even, odd and very unequal sizes.
Scene chain_scene(std::uint64_t seed, Surface surface, TextureFormat format, std::uint64_t index);

// ------------------------------------------------------------------------------------------- ramps

// Footprints whose levels rise over the target. A ramp has a texture of floats with one flat colour
// per level, with red the level's number, and blends the two nearest: so the lookup shows the level
// of detail, as textureQueryLod does.
enum class RampKind {
  axis_aligned,   // u along x and v along y, or swapped
  diagonal,       // along both
  rotated,        // by any angle
  anisotropic,    // 2:1 to 16:1, by any angle
  perspective,    // a floor: w differs
  magnification,  // from levels far below 0 to beyond the last
};
template <>
inline constexpr auto kNames<RampKind> =
    std::to_array<Named<RampKind>>({{RampKind::axis_aligned, "axis-aligned"},
                                    {RampKind::diagonal, "diagonal"},
                                    {RampKind::rotated, "rotated"},
                                    {RampKind::anisotropic, "anisotropic"},
                                    {RampKind::perspective, "perspective"},
                                    {RampKind::magnification, "magnification"}});

// Scenes of different purposes are independent.
enum class RampPurpose { traits, residuals };

struct Ramps {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  RampKind kind = RampKind::axis_aligned;
  RampPurpose purpose = RampPurpose::residuals;
};
Scene ramp_scene(const Ramps& of, std::uint64_t index);

// ------------------------------------------------------------------------------- parts of scenes

// Texels of the base level per pixel along x and along y.
struct TexelSteps {
  std::array<double, 2> dx{};  // du/dx and dv/dx
  std::array<double, 2> dy{};
};

struct ImageSize {
  int width = 1;
  int height = 1;
};

// A component of a level's texel: code or number, as the format stores it.
using TexelNumber = std::function<float(int level, int i, int j, int component)>;

// A texture with this number of levels; 0: a whole chain.
Texture texture_of(TextureFormat format, ImageSize size, int levels, const TexelNumber& number);

// A whole chain of floats: red is the level's number.
Texture numbered_levels(ImageSize size);

// The number that stands for 1 in a format.
constexpr float full(TextureFormat format) {
  return holds_floats(format) ? 1.0f : 255.0f;
}

// A target with one texture and without draws; requests details of lookups.
Scene textured_scene(Surface surface, ImageSize target, Texture texture);

Draw textured_draw(Primitive primitive, const Sampler& sampler, const Lookup& lookup);

// The default sampler of the questions: all filters nearest, the levels blended or not.
Sampler sampler_of(Filter magnify, Filter minify, MipFilter mipmap);

// One vertex on whole pixels, or halves.
Vertex textured_vertex(double x, double y, std::array<double, 2> coordinates);

// A square of two triangles with lower left pixel (x, y), whose texture coordinates start at
// `origin` and grow by `steps`.
struct Cell {
  int x = 0;
  int y = 0;
  int side = 4;  // pixels
};
void add_cell(Draw& draw, const Cell& cell, std::array<double, 2> origin, const TexelSteps& steps,
              ImageSize texture);

// Adds a draw; if the texture has one dimension, t becomes 0 everywhere.
void add_draw(Scene& scene, Draw draw);

// A point of one pixel, the n-th of a target of that width.
Draw point_draw(std::size_t n, int target_width, const Sampler& sampler, const Lookup& lookup,
                std::array<double, 2> coordinates);

// From 0 to 1, with 24 bits.
double unit(RandomSource& random);

inline constexpr std::array kTextureFormats{TextureFormat::rgba8, TextureFormat::srgb8,
                                            TextureFormat::rgba32f};

// The name of a format in traits; empty for rgba8, which stands for the rule itself.
inline std::string probe_of(TextureFormat format) {
  return format == TextureFormat::rgba8 ? "" : name_of(format);
}

// ---------------------------------------------------------------------------------------- lookups

// The lookup of one fragment, as reported by the renderer.
struct FragmentLookup {
  PixelPosition pixel;
  int primitive = 0;
  std::array<double, 4> color{};
  std::optional<std::array<double, 2>> coordinates;  // s and t
  std::optional<double> lambda_prime;                // textureQueryLod's y
};

struct LookupScene {
  Scene scene;
  std::vector<FragmentLookup> lookups;
};

// At most `most` of a rendering's fragments with colours, evenly spread over their list.
std::vector<FragmentLookup> lookups_of(const Rendering& rendering, std::size_t most);

// The trait of a rule that colours decide. An alternative yields a lookup if its colour, at the
// reported coordinates, equals the renderer's up to float32 rounding, or up to rounding to 8-bit
// codes if all colours are codes. Lookups that all alternatives yield, or none, are no evidence.
// `found`: what is known so far, of textures and everything else.
Trait infer_texture_rule(const TraitId& id, std::span<const LookupScene> scenes,
                         const RuleChoices& found);

// ------------------------------------------------------------------------------- levels of detail

// The levels of detail of one ramp by formula, for one draw with one texture.
class RampLevels {
 public:
  // `scene` must outlive this object.
  RampLevels(const Scene& scene, const RuleChoices& found);

  // The footprint of a pixel, with exact derivatives, or with the errors of float32.
  Footprint exact_footprint(const FragmentLookup& lookup, DerivativeMethod method) const;
  Footprint rounded_footprint(const FragmentLookup& lookup, DerivativeMethod method) const;

  // The level that the renderer reports; nothing if it reports none.
  std::optional<double> reported(const FragmentLookup& lookup, LevelSource source) const;
  // The levels that may be reported for a lambda_base.
  Interval reportable(Interval lambda_base, LevelSource source) const;
  // Whether both are the same end of the existing levels, and so do not show how far they are.
  bool are_ends(double a, double b, LevelSource source) const;

 private:
  template <class Derivative>
  Footprint footprint_by(const Derivative& derivative) const;

  const Scene& scene_;
  const RuleChoices& found_;
  std::vector<PrimitiveAttributes> attributes_;
  double last_ = 0;
};

// texture.scale-factor, texture.log2 and texture.derivatives, which determine a level of detail
// only together: the combination that yields most of the lambda' of textureQueryLod and of the
// levels that ramps look up.
std::vector<Trait> infer_level_of_detail(std::span<const LookupScene> ramps,
                                         const RuleChoices& found);

// Measures how far one surface's levels of detail are from formulas of the exact texture
// coordinates: the formula that the renderer is found to follow, and all others in the catalogue,
// each a scale factor and a logarithm. Derivatives are those of the exact coordinates, by the
// method that the renderer is found to follow.
class ResidualTable {
 public:
  explicit ResidualTable(const RuleChoices& found) : found_(found) {}

  void add(RampKind kind, const std::string& id, const Scene& scene,
           const std::vector<FragmentLookup>& lookups);
  // In the order in which kinds were added; none for a source without reports.
  std::vector<LevelResiduals>& rows() { return rows_; }

 private:
  LevelResiduals& row(RampKind kind, LevelSource source);

  RuleChoices found_;
  std::vector<LevelResiduals> rows_;
};

// ------------------------------------------------------------------------------------- mip chains

// A whole chain that the renderer generated from one image.
struct GeneratedChain {
  TextureFormat format = TextureFormat::rgba8;
  std::vector<TextureLevel> levels;
};

// mipmap.filter, mipmap.rounding and mipmap.srgb: each level compared with the renderer's own
// previous one. Results for rgba8, and mipmap.srgb for srgb8, apply to all; traits with a format's
// name apply to that format only.
std::vector<Trait> infer_mip_chains(std::span<const GeneratedChain> chains);

extern const Subject kTextureSubject;

}  // namespace edgecase
