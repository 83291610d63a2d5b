// SPDX-License-Identifier: MIT
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <optional>
#include <span>
#include <utility>

#include "raster/rasterizer.h"
#include "raster/texture_level.h"
#include "raster/texture_stage.h"
#include "rules/values/derivative.h"

namespace edgecase {
namespace {

// Whether the interval is as narrow as double precision makes it. An infinite one is not.
bool is_narrow(Interval scale_factor) {
  return scale_factor.high - scale_factor.low < scale_factor.high * 0x1p-30;
}

using RationalPair = std::array<Rational, 2>;

RationalPair rational_of(const std::array<float, 2>& vector) {
  return {edgecase::rational_of(vector[0]), edgecase::rational_of(vector[1])};
}

// The inputs of a lookup apart from the point.
struct Level {
  Footprint footprint;
  ProbeRow row;  // without probes if the shader gives the level itself
  // Offsets of the probes from the centre, in s and t; empty without derivatives or with one probe
  std::vector<std::array<Rational, 2>> ways;
  Interval logarithm;  // of the row's scale factor
  Interval lambda_prime;
  Interval lambda;
  Interval accessed;
  TexelBorders borders;  // of the filter within levels
  // Of the levels that are looked up: widths, heights.
  std::array<boost::container::small_vector<int, 2>, 2> sizes;

  std::span<const int> sizes_along(std::size_t axis) const {
    return {sizes[axis].data(), sizes[axis].size()};
  }
};

QueriedLevel queried_part(const Level& level) {
  return {level.accessed, level.lambda_prime};
}

Texel weighted(std::span<const Texel> colors, const Probes& probes) {
  const Texel& first = colors.front();
  if (std::ranges::all_of(colors, [&](const Texel& color) { return same_box(color, first); }))
    return first;
  Texel sum;
  for (std::size_t i = 0; i < colors.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) sum[c] = sum[c] + probes[i].weight * colors[i][c];
  return sum;
}

}  // namespace

class TexturedPrimitive::Lookups {
  // Where s and t are interpolated, and what they are there.
  struct Place {
    Point sample;
    std::array<Interval, 2> coordinates;
  };

 public:
  Lookups(const TextureStage& stage, const ScenePrimitive& primitive,
          const PrimitiveAttributes& attributes);
  ExactLookup look_up(PixelPosition pixel);
  QueriedLevel queried(PixelPosition pixel);

 private:
  std::optional<Level> given_level() const;
  bool is_queried() const;
  const Level& level_at(PixelPosition pixel);
  const Level& implicit_level(PixelPosition pixel, const Lookup& lookup,
                              std::optional<Level>& kept);
  Level computed_level(PixelPosition pixel, const Lookup& lookup);
  Level level_of(const Footprint& footprint, const Lookup& lookup) const;
  Level level_of(const RationalFootprint& derivatives, const Lookup& lookup) const;
  bool is_open(const Level& level) const;
  Interval biased(Interval lambda_base, const Lookup& lookup) const;
  Level finished(Level level) const;
  Footprint footprint_at(const QuadPixel& at) const;
  std::optional<RationalFootprint> derivatives_at(const QuadPixel& at);
  Texel color_at(const TexturePoint& point, const Level& level) const;
  std::array<Interval, 2> coordinates_at(PixelPosition pixel, Point sample) const;
  Interval place(std::size_t axis, const Place& at, const Level& level);
  TexturePoint probe_point(const Place& at, const Level& level, std::size_t probe);
  RationalFootprint texels(const RationalFootprint& derivatives) const;
  const DecodedLevel& image(int level) const {
    return decoded_.levels[static_cast<std::size_t>(std::min(level, last_))];
  }
  const DecodedLevel& base() const { return image(use_.sampler.base_level); }

