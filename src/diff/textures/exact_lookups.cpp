// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "diff/textures/texture_lookups.h"
#include "rules/textures/directed.h"
#include "rules/textures/texel_filter.h"

namespace edgecase {
namespace {

// True if lookups can be made in the chain, whatever its sizes.
bool is_chain(const std::vector<TextureLevel>& levels) {
  return !levels.empty() && std::ranges::all_of(levels, [](const TextureLevel& level) {
    return level.width > 0 && level.height > 0 &&
           level.texels.size() == level.index(0, level.height);
  });
}

// Of a fragment of the rendering; null if it has none.
std::optional<std::array<double, 2>> level_of(const Fragment& fragment,
                                              const Rendering& rendering) {
  if (fragment.detail < 0) return std::nullopt;
  return rendering.details[static_cast<std::size_t>(fragment.detail)].level_of_detail;
}

}  // namespace

ExactLookups::ExactLookups(const ValueContext& context, const Rendering& exact,
                           const Rendering& rendered)
    : context_(context),
      exact_(exact),
      drawn_(exact),
      rendered_(rendered),
      stage_(context.scene, context.choices),
      primitives_(context.primitives.size()) {
  for (const auto& [number, chain] : rendered.mip_chains) {
    const auto in_force = stage_.chains().find(number);
    if (in_force == stage_.chains().end() || in_force->second == chain || !is_chain(chain))
      continue;
    stage_.take_chains({{number, chain}});
    if (in_force->second == chain)
      changed_.insert(number);
    else
      own_[number] = decode(*context.scene.textures[number], chain);
  }
}

const DecodedTexture& ExactLookups::decoded(std::size_t texture) const {
  const auto own = own_.find(texture);
  return own == own_.end() ? stage_.decoded(texture) : own->second;
}

std::size_t ExactLookups::texture_of(const Fragment& fragment) const {
  return context_.primitive_of(fragment).state->texture->texture;
}

// The fragment of exact with the same lookup in the same texels; null if there is none.
const Fragment* ExactLookups::drawn(const Fragment& fragment) {
  return changed_.contains(texture_of(fragment)) ? nullptr : drawn_.find(fragment);
}

TexturedPrimitive& ExactLookups::primitive_of(const Fragment& fragment) {
  auto& primitive = primitives_[static_cast<std::size_t>(fragment.primitive)];
  if (!primitive)
    primitive = std::make_unique<TexturedPrimitive>(stage_, context_.primitive_of(fragment),
                                                    context_.values_of(fragment).chosen);
  return *primitive;
}

LookedUp ExactLookups::look_up(const Fragment& fragment) {
  const PixelPosition pixel{fragment.x, fragment.y};
  LookedUp result;
  const Fragment* const own = drawn(fragment);
  if (level_of(fragment, rendered_)) {
    const auto drawn_level = own != nullptr ? level_of(*own, exact_) : std::nullopt;
    if (drawn_level)
      result.level_of_detail = *drawn_level;
    else
      std::ranges::transform(primitive_of(fragment).queried(pixel), result.level_of_detail.begin(),
                             middle);
  }
  if (own != nullptr)
    result.color = own->color;
  else
    std::ranges::transform(primitive_of(fragment).look_up(pixel).color, result.color.begin(),
                           middle);
  return result;
}

// Boxes.

namespace {

bool range_has(Interval range, double number) {
  if (std::isnan(range.low) || std::isnan(range.high)) return true;
  if (std::isnan(number)) return std::isinf(range.low) && std::isinf(range.high);
  return rounded_to_float(range).contains(to_float(number));
}

}  // namespace

bool hold(const Boxes& boxes, const LookupNumbers& numbers) {
  return std::ranges::any_of(boxes, [&](const Box& box) {
    for (std::size_t c = 0; c < box.size(); ++c)
      if (!range_has(box[c], numbers[c])) return false;
    return true;
  });
}

std::string describe_range(const Boxes& boxes) {
  Box all = boxes.front();
  for (const Box& box : boxes)
    for (std::size_t c = 0; c < box.size(); ++c) all[c] = hull(all[c], box[c]);
  std::string text;
  for (const Interval range : all)
    text += fmt::format("{}{:.9g} to {:.9g}", text.empty() ? "" : ", ", range.low, range.high);
  return text;
}

// The permitted derivatives of texture coordinates (ruling 16).

// All differences within the fragment's quad: a part of what is permitted.
TextureLookups::Gradients TextureLookups::quad_gradients(const Fragment& fragment) {
  const Gradients lower = gradients_of(fragment, DerivativeMethod::coarse_bottom_left);
  const Gradients upper = gradients_of(fragment, DerivativeMethod::coarse_top_right);
  const auto both = [](const IntervalPair& a, const IntervalPair& b) {
    return IntervalPair{hull(a[0], b[0]), hull(a[1], b[1])};
  };
  return {both(lower.dx, upper.dx), both(lower.dy, upper.dy)};
}

TextureLookups::Gradients TextureLookups::permitted_gradients(const Fragment& fragment,
                                                              Reach reach) {
  if (reach == Reach::near && !context_.values_of(fragment).differ) return quad_gradients(fragment);
  auto& permitted = primitives_[static_cast<std::size_t>(fragment.primitive)];
  if (!permitted) {
    const PrimitiveValues& values = context_.values_of(fragment);
    permitted.emplace(std::span(values.lawful.color).first(2), values.reach);
  }
  const auto along = [&](Derivative derivative) {
    return IntervalPair{permitted->at({fragment.x, fragment.y}, derivative, 0),
                        permitted->at({fragment.x, fragment.y}, derivative, 1)};
  };
  return {along(Derivative::x), along(Derivative::y)};
}

// The texels of which a lookup may take a mean, and the permitted means (rulings 23 and 24).

// The last level that an anisotropic filter may access; it may take a mean of all its texels
// (ruling 23).
int TextureLookups::last_accessible(const Fragment& fragment) const {
  const TextureUse& use = use_of(fragment);
  if (use.sampler.mipmap == MipFilter::none) return use.sampler.base_level;
  return draw_of(fragment).last;
}

bool TextureLookups::has_levels_of_one_color(const Fragment& fragment) const {
  const TextureUse& use = use_of(fragment);
  const std::vector<DecodedLevel>& levels = draw_of(fragment).decoded->levels;
  const auto end = std::min(levels.size(), static_cast<std::size_t>(last_accessible(fragment)) + 1);
  for (auto level = static_cast<std::size_t>(use.sampler.base_level); level < end; ++level) {
    const std::vector<Texel>& texels = levels[level].texels;
    if (!std::ranges::all_of(texels, [&](const Texel& t) { return same_box(t, texels[0]); }))
      return false;
  }
  return true;
}

Texel TextureLookups::accessible_texels(const Fragment& fragment) const {
  const TextureUse& use = use_of(fragment);
  const DecodedTexture& decoded = *draw_of(fragment).decoded;
  const int last = last_accessible(fragment);
  const auto end = decoded.levels.size();
  std::vector<Texel> texels;
  for (auto level = static_cast<std::size_t>(use.sampler.base_level);
       level <= static_cast<std::size_t>(last) && level < end; ++level)
    texels.push_back(hull_of(decoded.levels[level].texels));
  const auto& wrap = use.sampler.wrap;
  const bool has_border = wrap[0] == Wrap::clamp_to_border ||
                          (decoded.dimensions == 2 && wrap[1] == Wrap::clamp_to_border);
  if (has_border) texels.push_back(decode_border(use.sampler.border, decoded.format));
  return hull_of(texels);
}

Boxes TextureLookups::overshooting_colors(const Fragment& fragment) {
  Boxes boxes = permitted_colors(fragment);
  for (Box& box : boxes)
    for (Interval& component : box) {
      const double range = component.high - component.low;
      component = known({component.low - range, component.high + range});
    }
  return boxes;
}

// What the texels of a generated chain that the renderer does not report may be: a component that
// is the same in all of level 0 stays so, to a code of 8 bits or a part of 10^5 (ruling 25), and no
// filter leaves the format's range. A code of sRGB is at most 2.3 codes of what it stands for.
Texel TextureLookups::texels_of_unknown_chain(const Fragment& fragment) const {
  const OfDraw& draw = draw_of(fragment);
  const TextureFormat format = draw.texture->format;
  const double code = (format == TextureFormat::srgb8 ? 2.3 : 1.0) / 255;
  const std::vector<Texel>& given = draw.decoded->levels.front().texels;
  Texel texels = given.front();
  for (std::size_t c = 0; c < texels.size(); ++c) {
    const bool is_constant = std::ranges::all_of(given, [&](const Texel& texel) {
      return texel[c].low == texels[c].low && texel[c].high == texels[c].high;
    });
    const double error = holds_floats(format) ? texels[c].magnitude() * 1e-5 : code;
    if (is_constant)
      texels[c] = known({texels[c].low - error, texels[c].high + error});
    else
      texels[c] = holds_floats(format) ? Interval::everything() : Interval(0, 1);
  }
  const auto& wrap = draw.use->sampler.wrap;
  if (std::ranges::find(wrap, Wrap::clamp_to_border) == wrap.end()) return texels;
  const Texel border = decode_border(draw.use->sampler.border, format);
  for (std::size_t c = 0; c < texels.size(); ++c) texels[c] = hull(texels[c], border[c]);
  return texels;
}

// sRGB texels may be decoded before or after they are filtered (ruling 24).
Texels TextureLookups::permitted_samples(const Fragment& fragment, Reach reach) {
  const TextureUse& use = use_of(fragment);
  const Texture& texture = texture_of(fragment);
  const TextureChoice lawful;
  const TextureSample at{point_of(fragment, context_.values_of(fragment).lawful, kLookupError),
                         permitted_lookup_lambda(fragment, reach)};
  // The weight has the error of lambda, except where lambda is clamped (ruling 22).
  const bool is_clamped = at.lambda.low <= static_cast<double>(use.sampler.min_lod) ||
                          at.lambda.high >= static_cast<double>(use.sampler.max_lod);
  const SamplerPrecision precision = precision_within(reach);
  SampleLatitude latitude{precision.texel, is_clamped ? precision.level : 0, true,
                          SrgbDecoding::of_texels};
  Texels colors = sample(*draw_of(fragment).decoded, texture, use.sampler, lawful, at, latitude);
  if (texture.format != TextureFormat::srgb8) return colors;
  auto coded = srgb_.find(use.texture);
  if (coded == srgb_.end())
    coded = srgb_.emplace(use.texture, srgb_coded(*draw_of(fragment).decoded)).first;
  Sampler sampler = use.sampler;
  for (std::size_t c = 0; c < 3; ++c)
    sampler.border[c] = static_cast<float>(linear_to_srgb_number(double{sampler.border[c]}));
  for (const SrgbDecoding decoding : {SrgbDecoding::of_levels, SrgbDecoding::at_last}) {
    latitude.decoding = decoding;
    for (const Texel& color : sample(coded->second, texture, sampler, lawful, at, latitude))
      colors.push_back(color);
  }
  return colors;
}

}  // namespace edgecase
