// SPDX-License-Identifier: MIT
#include "diff/textures/texture_lookups.h"

#include <algorithm>
#include <cmath>

#include "diff/values/value_judge.h"
#include "raster/texture_level.h"
#include "rules/textures/directed.h"
#include "rules/textures/texel_filter.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {
namespace {

// The error of multiplying by a texture's size and of wrapping, in float32.
constexpr double kFloat32 = 0x1p-22;
// The logarithm of 0 is no number: any level stands for it that no bias turns into minification.
constexpr double kLogarithmOfZero = -16;
// The error in decoding an sRGB texel that ruling 53 contests.
constexpr double kContestedSrgb = 0.005;

// The largest finite number of a texture.
double magnitude_of(const DecodedTexture& texture) {
  double largest = 0;
  for (const DecodedLevel& level : texture.levels)
    for (const Texel& texel : level.texels)
      for (const Interval component : texel)
        if (std::isfinite(component.low) && std::isfinite(component.high))
          largest = std::max(largest, component.magnitude());
  return largest;
}

// Everything if the point may be anywhere: a coordinate that is NaN is unknown.
Interval near(double coordinate, double error) {
  return std::isfinite(coordinate) ? widened(coordinate, error) : Interval::everything();
}

Interval within(Interval value, double margin) {
  return known({value.low - margin, value.high + margin});
}

Texel anything() {
  Texel all;
  all.fill(Interval::everything());
  return all;
}

// The largest finite number that may enter the mean of a lookup.
double largest_of(const Sampler& sampler, const DecodedTexture& decoded) {
  double largest = magnitude_of(decoded);
  for (const float component : sampler.border)
    if (std::isfinite(component)) largest = std::max(largest, std::fabs(double{component}));
  return largest;
}

LevelRules rules_of(const TextureChoice& choice) {
  return {choice.crossover, choice.nearest_level, choice.level_weight};
}

// lambda_base. Each end errs by a part of itself: an infinite end says nothing about the other.
Interval logarithm_of(Interval scale, Log2Method method) {
  const Interval exact = log2_of(widened(scale, kLookupError), method);
  return {widened(exact.low, kLookupError).low, widened(exact.high, kLookupError).high};
}

}  // namespace

SamplerPrecision TextureLookups::precision_within(Reach reach) {
  return reach == Reach::coarse ? kContestedPrecision : kPermittedPrecision;
}

TextureLookups::TextureLookups(const ValueContext& context, const Rendering& exact,
                               const Rendering& rendered)
    : context_(context),
      rendered_(rendered),
      exact_(context, exact, rendered),
      primitives_(context.primitives.size()),
      inexact_(context.scene.target.width),
      places_(rendered.fragments.size()) {
  for (const Draw& draw : context.scene.draws)
    draws_.push_back(draw.texture ? of_draw(draw) : OfDraw());
}

TextureLookups::OfDraw TextureLookups::of_draw(const Draw& draw) const {
  const Sampler& sampler = draw.texture->sampler;
  const Texture& texture = *context_.scene.textures[draw.texture->texture];
  const DecodedTexture& decoded = exact_.decoded(draw.texture->texture);
  const int means = holds_floats(texture.format) ? 0 : means_of(sampler, texture);
  return {&*draw.texture,
          &texture,
          &decoded,
          last_level_of(decoded, sampler, texture),
          largest_of(sampler, decoded) * kLookupError * operations_of(sampler, texture),
          means * 0.5 / 255};
}

TextureLookups::OfFragment& TextureLookups::kept_of(const Fragment& fragment) {
  std::uint32_t& place = places_[static_cast<std::size_t>(&fragment - rendered_.fragments.data())];
  if (place == 0 && free_.empty()) {
    kept_.emplace_back();
    place = static_cast<std::uint32_t>(kept_.size());
  } else if (place == 0) {
    place = free_.back();
    free_.pop_back();
  }
  return kept_[place - 1];
}

void TextureLookups::forget(const Fragment& fragment) {
  std::uint32_t& place = places_[static_cast<std::size_t>(&fragment - rendered_.fragments.data())];
  if (place == 0) return;
  kept_[place - 1].gradients.clear();
  free_.push_back(place);
  place = 0;
}

const FragmentDetail* TextureLookups::detail_of(const Fragment& fragment) const {
  if (fragment.detail < 0) return nullptr;
  return &rendered_.details[static_cast<std::size_t>(fragment.detail)];
}

LookupKinship TextureLookups::kinship_of(const Fragment& fragment, bool is_query) const {
  const bool is_flat = context_.primitive_of(fragment).state->interpolation == Interpolation::flat;
  const auto& color = context_.values_of(fragment).chosen.color;
  return {&use_of(fragment), &texture_of(fragment),
          !is_flat && (has_perspective(color[0]) || has_perspective(color[1])), is_query};
}