  ScenePrimitive primitive_;
  const CoverageChoice& coverage_;
  const TextureChoice& choice_;
  const ValueChoice& values_;
  const Target& target_;
  const TextureUse& use_;
  const Texture& texture_;
  const DecodedTexture& decoded_;
  const Sampler limited_;    // with its limits as they are taken
  ExactCoordinates& known_;  // the stage's
  int number_;               // among the stage's primitives
  int last_;
  std::array<TextureAxis, 2> axes_;
  std::optional<Level> given_;  // from the shader
  std::optional<Level> level_;
  std::optional<Level> queried_;
};

TexturedPrimitive::Lookups::Lookups(const TextureStage& stage, const ScenePrimitive& primitive,
                                    const PrimitiveAttributes& attributes)
    : primitive_(primitive),
      coverage_(stage.choices().of(primitive.kind)),
      choice_(stage.choices().textures),
      values_(stage.choices().values),
      target_(stage.scene().target),
      use_(*primitive.state->texture),
      texture_(*stage.scene().textures.at(use_.texture)),
      decoded_(stage.decoded(use_.texture)),
      limited_(limited(use_.sampler, choice_.limits)),
      known_(stage.coordinates()),
      number_(stage.next_number()),
      last_(last_level_of(decoded_, limited_, texture_)),
      axes_{TextureAxis(attributes.color[0], use_.sampler.wrap[0]),
            TextureAxis(attributes.color[1], use_.sampler.wrap[1])},
      given_(given_level()) {}

RationalFootprint TexturedPrimitive::Lookups::texels(const RationalFootprint& derivatives) const {
  return in_texels(derivatives, base().width, base().height);
}

Footprint TexturedPrimitive::Lookups::footprint_at(const QuadPixel& at) const {
  const auto along = [&](Axis axis) {
    return known_.derivatives(number_, axes_[0].coordinate(), axes_[1].coordinate(), at, axis,
                              choice_.derivatives);
  };
  return footprint(along(Axis::x), along(Axis::y), base().width, base().height,
                   texture_.dimensions);
}

std::optional<RationalFootprint> TexturedPrimitive::Lookups::derivatives_at(const QuadPixel& at) {
  RationalFootprint result{{}, {}, texture_.dimensions};
  for (std::size_t c = 0; c < static_cast<std::size_t>(texture_.dimensions); ++c) {
    const auto x = axes_[c].derivative(at, Axis::x, choice_.derivatives);
    const auto y = axes_[c].derivative(at, Axis::y, choice_.derivatives);
    if (!x || !y) return std::nullopt;
    result.dx[c] = *x;
    result.dy[c] = *y;
  }
  return result;
}

// Uses intervals first, and quotients if these leave a question open.
Level TexturedPrimitive::Lookups::computed_level(PixelPosition pixel, const Lookup& lookup) {
  const QuadPixel at = quad_of(pixel, values_, target_);
  const Level level = level_of(footprint_at(at), lookup);
  const bool is_enough =
      !is_anisotropic(use_.sampler, choice_) && is_narrow(level.row.scale_factor);
  if (is_enough && !is_open(level)) return level;
  const std::optional<RationalFootprint> exact = derivatives_at(at);
  return exact ? level_of(*exact, lookup) : level;
}

Level TexturedPrimitive::Lookups::level_of(const Footprint& footprint, const Lookup& lookup) const {
  Level level;
  level.footprint = footprint;
  level.row =
      probes(footprint, use_.sampler.max_anisotropy, choice_.anisotropy, choice_.scale_factor);
  level.logarithm = log2_of(level.row.scale_factor, choice_.log2);
  level.lambda_prime = biased(level.logarithm, lookup);
  return finished(std::move(level));
}

// Whether an interval touches a border between two answers, before or after the bias is added.
bool TexturedPrimitive::Lookups::is_open(const Level& level) const {
  return is_level_open(level.logarithm, LevelWeight::exact) ||
         is_level_open(level.lambda_prime, choice_.level_weight);
}

// The logarithm is decided both before and after the bias is added: multiples of 1/2 become exact,
// and rounding of the sum moves no number onto a border.
Level TexturedPrimitive::Lookups::level_of(const RationalFootprint& derivatives,
                                           const Lookup& lookup) const {
  const RationalFootprint in_base = texels(derivatives);
  Level level;
  level.footprint = intervals_of(in_base);
  level.row = exact_probes(in_base, use_.sampler, choice_);
  const Rational squared = squared_scale_factor(in_base, level.row, use_.sampler, choice_);
  level.logarithm = decided_level(log2_of(level.row.scale_factor, choice_.log2), squared, 0,
                                  choice_.log2, LevelWeight::exact);
  level.lambda_prime = decided_level(biased(level.logarithm, lookup), squared, biased(0, lookup),
                                     choice_.log2, choice_.level_weight);
  if (is_anisotropic(use_.sampler, choice_))
    level.ways = ways_to(level.row, derivatives, choice_.anisotropy);
  return finished(std::move(level));
}

Interval TexturedPrimitive::Lookups::biased(Interval lambda_base, const Lookup& lookup) const {
  return with_bias(lambda_base, use_.sampler, lookup, choice_.bias);
}

Level TexturedPrimitive::Lookups::finished(Level level) const {
  const LevelRules rules{choice_.crossover, choice_.nearest_level, choice_.level_weight, false, 0};
  level.lambda = clamped(level.lambda_prime, limited_);
  level.accessed = accessed_level(level.lambda, use_.sampler, last_, rules);
  const LevelPicks picks = pick_levels(level.lambda, use_.sampler, last_, rules);
  level.borders = texel_borders(picks.at(0).filter, choice_.texel_grid, texture_.format);
  const auto add_sizes = [&](int number) {
    level.sizes[0].push_back(image(number).width);
    level.sizes[1].push_back(image(number).height);
  };
  for (const LevelPick& pick : picks) {
    add_sizes(pick.level);
    if (pick.next != pick.level) add_sizes(pick.next);
  }
  return level;
}

std::optional<Level> TexturedPrimitive::Lookups::given_level() const {
  const Lookup& lookup = use_.lookup;
  switch (lookup.kind) {
    case LookupKind::implicit:
    case LookupKind::bias:
      break;
    case LookupKind::lod: {
      Level level;
      level.footprint.dimensions = texture_.dimensions;
      level.lambda_prime = biased(static_cast<double>(lookup.value), lookup);
      return finished(level);
    }
    case LookupKind::gradients: {
      RationalFootprint given{rational_of(lookup.dx), rational_of(lookup.dy), texture_.dimensions};
      if (texture_.dimensions == 1) given.dx[1] = given.dy[1] = 0;
      return level_of(given, lookup);
    }
  }
  return std::nullopt;
}

const Level& TexturedPrimitive::Lookups::level_at(PixelPosition pixel) {
  return given_ ? *given_ : implicit_level(pixel, use_.lookup, level_);
}

// Without perspective all pixels have the level of the target's first pixel: the last digits of an
// interval must not depend on which pixel was queried first. Both coordinates share w.
const Level& TexturedPrimitive::Lookups::implicit_level(PixelPosition pixel, const Lookup& lookup,
                                                        std::optional<Level>& kept) {
  const bool differs = has_perspective(axes_.front().coordinate());
  if (!kept || differs) kept = computed_level(differs ? pixel : PixelPosition{}, lookup);
  return *kept;
}

Texel TexturedPrimitive::Lookups::color_at(const TexturePoint& point, const Level& level) const {
  return hull_of(
      sample(decoded_, texture_, use_.sampler, choice_, TextureSample{point, level.lambda}));
}

std::array<Interval, 2> TexturedPrimitive::Lookups::coordinates_at(PixelPosition pixel,
                                                                   Point sample) const {
  if (sample != pixel_centre(pixel.x, pixel.y))
    return {axes_[0].value(sample), axes_[1].value(sample)};
  return known_.at(number_, axes_[0].coordinate(), axes_[1].coordinate(), pixel);
}

Interval TexturedPrimitive::Lookups::place(std::size_t axis, const Place& at, const Level& level) {
  return axes_[axis].place(at.sample, at.coordinates[axis], level.borders, level.sizes_along(axis));
}

// A probe whose offset is unknown may lie anywhere.
TexturePoint TexturedPrimitive::Lookups::probe_point(const Place& at, const Level& level,
                                                     std::size_t probe) {
  if (level.ways.empty()) return {Interval::everything(), Interval::everything()};
  const std::array<Rational, 2>& way = level.ways[probe];
  const auto placed = [&](std::size_t axis) {
    return axes_[axis].place(at.sample, at.coordinates[axis], level.borders,
                             level.sizes_along(axis), way[axis]);
  };
  TexturePoint point;
  point.s = placed(0);
  if (texture_.dimensions == 2) point.t = placed(1);
  return point;
}

// Whether the lookup itself is the one that textureQueryLod describes.
bool TexturedPrimitive::Lookups::is_queried() const {
  return use_.lookup.kind == LookupKind::implicit;
}

QueriedLevel TexturedPrimitive::Lookups::queried(PixelPosition pixel) {
  return queried_part(is_queried() ? level_at(pixel) : implicit_level(pixel, Lookup{}, queried_));
}

ExactLookup TexturedPrimitive::Lookups::look_up(PixelPosition pixel) {
  const Point sample = attribute_place(primitive_, target_, coverage_, pixel);
  const Level& level = level_at(pixel);
  const Place at{sample, coordinates_at(pixel, sample)};
  ExactLookup result;
  result.coordinates = at.coordinates;
  result.point = {place(0, at, level), result.coordinates[1]};
  if (texture_.dimensions == 2) result.point.t = place(1, at, level);
  result.footprint = level.footprint;
  result.lambda_prime = level.lambda_prime;
  result.lambda = level.lambda;
  result.accessed = level.accessed;
  result.queried = is_queried() ? queried_part(level) : queried(pixel);
  if (level.row.probes.size() <= 1) {
    result.color = color_at(result.point, level);
    return result;
  }
  std::vector<Texel> colors;
  for (std::size_t i = 0; i < level.row.probes.size(); ++i)
    colors.push_back(color_at(probe_point(at, level, i), level));
  result.color = weighted(colors, level.row.probes);
  return result;
}

TexturedPrimitive::TexturedPrimitive(const TextureStage& stage, const ScenePrimitive& primitive,
                                     const PrimitiveAttributes& attributes)
    : lookups_(std::make_unique<Lookups>(stage, primitive, attributes)) {}
TexturedPrimitive::TexturedPrimitive(TexturedPrimitive&&) noexcept = default;
TexturedPrimitive& TexturedPrimitive::operator=(TexturedPrimitive&&) noexcept = default;
TexturedPrimitive::~TexturedPrimitive() = default;

ExactLookup TexturedPrimitive::look_up(PixelPosition pixel) {
  return lookups_->look_up(pixel);
}

QueriedLevel TexturedPrimitive::queried(PixelPosition pixel) {
  return lookups_->queried(pixel);
}

}  // namespace edgecase
