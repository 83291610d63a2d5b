// SPDX-License-Identifier: MIT
#include "raster/rasterizer.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/rendering_fields.h"
#include "raster/attributes.h"
#include "raster/coverage_stages.h"
#include "raster/fragment_runs.h"
#include "raster/samples.h"
#include "raster/texture_stage.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// Sets all samples to the clear colour.
void clear_colors(const Target& target, std::vector<std::uint8_t>& planes) {
  std::array<std::uint8_t, 4> code{};
  for (std::size_t i = 0; i < code.size(); ++i)
    code[i] = to_unorm8(static_cast<double>(target.clear[i]));
  for (auto at = planes.begin(); at != planes.end(); at += 4)
    std::copy(code.begin(), code.end(), at);
}

// A rendering in which nothing is drawn yet.
Rendering cleared(const Target& target) {
  Rendering rendering;
  rendering.width = target.width;
  rendering.height = target.height;
  rendering.samples = target.samples;
  const auto pixels =
      static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
  const std::size_t samples = pixels * static_cast<std::size_t>(target.samples);
  rendering.pixels.resize(4 * pixels);
  rendering.hits.resize(samples);
  if (target.depth != DepthFormat::none)
    rendering.depths.assign(samples,
                            to_depth(static_cast<double>(target.clear_depth), target.depth));
  if (target.stencil != StencilFormat::none)
    rendering.stencils.assign(samples, target.clear_stencil);
  if (target.samples > 1) rendering.sample_pixels.resize(4 * samples);
  clear_colors(target, target.samples > 1 ? rendering.sample_pixels : rendering.pixels);
  return rendering;
}

// Reserves room for `count` more items, at least doubling the capacity when it grows.
template <class Item>
void make_room(std::size_t count, std::vector<Item>& items) {
  const std::size_t needed = items.size() + count;
  if (needed > items.capacity()) items.reserve(std::max(needed, 2 * items.size()));
}

// Adds fragments of a primitive that differ only in their positions.
void draw_alike(Rendering& rendering, const FragmentStage& stage, const ScenePrimitive& primitive,
                const Fragment& fragment, bool front_facing,
                std::span<const PixelPosition> pixels) {
  auto at = rendering.fragments.insert(rendering.fragments.end(), pixels.size(), fragment);
  for (const PixelPosition pixel : pixels) {
    at->x = pixel.x;
    at->y = pixel.y;
    ++at;
  }
  stage.draw_at_all({fragment.color, fragment.depth, front_facing}, primitive.state->operations,
                    pixels);
}

void draw_single_sampled(Rendering& rendering, const Scene& scene, const RuleChoices& choices,
                         Details details) {
  const Target& target = scene.target;
  const FragmentStage stage(rendering, target, choices.output);
  std::optional<TextureStage> textures;
  if (!scene.textures.empty()) rendering.mip_chains = textures.emplace(scene, choices).chains();
  CentreColors colors(target.width);
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.kind);
    const bool front_facing = is_front_facing(primitive, target, choice);
    const PrimitiveAttributes attributes = attributes_of(primitive, choices, target);
    std::optional<TexturedPrimitive> textured;
    if (primitive.state->texture) textured.emplace(textures.value(), primitive, attributes);
    const std::vector<PixelPosition> pixels = covered_pixels(primitive, target, choice);
    make_room(pixels.size(), rendering.fragments);
    if (pixels.empty()) continue;
    const bool has_details = is_any_asked(details, textured.has_value());
    const bool one_detail = are_details_constant(attributes, details, textured.has_value());
    if (has_details && !one_detail) make_room(pixels.size(), rendering.details);
    // If all fragments have one colour and one depth, only the first is shaded.
    if (!textured && !has_details && are_constant(attributes)) {
      draw_alike(rendering, stage, primitive, shade(primitive, attributes, pixels.front()),
                 front_facing, pixels);
      continue;
    }
    if (details.derivatives) colors.take(attributes.color);
    ExactLookup lookup;
    const ExactLookup* const shown = textured ? &lookup : nullptr;
    FragmentRuns runs(primitive, attributes, pixels);
    for (PixelPosition pixel : pixels) {
      if (textured) lookup = textured->look_up(pixel);
      Fragment fragment = !textured && primitive.kind == PrimitiveKind::triangle
                              ? runs.next()
                              : shaded(primitive, attributes, target, choice, pixel, shown);
      if (has_details) {
        if (!one_detail || pixel == pixels.front())
          rendering.details.push_back(shade_details(attributes, colors,
                                                    quad_of(pixel, choices.values, target),
                                                    choices.values, details, shown));
        fragment.detail = static_cast<int>(rendering.details.size()) - 1;
      }
      stage.draw({fragment.color, fragment.depth, front_facing}, primitive.state->operations,
                 rendering.pixel_index(fragment.x, fragment.y));
      rendering.fragments.push_back(fragment);
    }
  }
}