Footprint TextureLookups::footprint_of(const Fragment& fragment, const Gradients& along) const {
  const Texture& texture = texture_of(fragment);
  const int base = use_of(fragment).sampler.base_level;
  const TextureLevel& level = texture.levels.front();
  return footprint(along.dx, along.dy, level_size(level.width, base),
                   level_size(level.height, base), texture.dimensions);
}

Interval TextureLookups::permitted_scale(const Footprint& footprint) const {
  return permitted_scale_factor(footprint, context_.lookup_limits());
}

TextureLookups::Gradients TextureLookups::gradients_of(const Fragment& fragment,
                                                       DerivativeMethod method) {
  auto& known_gradients = kept_of(fragment).gradients;
  for (const auto& [of_method, gradients] : known_gradients)
    if (of_method == method) return gradients;
  const auto& color = context_.values_of(fragment).chosen.color;
  const QuadPixel at =
      quad_of({fragment.x, fragment.y}, context_.choices.values, context_.scene.target);
  const auto along = [&](Axis axis) {
    return inexact_.derivatives(fragment.primitive, color[0], color[1], at, axis, method);
  };
  known_gradients.emplace_back(method, Gradients{along(Axis::x), along(Axis::y)});
  return known_gradients.back().second;
}

bool TextureLookups::reports_level(const Fragment& fragment) const {
  const TextureUse& use = use_of(fragment);
  return use.lookup.kind == LookupKind::implicit && !(use.sampler.max_anisotropy > 1) &&
         reported_lambda(fragment).has_value();
}

// The gradients of a lookup with explicit derivatives.
TextureLookups::Gradients TextureLookups::asked_gradients(const Fragment& fragment) const {
  const auto exactly = [](const std::array<float, 2>& vector) {
    return IntervalPair{static_cast<double>(vector[0]), static_cast<double>(vector[1])};
  };
  const Lookup& lookup = use_of(fragment).lookup;
  return {exactly(lookup.dx), exactly(lookup.dy)};
}

// The gradients of the draw's own lookup, which may have an explicit level instead.
TextureLookups::Gradients TextureLookups::lookup_gradients(const Fragment& fragment,
                                                           DerivativeMethod method) {
  const LookupKind kind = use_of(fragment).lookup.kind;
  if (kind == LookupKind::gradients) return asked_gradients(fragment);
  return kind == LookupKind::lod ? Gradients{} : gradients_of(fragment, method);
}

// One box; for a nearest level, which is a whole number, one for each level that lambda' permits.
Boxes TextureLookups::level_boxes(const Fragment& fragment, Interval lambda_prime,
                                  const LevelRules& rules, LevelLimits limits) const {
  const Sampler sampler = limited(use_of(fragment).sampler, limits);
  const int last = last_level_of(*draw_of(fragment).decoded, sampler, texture_of(fragment));
  const Interval accessed = accessed_level(clamped(lambda_prime, sampler), sampler, last, rules);
  if (sampler.mipmap != MipFilter::nearest) return {Box{accessed, lambda_prime}};
  Boxes boxes;
  for (double level = accessed.low; level <= accessed.high; ++level)
    boxes.push_back(Box{level, lambda_prime});
  return boxes;
}

Boxes TextureLookups::levels(const Fragment& fragment, const TextureChoice& choice) {
  const Sampler& sampler = use_of(fragment).sampler;
  const ProbeRow row = probes(footprint_of(fragment, gradients_of(fragment, choice.derivatives)),
                              sampler.max_anisotropy, choice.anisotropy, choice.scale_factor);
  return level_boxes(
      fragment, with_bias(logarithm_of(row.scale_factor, choice.log2), sampler, {}, choice.bias),
      rules_of(choice), choice.limits);
}

bool TextureLookups::is_definite(const Fragment& fragment, const TextureChoice& choice,
                                 bool is_query) {
  if (!is_query && use_of(fragment).lookup.kind == LookupKind::lod) return true;
  const Gradients gradients = is_query ? gradients_of(fragment, choice.derivatives)
                                       : lookup_gradients(fragment, choice.derivatives);
  const Interval scale = scale_factor(footprint_of(fragment, gradients), choice.scale_factor);
  if (scale.low > 0 || scale.high <= 0) return true;
  // The logarithm of 0 permits no level but its own.
  if (const auto reported = reported_lambda(fragment); !reported || std::isfinite(reported->low))
    return false;
  const QuadPixel at =
      quad_of({fragment.x, fragment.y}, context_.choices.values, context_.scene.target);
  const auto& color = context_.values_of(fragment).chosen.color;
  return has_no_extent({color[0], color[1]}, at, texture_of(fragment).dimensions, choice);
}

