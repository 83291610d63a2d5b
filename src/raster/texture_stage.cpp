// SPDX-License-Identifier: MIT
#include "raster/texture_stage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "rules/textures/directed.h"

namespace edgecase {

namespace {

void add(Texels& boxes, const Texel& box) {
  for (const Texel& known : boxes)
    if (same_box(known, box)) return;
  boxes.push_back(box);
}

// (1 - weight) a + weight b, rounded in the direction of `Rounding`: down or up.
template <class Rounding>
double mean(double a, double b, double weight) {
  const auto with = [&](double rest) {
    return Rounding::sum(Rounding::product(rest, a), Rounding::product(weight, b));
  };
  const double low = with(Down::sum(1, -weight)), high = with(Up::sum(1, -weight));
  return std::is_same_v<Rounding, Down> ? std::min(low, high) : std::max(low, high);
}

// The mean grows with a and with b and is linear in the weight, so its values at the ends bound it.
// It always lies between a and b.
Interval mixed(Interval a, Interval b, Interval weight) {
  const Interval between = hull(a, b);
  // The mean of infinities with opposite signs is undefined: it may be anything between them.
  const auto at = [&](double w) {
    return known({mean<Down>(a.low, b.low, w), mean<Up>(a.high, b.high, w)});
  };
  const Interval means = hull(at(weight.low), at(weight.high));
  return {std::max(means.low, between.low), std::min(means.high, between.high)};
}

// The colours of one choice of levels.
class PickedColors {
 public:
  PickedColors(const DecodedTexture& decoded, const TexelLookup& lookup, const TexturePoint& point,
               SrgbDecoding decoding)
      : decoded_(decoded), lookup_(lookup), point_(point), decoding_(decoding) {}

  void collect(const LevelPick& pick, Texels& boxes) const {
    const Texels first = colors(pick, pick.level);
    if (pick.next == pick.level)
      for (const Texel& color : first) add(boxes, color);
    else
      add_mixed(first, colors(pick, pick.next), pick.weight, boxes);
  }

 private:
  static void add_mixed(const Texels& first, Texels second, Interval weight, Texels& boxes) {
    constexpr std::size_t kManyPairs = 1000;
    if (first.size() * second.size() > kManyPairs) second = {hull_of(second)};
    for (const Texel& a : first)
      for (const Texel& b : second) add(boxes, mixed(a, b, weight));
  }

  Texels colors(const LevelPick& pick, int level) const {
    const auto at = std::min(static_cast<std::size_t>(level), decoded_.levels.size() - 1);
    Texels boxes = filter_level(decoded_.levels[at], decoded_.dimensions, decoded_.format,
                                pick.filter, point_, lookup_);
    if (decoding_ == SrgbDecoding::of_levels)
      for (Texel& box : boxes) box = srgb_decoded(box);
    return boxes;
  }

  const DecodedTexture& decoded_;
  const TexelLookup& lookup_;
  const TexturePoint& point_;
  const SrgbDecoding decoding_;
};

}  // namespace

bool same_box(const Texel& a, const Texel& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](Interval left, Interval right) {
    return left.low == right.low && left.high == right.high;
  });
}

Texel mixed(const Texel& a, const Texel& b, Interval weight) {
  Texel result;
  for (std::size_t c = 0; c < 4; ++c) result[c] = mixed(a[c], b[c], weight);
  return result;
}

Texel hull_of(std::span<const Texel> boxes) {
  Texel result = boxes.front();
  for (const Texel& box : boxes)
    for (std::size_t c = 0; c < 4; ++c) result[c] = hull(result[c], box[c]);
  return result;
}

int last_level_of(const DecodedTexture& decoded, const Sampler& sampler, const Texture& texture) {
  return std::min(last_level(sampler, texture), static_cast<int>(decoded.levels.size()) - 1);
}

Texels sample(const DecodedTexture& decoded, const Texture& texture, const Sampler& sampler,
              const TextureChoice& choice, const TextureSample& at,
              const SampleLatitude& latitude) {
  const bool is_nothing = std::isnan(at.lambda.low) && std::isnan(at.lambda.high);
  const LevelRules rules{choice.crossover, choice.nearest_level, choice.level_weight,
                         latitude.any_tie, latitude.weight};
  const TexelLookup lookup{sampler.wrap, sampler.border, choice.wrap, choice.texel_grid,
                           latitude.texel};
  const PickedColors colors(decoded, lookup, at.point, latitude.decoding);
  Texels boxes;
  const int last = last_level_of(decoded, limited(sampler, choice.limits), texture);
  for (const LevelPick& pick :
       pick_levels(is_nothing ? Interval(0) : at.lambda, sampler, last, rules))
    colors.collect(pick, boxes);
  if (latitude.decoding == SrgbDecoding::at_last)
    for (Texel& box : boxes) box = srgb_decoded(box);
  return boxes;
}

namespace {

bool have_same_sizes(const std::vector<TextureLevel>& a, const std::vector<TextureLevel>& b) {
  return std::ranges::equal(a, b, [](const TextureLevel& left, const TextureLevel& right) {
    return left.width == right.width && left.height == right.height;
  });
}

}  // namespace

TextureStage::TextureStage(const Scene& scene, const RuleChoices& choices)
    : scene_(scene), choices_(choices), coordinates_(scene.target.width) {
  const TextureChoice& choice = choices.textures;
  const MipmapMethod& method = choice.mipmap;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& texture = *scene.textures[i];
    if (texture.generated)
      chains_[i] = mip_chain(texture.levels.at(0), texture.format, choice.level_count, method);
    decoded_.push_back(decode(texture, texture.generated ? chains_[i] : texture.levels));
  }
}

void TextureStage::take_chains(const std::map<std::size_t, std::vector<TextureLevel>>& chains) {
  for (const auto& [number, levels] : chains) {
    // Levels whose sizes differ from the chain's are a fault of their own; they are not looked up.
    const auto own = chains_.find(number);
    if (own == chains_.end() || !have_same_sizes(own->second, levels)) continue;
    chains_[number] = levels;
    decoded_[number] = decode(*scene_.textures[number], levels);
  }
}

ExactLookup TextureStage::look_up(const ScenePrimitive& primitive,
                                  const PrimitiveAttributes& attributes,
                                  PixelPosition pixel) const {
  return TexturedPrimitive(*this, primitive, attributes).look_up(pixel);
}

}  // namespace edgecase