void draw_multisampled(Rendering& rendering, const Scene& scene, const RuleChoices& choices,
                       Details details, const SamplePositions& reported) {
  const Target& target = scene.target;
  rendering.sample_positions = positions_of(target, choices.triangles, reported);
  const FragmentStage stage(rendering, target, choices.output);
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.kind);
    draw_multisampled(rendering, stage, target, primitive, choices, details,
                      covered_samples(primitive, target, choice, reported));
  }
  resolve_samples(rendering, choices.samples.resolve);
}

Rendering drawn(const Scene& scene, const ResolvedPolicy& policy, const SamplePositions& reported,
                Details details) {
  const RuleChoices& choices = policy.on(scene.target.surface);
  Rendering rendering = cleared(scene.target);
  if (scene.target.samples > 1)
    draw_multisampled(rendering, scene, choices, details, reported);
  else
    draw_single_sampled(rendering, scene, choices, details);
  sort_fragments(rendering);
  return rendering;
}

}  // namespace

Fragment shaded(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
                const Target& target, const CoverageChoice& choice, PixelPosition pixel,
                const ExactLookup* lookup) {
  const Point centre = pixel_centre(pixel.x, pixel.y);
  const Point place = attribute_place(primitive, target, choice, pixel);
  if (lookup != nullptr || place == centre) return shade(primitive, attributes, pixel, lookup);
  return shade(primitive, attributes, pixel, {place, centre, centre});
}

Rendering rasterize(const Scene& scene, const ResolvedPolicy& policy,
                    const SamplePositions& reported) {
  if (!scene.supersampling.empty()) return draw_passes(scene, policy, rasterize);
  return drawn(scene, policy, reported, scene.details);
}

Rendering rasterize_for_comparison(const Scene& scene, const ResolvedPolicy& policy,
                                   const SamplePositions& reported) {
  if (!scene.supersampling.empty()) return draw_passes(scene, policy, rasterize_for_comparison);
  return drawn(scene, policy, reported, {.texture = scene.details.texture});
}

ExactRenderer::ExactRenderer(const Policy& policy)
    : policy_(policy),
      info_{.name = "exact",
            .vendor = "Edgecase",
            .version = "policy " + policy.name,
            .device = "exact rasterizer",
            .subpixel_bits = Fixed::kFractionBits,
            .traits = {}} {}

void ExactRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  const auto outcome_of = [&](const Task& task) -> Outcome {
    try {
      return rasterize(*task.scene, policy_);
    } catch (const std::exception& thrown) {  // too little memory, for instance
      return internal_failure(task.id, thrown);
    }
  };
  for (std::size_t i = 0; i < tasks.size(); ++i) sink(i, outcome_of(tasks[i]));
}

ExactDrawing::ExactDrawing(std::span<const Scene> layers, const ResolvedPolicy& policy)
    : layers_(layers), policy_(policy), framebuffer_(layers.front().target, policy) {
  for (const Scene& layer : layers_) {
    std::optional<FastScene> prepared = framebuffer_.prepared(layer);
    if (!prepared) {
      prepared_.clear();
      return;
    }
    prepared_.push_back(std::move(*prepared));
  }
}

void ExactDrawing::draw() {
  if (prepared_.empty()) {
    for (const Scene& layer : layers_) plain_pixels_ = rasterize(layer, policy_).pixels;
    return;
  }
  framebuffer_.clear(layers_.front().target.clear);
  for (const FastScene& layer : prepared_) framebuffer_.draw(layer);
  framebuffer_.resolve();
}

std::vector<std::uint8_t> ExactDrawing::pixels() const {
  return prepared_.empty() ? plain_pixels_ : framebuffer_.pixels();
}

}  // namespace edgecase
