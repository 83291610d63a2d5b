// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "raster/texture_axis.h"
#include "raster/texture_level.h"
#include "raster/texture_stage.h"

namespace edgecase {
namespace {

// Are intervals as narrow as double precision makes them?
bool is_narrow(Interval scale_factor) {
  return scale_factor.high - scale_factor.low <= scale_factor.high * 0x1p-30;
}

using RationalPair = std::array<Rational, 2>;

RationalPair rational_of(const std::array<float, 2>& vector) {
  return {edgecase::rational_of(vector[0]), edgecase::rational_of(vector[1])};
}

// What a lookup takes, beside the point.
struct Level {
  Footprint footprint;
  ProbeRow row{true, {}, {{0, 1}}};
  // From the centre to each probe, in s and t; empty where there is one probe alone.
  std::vector<std::array<Rational, 2>> ways;
  Interval lambda_prime;
  Interval lambda;
  Interval accessed;
  TexelBorders borders;  // of the filter within levels
  bool is_open = false;  // does an interval touch a border between two answers?
};

Texel weighted(const std::vector<Texel>& colors, const std::vector<Probe>& probes) {
  bool is_one = true;
  for (const Texel& color : colors) is_one = is_one && same_box(color, colors[0]);
  if (is_one) return colors[0];
  Texel sum;
  for (std::size_t i = 0; i < colors.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) sum[c] = sum[c] + probes[i].weight * colors[i][c];
  return sum;
}

}  // namespace

class TexturedPrimitive::Lookups {
 public:
  Lookups(const TextureStage& stage, const ScenePrimitive& primitive,
          const PrimitiveAttributes& attributes);
  ExactLookup look_up(PixelPosition pixel);

 private:
  TextureAxis axis_of(std::size_t axis, const Interpolant& coordinate) const;
  const Level& level_at(PixelPosition pixel);
  const Level& queried_level_at(PixelPosition pixel);
  Level implicit_level(PixelPosition pixel, const Lookup& lookup);
  Level level_of(const Footprint& footprint, const Lookup& lookup) const;
  Level level_of(const RationalFootprint& derivatives, const Lookup& lookup) const;
  Interval biased(Interval lambda_base, const Lookup& lookup) const;
  Level finished(Level level) const;
  Footprint footprint_at(const QuadPixel& at) const;
  std::optional<RationalFootprint> derivatives_at(const QuadPixel& at);
  Texel color_at(const TexturePoint& point, const Level& level) const;
  TexturePoint probe_point(Point sample, const Level& level, std::size_t probe);
  RationalFootprint texels(const RationalFootprint& derivatives) const;
  const DecodedLevel& base() const {
    return decoded_.levels[static_cast<std::size_t>(std::min(use_.sampler.base_level, last_))];
  }
  // One level of detail for all pixels of a kind of lookup?
  bool is_level_shared(LookupKind kind) const;

