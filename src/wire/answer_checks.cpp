// SPDX-License-Identifier: MIT
#include "wire/fragments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <new>
#include <string_view>
#include <vector>

#include "model/rendering_fields.h"
#include "wire/answer_line.h"
#include "wire/json_values.h"

namespace edgecase {

using wire::Refusal;

namespace {

void require_size(std::string_view what, std::size_t size, std::size_t wanted) {
  if (size != wanted)
    throw Refusal(fmt::format("{} must have {} elements, but has {}", what, wanted, size));
}

// The same for an optional plane.
void require_size_if_any(std::string_view what, std::size_t size, std::size_t wanted) {
  if (size > 0) require_size(what, size, wanted);
}

// A float32 buffer may store a depth that rounding took beyond 0 or 1; an unsigned one cannot.
void check_depths(const std::vector<double>& depths, DepthFormat format) {
  const bool is_float = holds_floats(format);
  for (const double depth : depths)
    if (!std::isfinite(depth) || (!is_float && !(depth >= 0 && depth <= 1)))
      throw Refusal(fmt::format("a depth is {}, which {} does not hold", depth, name_of(format)));
}

void check_texels(const TextureLevel& level, TextureFormat format) {
  require_size("a level", level.texels.size(), level.index(0, level.height));
  const auto is_code = [](float texel) {
    return texel >= 0 && texel <= 255 && texel == std::trunc(texel);
  };
  if (!holds_floats(format) && !std::ranges::all_of(level.texels, is_code))
    throw Refusal(fmt::format("a level has a texel that {} does not hold", name_of(format)));
}

// Levels may have the wrong sizes, but none is larger than the image from which all are made.
void check_mip_chains(const Rendering& rendering, const Scene& scene) {
  for (const auto& [number, levels] : rendering.mip_chains) {
    if (number >= scene.textures.size() || !scene.textures[number]->generated)
      throw Refusal(fmt::format("{} is no texture whose levels are generated", number));
    const Texture& texture = *scene.textures[number];
    const TextureLevel& image = texture.levels.front();
    if (levels.empty()) throw Refusal("a mip chain has no level");
    if (levels.size() > wire::kMostLevels)
      throw Refusal(fmt::format("a mip chain has {} levels", levels.size()));
    for (const TextureLevel& level : levels) {
      if (std::min(level.width, level.height) < 1 || level.width > image.width ||
          level.height > image.height)
        throw Refusal(fmt::format("a level is {}x{}, and the image is {}x{}", level.width,
                                  level.height, image.width, image.height));
      check_texels(level, texture.format);
    }
  }
}

// What is later used as an index, or as a mask of samples.
void check_fragments(const Rendering& rendering, const Scene& scene) {
  const std::vector<bool> textured = wire::textured_primitives(scene);
  for (const Fragment& fragment : rendering.fragments) {
    if (fragment.x < 0 || fragment.x >= rendering.width || fragment.y < 0 ||
        fragment.y >= rendering.height)
      throw Refusal(fmt::format("a fragment is at pixel ({}, {}), outside the target", fragment.x,
                                fragment.y));
    if (fragment.primitive < 0 || static_cast<std::size_t>(fragment.primitive) >= textured.size())
      throw Refusal(fmt::format("a fragment is of primitive {}, and there are {}",
                                fragment.primitive, textured.size()));
    if (fragment.coverage < 1 || fragment.coverage >= std::uint64_t{1} << rendering.samples)
      throw Refusal(fmt::format("a fragment has the coverage {}, which is none of {} samples",
                                fragment.coverage, rendering.samples));
    if (fragment.detail >= static_cast<std::int64_t>(rendering.details.size()))
      throw Refusal("a fragment has a detail that is not there");
    if (fragment.detail >= 0)
      check_detail(rendering.details[static_cast<std::size_t>(fragment.detail)], scene.details,
                   textured[static_cast<std::size_t>(fragment.primitive)]);
  }
}

std::size_t area_of(const Rendering& rendering) {
  return rendering.pixel_index(0, rendering.height);
}

// A renderer may write a sample more often than its own fragments say, which is judged, but no
// primitive writes one more often than it may have fragments there.
void check_hits(const Rendering& rendering, const Scene& scene) {
  require_size_if_any("the hits", rendering.hits.size(),
                      area_of(rendering) * static_cast<std::size_t>(rendering.samples));
  const auto contradiction =
      has_fragment_operations(scene) ? excess_of_hits(rendering) : contradiction_of_hits(rendering);
  if (contradiction) throw Refusal(*contradiction);
  if (rendering.hits.empty() || rendering.samples == 1) return;
  const std::size_t most = wire::kMostOfPrimitive * primitives_of(scene).size();
  for (const std::uint32_t hits : rendering.hits)
    if (hits > most)
      throw Refusal(fmt::format("a sample has {} hits, more than {} for each primitive", hits,
                                wire::kMostOfPrimitive));
}

// Checks a single drawing: a scene that is not supersampled, or a pass.
void check_drawing(const Rendering& rendering, const Scene& scene) {
  const std::size_t area = area_of(rendering);
  const std::size_t planes = area * static_cast<std::size_t>(rendering.samples);
  const bool is_multisampled = rendering.samples > 1;
  const Target& target = scene.target;
  require_size("the pixels", rendering.pixels.size(), 4 * area);
  require_size("the depths", rendering.depths.size(),
               target.depth == DepthFormat::none ? 0 : planes);
  require_size("the stencils", rendering.stencils.size(),
               target.stencil == StencilFormat::none ? 0 : planes);
  require_size_if_any("the pixels of samples", rendering.sample_pixels.size(),
                      is_multisampled ? 4 * planes : 0);
  require_size_if_any("the positions of samples", rendering.sample_positions.size(),
                      is_multisampled ? static_cast<std::size_t>(rendering.samples) : 0);
  for (const Point& position : rendering.sample_positions)
    if (position.x.floor() != 0 || position.y.floor() != 0)
      throw Refusal("a sample lies outside its pixel");
  const SamplePositions& required = target.sample_positions;
  if (!required.empty() && !rendering.sample_positions.empty() &&
      rendering.sample_positions != required)
    throw Refusal(
        "the samples lie elsewhere than the scene requires; refuse positions that you do not "
        "support");
  require_size("the accumulated image", rendering.accumulated.size(), 0);
  require_size("the passes", rendering.passes.size(), 0);
  check_depths(rendering.depths, target.depth);
  check_mip_chains(rendering, scene);
  check_fragments(rendering, scene);
  check_hits(rendering, scene);
}

// In a supersampled scene only passes have fragments and what belongs to them.
void check_supersampled(const Rendering& rendering, const Scene& scene) {
  const std::size_t area = area_of(rendering);
  require_size("the pixels", rendering.pixels.size(), 4 * area);
  require_size("the accumulated image", rendering.accumulated.size(), 4 * area);
  require_size("the passes", rendering.passes.size(), scene.supersampling.size());
  require_size("the planes and fragments beside the passes",
               rendering.fragments.size() + rendering.hits.size() + rendering.depths.size() +
                   rendering.stencils.size() + rendering.mip_chains.size() +
                   rendering.sample_positions.size() + rendering.sample_pixels.size(),
               0);
  for (std::size_t k = 0; k < rendering.passes.size(); ++k) {
    try {
      check_drawing(rendering.passes[k], scene);
    } catch (const Refusal& refusal) {
      throw Refusal(fmt::format("/passes/{}: {}", k, refusal.what()));
    }
  }
}

}  // namespace

bool has_values(const FragmentDetail& detail) {
  bool something = false;
  for_each_field<FragmentDetail>(
      [&](const auto& field) { something = something || is_reported(detail.*field.member); });
  return something;
}

void check_detail(const FragmentDetail& detail, Details asked, bool is_textured) {
  for_each_field<FragmentDetail>([&](const auto& field) {
    if (is_reported(detail.*field.member) && !field.is_asked(asked, is_textured))
      throw Refusal("a fragment has a detail that was not requested");
  });
}

void check_coverage(const Rendering& rendering, const Scene& scene) {
  check_fragments(rendering, scene);
  check_hits(rendering, scene);
}

void check_rendering(const Rendering& rendering, const Scene& scene) {
  if (scene.supersampling.empty())
    check_drawing(rendering, scene);
  else
    check_supersampled(rendering, scene);
}

void check_claims(const RendererInfo& claims) {
  if (claims.subpixel_bits < 0 || claims.subpixel_bits > kMaxSubpixelBits)
    throw Refusal(fmt::format("the sub-pixel bits are {}, but they must be 0 to {}",
                              claims.subpixel_bits, kMaxSubpixelBits));
}

WireError error_of_reading(const std::exception& thrown) {
  if (dynamic_cast<const Refusal*>(&thrown) != nullptr) return {thrown.what()};
  if (dynamic_cast<const std::bad_alloc*>(&thrown) != nullptr)
    return {"reading it takes more memory than there is"};
  return {
      fmt::format("edgecase itself failed when it read it ({}); please report this with the "
                  "answer",
                  thrown.what())};
}

}  // namespace edgecase