Interval TextureLookups::permitted_lambda(const Fragment& fragment, Reach reach) {
  const Sampler& sampler = use_of(fragment).sampler;
  if (sampler.max_anisotropy > 1) return Interval::everything();  // ruling 23
  const Interval scale =
      permitted_scale(footprint_of(fragment, permitted_gradients(fragment, reach)));
  Interval base = logarithm_of(scale, Log2Method::exact);
  if (scale.low <= 0) base.high = std::max(base.high, kLogarithmOfZero);  // ruling 20
  return within(with_permitted_bias(base, sampler, {}, context_.lookup_limits()),
                precision_within(reach).level);
}

Boxes TextureLookups::permitted_levels(const Fragment& fragment, Reach reach) {
  const TextureUse& use = use_of(fragment);
  if (use.sampler.max_anisotropy > 1) {
    // An anisotropic filter may access any of these levels, and no other (ruling 23).
    const int last = last_accessible(fragment) - use.sampler.base_level;
    return {Box{Interval(0, std::max(last, 0)), Interval::everything()}};
  }
  LevelRules rules;
  rules.any_tie = true;
  const Interval band = permitted_lambda(fragment, reach);
  // A lambda' beyond the band is not permitted itself, and says nothing of the level.
  Interval lambda = reported_lambda(fragment).value_or(band);
  if (lambda.low > band.high || lambda.high < band.low) lambda = band;
  Boxes boxes = level_boxes(fragment, within(lambda, precision_within(reach).level), rules);
  for (Box& box : boxes) box[1] = band;
  return boxes;
}

// lambda' as the renderer reports it: its level must fit somewhere in this band.
std::optional<Interval> TextureLookups::reported_lambda(const Fragment& fragment) const {
  const FragmentDetail* detail = detail_of(fragment);
  if (detail == nullptr || !detail->level_of_detail) return std::nullopt;
  const double reported = (*detail->level_of_detail)[1];
  // The logarithm of 0 is a level, too: the least of all.
  if (std::isinf(reported) && reported < 0) return Interval(reported);
  if (!std::isfinite(reported)) return std::nullopt;
  return edgecase::widened(reported, kLookupError);
}

TexturePoint TextureLookups::point_of(const Fragment& fragment,
                                      const PrimitiveAttributes& attributes, double error) const {
  const FragmentDetail* detail = detail_of(fragment);
  if (detail != nullptr && detail->texture_coordinates)
    return {near((*detail->texture_coordinates)[0], error),
            near((*detail->texture_coordinates)[1], error)};
  const MovedVertices vertices(attributes.color[0], context_.values_of(fragment).reach);
  const Point centre = pixel_centre(fragment.x, fragment.y);
  const PermittedPlace place(vertices, centre);
  const Fixed half = Fixed::from_raw(
      height_of_column(context_.primitive_of(fragment), context_.scene.target).raw() / 2);
  return {permitted_across(attributes.color[0], vertices, place, centre, half),
          permitted_across(attributes.color[1], vertices, place, centre, half)};
}

// lambda of the draw's own lookup, clamped.
Interval TextureLookups::lookup_lambda(const Fragment& fragment, Interval scale,
                                       const TextureChoice& choice) const {
  const TextureUse& use = use_of(fragment);
  const Interval base = use.lookup.kind == LookupKind::lod
                            ? Interval(static_cast<double>(use.lookup.value))
                            : logarithm_of(scale, choice.log2);
  return clamped(with_bias(base, use.sampler, use.lookup, choice.bias),
                 limited(use.sampler, choice.limits));
}

// The permitted lambda. If the renderer reports the level of such a lookup, the lookup uses that
// level, and whether it is permitted is judged separately.
Interval TextureLookups::permitted_lookup_lambda(const Fragment& fragment, Reach reach) {
  const TextureUse& use = use_of(fragment);
  const double error = precision_within(reach).level;
  if (reports_level(fragment))
    return clamped(within(*reported_lambda(fragment), error), use.sampler);
  const auto biased = [&](Interval base) {
    const LookupLimits limits = context_.lookup_limits();
    return clamped(within(with_permitted_bias(base, use.sampler, use.lookup, limits), error),
                   use.sampler);
  };
  Interval scale;
  switch (use.lookup.kind) {
    case LookupKind::implicit:
    case LookupKind::bias:
      if (shows_level(kinship_of(fragment, false)))
        scale = permitted_scale(footprint_of(fragment, permitted_gradients(fragment, reach)));
      break;
    case LookupKind::lod:
      return biased(static_cast<double>(use.lookup.value));
    case LookupKind::gradients:
      scale = permitted_scale(footprint_of(fragment, asked_gradients(fragment)));
      break;
  }
  return biased(logarithm_of(scale, Log2Method::exact));
}