  const TextureChoice& choice_;
  const ValueChoice& values_;
  const Target& target_;
  const TextureUse& use_;
  const Texture& texture_;
  const DecodedTexture& decoded_;
  int last_;
  std::array<TextureAxis, 2> axes_;
  std::optional<Level> level_;
  std::optional<Level> queried_;
};

TexturedPrimitive::Lookups::Lookups(const TextureStage& stage, const ScenePrimitive& primitive,
                                    const PrimitiveAttributes& attributes)
    : choice_(stage.choices().textures),
      values_(stage.choices().values),
      target_(stage.scene().target),
      use_(*primitive.state->texture),
      texture_(*stage.scene().textures.at(use_.texture)),
      decoded_(stage.decoded(use_.texture)),
      last_(last_level_of(decoded_, use_.sampler, texture_)),
      axes_{axis_of(0, attributes.color[0]), axis_of(1, attributes.color[1])} {}

TextureAxis TexturedPrimitive::Lookups::axis_of(std::size_t axis,
                                                const Interpolant& coordinate) const {
  std::vector<int> sizes;
  for (int level = std::min(use_.sampler.base_level, last_); level <= last_; ++level) {
    const DecodedLevel& image = decoded_.levels[static_cast<std::size_t>(level)];
    sizes.push_back(axis == 0 ? image.width : image.height);
  }
  return {coordinate, use_.sampler.wrap[axis], sizes};
}

bool TexturedPrimitive::Lookups::is_level_shared(LookupKind kind) const {
  if (kind == LookupKind::lod || kind == LookupKind::gradients) return true;
  return !has_perspective(axes_[0].coordinate()) && !has_perspective(axes_[1].coordinate());
}

RationalFootprint TexturedPrimitive::Lookups::texels(const RationalFootprint& derivatives) const {
  return in_texels(derivatives, base().width, base().height);
}

Footprint TexturedPrimitive::Lookups::footprint_at(const QuadPixel& at) const {
  const auto along = [&](Axis axis) {
    return std::array{derivative_exact(axes_[0].coordinate(), at, axis, choice_.derivatives),
                      derivative_exact(axes_[1].coordinate(), at, axis, choice_.derivatives)};
  };
  return footprint(along(Axis::x), along(Axis::y), base().width, base().height,
                   texture_.dimensions);
}

std::optional<RationalFootprint> TexturedPrimitive::Lookups::derivatives_at(const QuadPixel& at) {
  RationalFootprint result;
  result.dimensions = texture_.dimensions;
  for (std::size_t c = 0; c < static_cast<std::size_t>(texture_.dimensions); ++c) {
    const auto x = axes_[c].derivative(at, Axis::x, choice_.derivatives);
    const auto y = axes_[c].derivative(at, Axis::y, choice_.derivatives);
    if (!x || !y) return std::nullopt;
    result.dx[c] = *x;
    result.dy[c] = *y;
  }
  return result;
}

// Intervals first; quotients where these leave a question open.
Level TexturedPrimitive::Lookups::implicit_level(PixelPosition pixel, const Lookup& lookup) {
  const QuadPixel at = quad_of(pixel, values_, target_);
  const Footprint narrow = footprint_at(at);
  const bool is_enough = !is_anisotropic(use_.sampler, choice_) &&
                         is_narrow(scale_factor(narrow, choice_.scale_factor));
  const Level level = level_of(narrow, lookup);
  if (is_enough && !level.is_open) return level;
  const std::optional<RationalFootprint> exact = derivatives_at(at);
  return exact ? level_of(*exact, lookup) : level;
}

Level TexturedPrimitive::Lookups::level_of(const Footprint& footprint, const Lookup& lookup) const {
  Level level;
  level.footprint = footprint;
  level.row =
      probes(footprint, use_.sampler.max_anisotropy, choice_.anisotropy, choice_.scale_factor);
  const Interval logarithm = log2_of(level.row.scale_factor, choice_.log2);
  level.lambda_prime = biased(logarithm, lookup);
  level.is_open = is_level_open(logarithm, LevelWeight::exact) ||
                  is_level_open(level.lambda_prime, choice_.level_weight);
  return finished(level);
}

// The logarithm is decided before and after the bias is added: multiples of 1/2 become what they
// are, and the sum's rounding moves no number onto a border.
Level TexturedPrimitive::Lookups::level_of(const RationalFootprint& derivatives,
                                           const Lookup& lookup) const {
  const RationalFootprint in_base = texels(derivatives);
  Level level;
  level.footprint = intervals_of(in_base);
  level.row = exact_probes(in_base, use_.sampler, choice_);
  const Rational squared = squared_scale_factor(in_base, level.row, use_.sampler, choice_);
  const Interval logarithm = decided_level(log2_of(level.row.scale_factor, choice_.log2), squared,
                                           0, choice_.log2, LevelWeight::exact);
  level.lambda_prime = decided_level(biased(logarithm, lookup), squared, biased(0, lookup),
                                     choice_.log2, choice_.level_weight);
  if (level.row.probes.size() > 1) level.ways = ways_to(level.row, derivatives, choice_.anisotropy);
  return finished(level);
}

Interval TexturedPrimitive::Lookups::biased(Interval lambda_base, const Lookup& lookup) const {
  return with_bias(lambda_base, use_.sampler, lookup, choice_.bias);
}

Level TexturedPrimitive::Lookups::finished(Level level) const {
  const LevelRules rules{choice_.crossover, choice_.nearest_level, choice_.level_weight, false, 0};
  level.lambda = clamped(level.lambda_prime, use_.sampler);
  level.accessed = accessed_level(level.lambda, use_.sampler, last_, rules);
  const std::vector<LevelPick> picks = pick_levels(level.lambda, use_.sampler, last_, rules);
  level.borders = texel_borders(picks.at(0).filter, choice_.texel_grid, texture_.format);
  return level;
}

const Level& TexturedPrimitive::Lookups::level_at(PixelPosition pixel) {
  const Lookup& lookup = use_.lookup;
  if (level_ && is_level_shared(lookup.kind)) return *level_;
  if (lookup.kind == LookupKind::lod) {
    Level level;
    level.footprint.dimensions = texture_.dimensions;
    level.lambda_prime = biased(static_cast<double>(lookup.value), lookup);
    level_ = finished(level);
  } else if (lookup.kind == LookupKind::gradients) {
    RationalFootprint given{rational_of(lookup.dx), rational_of(lookup.dy), texture_.dimensions};
    if (texture_.dimensions == 1) given.dx[1] = given.dy[1] = 0;
    level_ = level_of(given, lookup);
  } else {
    level_ = implicit_level(pixel, lookup);
  }
  return *level_;
}

const Level& TexturedPrimitive::Lookups::queried_level_at(PixelPosition pixel) {
  const Lookup plain;
  if (!queried_ || !is_level_shared(plain.kind)) queried_ = implicit_level(pixel, plain);
  return *queried_;
}

Texel TexturedPrimitive::Lookups::color_at(const TexturePoint& point, const Level& level) const {
  return hull_of(
      sample(decoded_, texture_, use_.sampler, choice_, TextureSample{point, level.lambda}));
}

// Without a way to a probe nothing is known of where it lies.
TexturePoint TexturedPrimitive::Lookups::probe_point(Point sample, const Level& level,
                                                     std::size_t probe) {
  if (level.ways.empty()) return {Interval::everything(), Interval::everything()};
  const std::array<Rational, 2>& way = level.ways[probe];
  TexturePoint point{axes_[0].place(sample, level.borders, way[0]), 0};
  if (texture_.dimensions == 2) point.t = axes_[1].place(sample, level.borders, way[1]);
  return point;
}

ExactLookup TexturedPrimitive::Lookups::look_up(PixelPosition pixel) {
  const Point sample = pixel_centre(pixel.x, pixel.y);
  const Level& level = level_at(pixel);
  ExactLookup result;
  result.coordinates = {axes_[0].value(sample), axes_[1].value(sample)};
  result.point = {axes_[0].place(sample, level.borders), result.coordinates[1]};
  if (texture_.dimensions == 2) result.point.t = axes_[1].place(sample, level.borders);
  result.footprint = level.footprint;
  result.lambda_prime = level.lambda_prime;
  result.lambda = level.lambda;
  result.accessed = level.accessed;
  const bool is_plain = use_.lookup.kind == LookupKind::implicit;
  const Level& queried = is_plain ? level : queried_level_at(pixel);
  result.queried = {queried.accessed, queried.lambda_prime};
  if (level.row.probes.size() <= 1) {
    result.color = color_at(result.point, level);
    return result;
  }
  std::vector<Texel> colors;
  for (std::size_t i = 0; i < level.row.probes.size(); ++i)
    colors.push_back(color_at(probe_point(sample, level, i), level));
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

}  // namespace edgecase
