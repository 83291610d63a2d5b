// SPDX-License-Identifier: MIT
#include "tests/adversaries/buffers.h"

#include <algorithm>
#include <cmath>

namespace edgecase::adversary {
namespace {

// Table 17.2.
double factor(BlendFactor name, std::size_t i, const Values4& s, const Values4& d,
              const Values4& c) {
  switch (name) {
    case BlendFactor::zero:
      return 0;
    case BlendFactor::one:
      return 1;
    case BlendFactor::src_color:
      return s[i];
    case BlendFactor::one_minus_src_color:
      return 1 - s[i];
    case BlendFactor::dst_color:
      return d[i];
    case BlendFactor::one_minus_dst_color:
      return 1 - d[i];
    case BlendFactor::src_alpha:
      return s[3];
    case BlendFactor::one_minus_src_alpha:
      return 1 - s[3];
    case BlendFactor::dst_alpha:
      return d[3];
    case BlendFactor::one_minus_dst_alpha:
      return 1 - d[3];
    case BlendFactor::constant_color:
      return c[i];
    case BlendFactor::one_minus_constant_color:
      return 1 - c[i];
    case BlendFactor::constant_alpha:
      return c[3];
    case BlendFactor::one_minus_constant_alpha:
      return 1 - c[3];
    case BlendFactor::src_alpha_saturate:
      break;
  }
  return i == 3 ? 1 : std::min(s[3], 1 - d[3]);
}

std::uint8_t after(StencilOperation operation, std::uint8_t stored, std::uint8_t reference) {
  const int n = stored;
  switch (operation) {
    case StencilOperation::keep:
      return stored;
    case StencilOperation::zero:
      return 0;
    case StencilOperation::replace:
      return reference;
    case StencilOperation::incr:
      return static_cast<std::uint8_t>(std::min(n + 1, 255));
    case StencilOperation::incr_wrap:
      return static_cast<std::uint8_t>(n + 1);
    case StencilOperation::decr:
      return static_cast<std::uint8_t>(std::max(n - 1, 0));
    case StencilOperation::decr_wrap:
      return static_cast<std::uint8_t>(n - 1);
    case StencilOperation::invert:
      break;
  }
  return static_cast<std::uint8_t>(~stored);
}

}  // namespace

Buffers::Buffers(const Scene& scene, const Freedoms& freedoms, std::size_t samples)
    : scene_(scene), freedoms_(freedoms), hits_(samples) {
  Values4 clear;
  for (std::size_t i = 0; i < 4; ++i)
    clear[i] = converted(freedoms, static_cast<double>(scene.target.clear[i]), 255);
  colors_.assign(samples, clear);
  if (scene.target.depth != DepthFormat::none)
    depths_.assign(samples, stored_depth(static_cast<double>(scene.target.clear_depth), 0));
  if (scene.target.stencil != StencilFormat::none)
    stencils_.assign(samples, scene.target.clear_stencil);
}

double Buffers::stored_depth(double depth, int draw_luck) const {
  if (scene_.target.depth == DepthFormat::depth32f)
    return static_cast<double>(static_cast<float>(std::clamp(depth, 0.0, 1.0)));
  const double most = scene_.target.depth == DepthFormat::depth16 ? 65535 : 16777215;
  const double made = converted(freedoms_, depth, most);
  if (freedoms_.crime == "a depth converted in two ways" && draw_luck % 2 != 0) {
    const double down = std::floor(std::clamp(depth, 0.0, 1.0) * most) / most;
    return down == made ? std::min(down + 1 / most, 1.0) : down;
  }
  return made;
}

// 17.3.6.1: with at least the precision of what is stored. By 0 and by 1 nothing is rounded.
double Buffers::in_codes(double number) const {
  if (!freedoms_.blends_in_codes) return number;
  const bool negative = number < 0;
  const double made = converted(freedoms_, std::abs(number), 255);
  return negative ? -made : made;
}

Values4 Buffers::blended(const Blending& blending, Values4 source, const Values4& stored) const {
  Values4 constant, result;
  for (std::size_t i = 0; i < 4; ++i) {
    source[i] = in_codes(std::clamp(source[i], 0.0, 1.0));
    constant[i] = in_codes(static_cast<double>(blending.constant[i]));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const BlendTerm& term = i < 3 ? blending.color : blending.alpha;
    if (term.equation == BlendEquation::min || term.equation == BlendEquation::max) {
      result[i] = term.equation == BlendEquation::min ? std::min(source[i], stored[i])
                                                      : std::max(source[i], stored[i]);
      continue;
    }
    double s = in_codes(source[i] * in_codes(factor(term.source, i, source, stored, constant)));
    const double d =
        in_codes(stored[i] * in_codes(factor(term.destination, i, source, stored, constant)));
    if (freedoms_.crime == "blending in 4 bits") s = std::nearbyint(s * 15) / 15;
    result[i] = term.equation == BlendEquation::add        ? s + d
                : term.equation == BlendEquation::subtract ? s - d
                                                           : d - s;
  }
  return result;
}

void Buffers::meet(std::size_t index, const Draw& draw, bool front, const Values4& color,
                   double depth) {
  const FragmentOperations& operations = draw.operations;
  const double made = depths_.empty() ? 0 : stored_depth(depth, ++meetings_);
  const bool nearer = depths_.empty() || holds(operations.depth.function, made < depths_[index],
                                               made == depths_[index]);
  bool passes = nearer;
  if (!stencils_.empty() && operations.stencil) {
    const StencilFace& face = front ? operations.stencil->front : operations.stencil->back;
    const int reference = face.reference & face.read_mask, held = stencils_[index] & face.read_mask;
    const bool fits = holds(face.function, reference < held, reference == held);
    passes = fits && nearer;
    const std::uint8_t made_of_it = after(!fits     ? face.fail
                                          : !nearer ? face.depth_fail
                                                    : face.pass,
                                          stencils_[index], face.reference);
    stencils_[index] = static_cast<std::uint8_t>((made_of_it & face.write_mask) |
                                                 (stencils_[index] & ~face.write_mask));
  }
  if (!passes) return;
  ++hits_[index];
  if (!depths_.empty() && operations.depth.write) depths_[index] = made;
  const Values4 written =
      operations.blending ? blended(*operations.blending, color, colors_[index]) : color;
  for (std::size_t i = 0; i < 4; ++i)
    if (operations.color_mask[i])
      colors_[index][i] = converted(freedoms_, std::isnan(written[i]) ? 0 : written[i], 255);
}

void Buffers::tell(Rendering& rendering) const {
  const std::size_t samples = static_cast<std::size_t>(rendering.samples),
                    size = colors_.size() / samples;
  const auto code = [](double n) { return static_cast<std::uint8_t>(std::nearbyint(n * 255)); };
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t c = 0; c < 4; ++c) {
      int sum = 0;
      for (std::size_t s = 0; s < samples; ++s) sum += code(colors_[s * size + i][c]);
      const double mean = static_cast<double>(sum) / static_cast<double>(samples);
      rendering.pixels.push_back(static_cast<std::uint8_t>(
          freedoms_.resolves_down ? std::floor(mean) : std::nearbyint(mean)));
    }
  if (samples > 1 && !freedoms_.tells_less)
    for (const Values4& color : colors_)
      for (const double n : color) rendering.sample_pixels.push_back(code(n));
  rendering.depths = depths_;
  rendering.stencils = stencils_;
  if (!freedoms_.tells_less) rendering.hits = hits_;
}

}  // namespace edgecase::adversary