Boxes TextureLookups::widened(const Fragment& fragment, const Texels& colors, bool rounding,
                              double of_srgb) const {
  const OfDraw& draw = draw_of(fragment);
  const double margin = draw.margin + (rounding ? draw.codes : 0);
  Boxes boxes;
  for (const Texel& color : colors) {
    Box& box = boxes.emplace_back();
    for (const Interval component : color) box.push_back(within(component, margin));
    if (draw.texture->format == TextureFormat::srgb8)
      for (std::size_t c = 0; c < 3; ++c) box[c] = within(box[c], of_srgb);
  }
  return boxes;
}

Texel TextureLookups::weighted_probes(const Fragment& fragment, const TextureChoice& choice,
                                      const Gradients& gradients, const ProbeRow& row) const {
  const TextureUse& use = use_of(fragment);
  const TexturePoint centre = point_of(fragment, context_.values_of(fragment).chosen, kFloat32);
  const IntervalPair& along = row.along_x ? gradients.dx : gradients.dy;
  const Interval lambda = lookup_lambda(fragment, row.scale_factor, choice);
  Texel sum;
  for (const Probe& probe : row.probes) {
    const TexturePoint point{centre.s + Interval(probe.offset) * along[0],
                             centre.t + Interval(probe.offset) * along[1]};
    const Texel color = hull_of(sample(*draw_of(fragment).decoded, texture_of(fragment),
                                       use.sampler, choice, {point, lambda}));
    for (std::size_t c = 0; c < 4; ++c) sum[c] = sum[c] + probe.weight * color[c];
  }
  return sum;
}

Texels TextureLookups::colors_at_reported_level(const Fragment& fragment,
                                                const TextureChoice& choice) const {
  const TextureUse& use = use_of(fragment);
  return sample(*draw_of(fragment).decoded, texture_of(fragment), use.sampler, choice,
                {point_of(fragment, context_.values_of(fragment).chosen, kFloat32),
                 clamped(*reported_lambda(fragment), limited(use.sampler, choice.limits))});
}

Texels TextureLookups::probed_colors(const Fragment& fragment, const TextureChoice& choice) {
  const TextureUse& use = use_of(fragment);
  const LookupKinship kin = kinship_of(fragment, false);
  ProbeRow row;
  Gradients gradients;
  if (use.lookup.kind != LookupKind::lod && (shows_level(kin) || use.sampler.max_anisotropy > 1)) {
    gradients = lookup_gradients(fragment, choice.derivatives);
    row = probes(footprint_of(fragment, gradients), use.sampler.max_anisotropy, choice.anisotropy,
                 choice.scale_factor);
  }
  if (row.probes.size() > 1) return {weighted_probes(fragment, choice, gradients, row)};
  return sample(*draw_of(fragment).decoded, texture_of(fragment), use.sampler, choice,
                {point_of(fragment, context_.values_of(fragment).chosen, kFloat32),
                 lookup_lambda(fragment, row.scale_factor, choice)});
}

// True if the renderer reports NaN as the coordinates. No mean of texels is defined there.
bool TextureLookups::has_unknown_coordinates(const Fragment& fragment) const {
  const FragmentDetail* detail = detail_of(fragment);
  if (detail == nullptr || !detail->texture_coordinates ||
      !has_linear_filter(use_of(fragment).sampler))
    return false;
  const auto& [s, t] = *detail->texture_coordinates;
  return (!std::isfinite(s) || (texture_of(fragment).dimensions == 2 && !std::isfinite(t)));
}

bool TextureLookups::has_unknown_chain(const Fragment& fragment) const {
  const Sampler& sampler = use_of(fragment).sampler;
  const bool is_given_alone = sampler.mipmap == MipFilter::none && sampler.base_level == 0;
  return texture_of(fragment).generated && !is_given_alone &&
         !rendered_.mip_chains.contains(use_of(fragment).texture);
}

Texels TextureLookups::colors(const Fragment& fragment, const TextureChoice& choice,
                              bool as_reported) {
  if (has_unknown_coordinates(fragment)) return {anything()};
  return as_reported ? colors_at_reported_level(fragment, choice) : probed_colors(fragment, choice);
}

Boxes TextureLookups::permitted_colors(const Fragment& fragment, Reach reach) {
  if (has_unknown_coordinates(fragment)) return widened(fragment, {anything()}, true);
  if (has_unknown_chain(fragment))
    return widened(fragment, {texels_of_unknown_chain(fragment)}, true);
  const double of_srgb = reach == Reach::coarse_srgb ? kContestedSrgb : 0;
  if (use_of(fragment).sampler.max_anisotropy > 1)
    return widened(fragment, {accessible_texels(fragment)}, true, of_srgb);
  return widened(fragment, permitted_samples(fragment, reach), true, of_srgb);
}

}  // namespace edgecase
