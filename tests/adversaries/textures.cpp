// SPDX-License-Identifier: MIT
#include "tests/adversaries/textures.h"

#include <algorithm>
#include <cmath>

namespace edgecase::adversary {
namespace {

// 8.24.
double decoded(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double coded(double c) {
  return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

// 8.14.2, table 8.20; -1: the border.
int wrapped(Wrap wrap, int i, int n) {
  const int around = ((i % (2 * n)) + 2 * n) % (2 * n);
  switch (wrap) {
    case Wrap::repeat:
      return around % n;
    case Wrap::mirrored_repeat:
      return std::min(around, 2 * n - 1 - around);
    case Wrap::clamp_to_edge:
      return std::clamp(i, 0, n - 1);
    case Wrap::clamp_to_border:
      break;
  }
  return i < 0 || i >= n ? -1 : i;
}

}  // namespace

Textures::Textures(const Scene& scene, const Freedoms& freedoms)
    : scene_(scene), freedoms_(freedoms) {
  for (std::size_t i = 0; i < scene.textures.size(); ++i)
    if (scene.textures[i]->generated) generated_[i] = chain_of(*scene.textures[i]);
}

// 8.14.4: any filter, and any rounding.
std::vector<TextureLevel> Textures::chain_of(const Texture& texture) const {
  std::vector<TextureLevel> chain = texture.levels;
  const bool light = texture.format == TextureFormat::srgb8 && !freedoms_.decodes_after;
  while (chain.back().width > 1 || chain.back().height > 1) {
    const TextureLevel& above = chain.back();
    TextureLevel level{std::max(1, above.width / 2), std::max(1, above.height / 2), {}};
    for (int j = 0; j < level.height; ++j)
      for (int i = 0; i < level.width; ++i)
        for (std::size_t c = 0; c < 4; ++c) {
          const bool curved = light && c < 3;
          const auto read = [&](int di, int dj) {
            const int x = std::min(2 * i + di, above.width - 1),
                      y = std::min(2 * j + dj, above.height - 1);
            const double n = static_cast<double>(above.texels[above.index(x, y) + c]);
            return curved ? decoded(n / 255) : n;
          };
          double mean = freedoms_.nearest_mipmaps
                            ? read(0, 0)
                            : (read(0, 0) + read(1, 0) + read(0, 1) + read(1, 1)) / 4;
          if (freedoms_.crime == "mipmaps darker by two codes") mean -= curved ? 0.02 : 2;
          if (curved) mean = coded(std::max(mean, 0.0)) * 255;
          if (texture.format != TextureFormat::rgba32f)
            mean = std::nearbyint(converted(freedoms_, mean / 255, 255) * 255);
          level.texels.push_back(static_cast<float>(mean));
        }
    chain.push_back(std::move(level));
  }
  return chain;
}

const TextureLevel& Textures::level_of(const TextureUse& use, int level) const {
  const auto found = generated_.find(use.texture);
  const auto& levels =
      found == generated_.end() ? scene_.textures[use.texture]->levels : found->second;
  return levels[std::min(static_cast<std::size_t>(level), levels.size() - 1)];
}

// Between the bounds of 8.14.1, and the logarithm.
double Textures::level_base(const TextureUse& use, Pair dx, Pair dy) const {
  const TextureLevel& base = level_of(use, use.sampler.base_level);
  const double wide = base.width,
               high = scene_.textures[use.texture]->dimensions == 1 ? 0 : base.height;
  const double ux = std::abs((Real(dx[0]) * wide).value), vx = std::abs((Real(dx[1]) * high).value);
  const double uy = std::abs((Real(dy[0]) * wide).value), vy = std::abs((Real(dy[1]) * high).value);
  double rho = std::max(std::hypot(ux, vx), std::hypot(uy, vy));
  const double partial = std::max({ux, vx, uy, vy}), sums = std::max(ux + vx, uy + vy);
  if (freedoms_.scale == ScaleFactor::largest_partial) rho = partial;
  if (freedoms_.scale == ScaleFactor::sum_of_partials) rho = std::max(ux, uy) + std::max(vx, vy);
  if (freedoms_.scale == ScaleFactor::root_two_of_sums) rho = std::sqrt(2.0) * sums;
  if (use.sampler.max_anisotropy > 1 && freedoms_.takes_sharper_level)
    rho = std::max(std::min(std::hypot(ux, vx), std::hypot(uy, vy)),
                   rho / static_cast<double>(use.sampler.max_anisotropy));
  if (freedoms_.crime == "scale factors below the least") rho = partial * 0.8;
  if (freedoms_.crime == "scale factors beyond the most")
    rho = 1.2 * std::max(std::sqrt(2.0) * sums, std::max(ux, uy) + std::max(vx, vy));
  return rounded(std::max(std::log2(rho), -100.0)) + freedoms_.level_error * 0.99 / 64;
}

double Textures::biased(const TextureUse& use, double base, double by_shader) const {
  double by_sampler = static_cast<double>(use.sampler.lod_bias);
  if (freedoms_.clamps_each_bias) {
    by_sampler = std::clamp(by_sampler, -2.0, 2.0);
    by_shader = std::clamp(by_shader, -2.0, 2.0);
  }
  if (freedoms_.crime == "biases clamped at 1") by_sampler = std::clamp(by_sampler, -1.0, 1.0);
  return base + by_sampler + by_shader;
}

LookedUp Textures::look_up(const TextureUse& use, const Values4& at, const Values4& dx,
                           const Values4& dy) const {
  const Sampler& sampler = use.sampler;
  const TextureLevel& base = level_of(use, sampler.base_level);
  const int q =
      std::min(sampler.base_level + level_count(base.width, base.height) - 1, sampler.max_level);
  const auto clamped = [&](double lambda) {
    return std::clamp(lambda, static_cast<double>(sampler.min_lod),
                      static_cast<double>(sampler.max_lod));
  };
  LookedUp result;
  const double queried = biased(use, level_base(use, {dx[0], dx[1]}, {dy[0], dy[1]}), 0);
  const double accessed =
      std::clamp(clamped(queried), 0.0, static_cast<double>(q - sampler.base_level));
  const auto nearest = [&](double l) {
    return freedoms_.ties_of_levels_up ? std::floor(l + 0.5)
                                       : std::max(std::ceil(l + 0.5) - 1, 0.0);
  };
  result.queried = {sampler.mipmap == MipFilter::none      ? 0
                    : sampler.mipmap == MipFilter::nearest ? nearest(accessed)
                                                           : accessed,
                    queried};

  const Lookup& lookup = use.lookup;
  double lambda = queried;
  if (lookup.kind == LookupKind::bias)
    lambda = biased(use, level_base(use, {dx[0], dx[1]}, {dy[0], dy[1]}),
                    static_cast<double>(lookup.value));
  if (lookup.kind == LookupKind::lod) lambda = biased(use, static_cast<double>(lookup.value), 0);
  if (lookup.kind == LookupKind::gradients)
    lambda = biased(
        use,
        level_base(use, {static_cast<double>(lookup.dx[0]), static_cast<double>(lookup.dx[1])},
                   {static_cast<double>(lookup.dy[0]), static_cast<double>(lookup.dy[1])}),
        0);
  lambda = clamped(lambda);
  if (lambda <= 0 || sampler.mipmap == MipFilter::none) {
    result.color =
        in_level(use, sampler.base_level, lambda <= 0 ? sampler.magnify : sampler.minify, at);
    return result;
  }
  const double beyond = std::min(lambda, static_cast<double>(q - sampler.base_level));
  if (sampler.mipmap == MipFilter::nearest) {
    const int level = sampler.base_level + static_cast<int>(nearest(beyond));
    result.color = in_level(use, level, sampler.minify, at);
    return result;
  }
  const int level = sampler.base_level + static_cast<int>(std::floor(beyond));
  double weight = beyond - std::floor(beyond);
  if (freedoms_.weight_bits > 0)
    weight =
        std::ldexp(std::floor(std::ldexp(weight, freedoms_.weight_bits)), -freedoms_.weight_bits);
  result.color = in_level(use, level, sampler.minify, at);
  if (weight > 0)
    result.color = mixed(use, result.color, in_level(use, level + 1, sampler.minify, at), weight);
  return result;
}

Values4 Textures::texel(const TextureUse& use, const TextureLevel& level, int i, int j) const {
  const Texture& texture = *scene_.textures[use.texture];
  const bool is_float = texture.format == TextureFormat::rgba32f;
  Values4 result{};
  const int x = wrapped(use.sampler.wrap[0], i, level.width);
  const int y = texture.dimensions == 1 ? 0 : wrapped(use.sampler.wrap[1], j, level.height);
  for (std::size_t c = 0; c < 4; ++c) {
    if (x < 0 || y < 0) {
      const double border = static_cast<double>(use.sampler.border[c]);
      result[c] = is_float ? border : std::clamp(border, 0.0, 1.0);
      // A border is linear; it is decoded with the rest.
      if (texture.format == TextureFormat::srgb8 && freedoms_.decodes_after && c < 3)
        result[c] = coded(result[c]);
      continue;
    }
    const double n = static_cast<double>(level.texels[level.index(x, y) + c]);
    result[c] = is_float ? n : n / 255;
    if (texture.format == TextureFormat::srgb8 && c < 3 && !freedoms_.decodes_after)
      result[c] = decoded(result[c]);
  }
  return result;
}

Values4 Textures::mixed(const TextureUse& use, const Values4& a, const Values4& b,
                        double weight) const {
  Values4 result;
  const bool codes =
      freedoms_.codes_of_8_bits && scene_.textures[use.texture]->format != TextureFormat::rgba32f;
  for (std::size_t c = 0; c < 4; ++c) {
    result[c] = ((Real(1) - weight) * a[c] + Real(weight) * b[c]).value;
    if (codes) result[c] = std::nearbyint(result[c] * 255) / 255;
  }
  return result;
}

Values4 Textures::in_level(const TextureUse& use, int number, Filter filter,
                           const Values4& at) const {
  const TextureLevel& level = level_of(use, number);
  const Texture& texture = *scene_.textures[use.texture];
  const double error = freedoms_.texel_error * 0.99 / 128;
  const auto sign = [&](double n) {
    return freedoms_.arithmetic == Arithmetic::either && (hash_of(n) & 1) != 0 ? -1 : 1;
  };
  const double u = (Real(at[0]) * level.width).value + sign(at[0]) * error;
  const double v =
      texture.dimensions == 1 ? 0.5 : (Real(at[1]) * level.height).value + sign(at[1]) * error;
  Values4 result{};
  if (!std::isfinite(u) || !std::isfinite(v) || std::abs(u) > 1e8 || std::abs(v) > 1e8)
    return result;
  const auto whole = [](double n) { return static_cast<int>(std::floor(n)); };
  if (filter == Filter::nearest) {
    result = texel(use, level, whole(u), whole(v));
  } else {
    const int i = whole(u - 0.5), j = whole(v - 0.5);
    const double along = u - 0.5 - i, up = v - 0.5 - j;
    const auto row = [&](int y) {
      return mixed(use, texel(use, level, i, y), texel(use, level, i + 1, y), along);
    };
    result = texture.dimensions == 1 ? row(0) : mixed(use, row(j), row(j + 1), up);
  }
  if (texture.format == TextureFormat::srgb8 && freedoms_.decodes_after)
    for (std::size_t c = 0; c < 3; ++c) result[c] = decoded(result[c]);
  return result;
}

}  // namespace edgecase::adversary
