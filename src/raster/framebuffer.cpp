// SPDX-License-Identifier: MIT
#include "raster/framebuffer.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "kernels/kernels.h"
#include "kernels/tile_bins.h"
#include "raster/attributes.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

PixelWord word_of(const std::array<double, 4>& color) {
  std::array<std::uint8_t, 4> codes{};
  std::transform(color.begin(), color.end(), codes.begin(), to_unorm8);
  return std::bit_cast<PixelWord>(codes);
}

bool is_four_nearest_even(std::size_t samples, ResolveMethod method) {
  return samples == 4 && method == ResolveMethod::nearest_even;
}

// The least odd number of cache lines that holds this many pixels, in pixels.
std::size_t padded_width(std::size_t width, std::size_t line) {
  return ((width + line - 1) / line | 1) * line;
}

}  // namespace

Framebuffer::Framebuffer(const Target& target, const ResolvedPolicy& policy,
                         const SamplePositions& reported)
    : target_(target),
      choices_(policy.on(target.surface)),
      stride_(padded_width(static_cast<std::size_t>(target.width), CacheLine::kPixels)) {
  for (Point place : positions_of(target, choices_.triangles, reported))
    places_.push_back(raw_point(place));
  const std::size_t planes = places_.size() + (target.samples > 1 ? 1 : 0);
  const std::size_t lines = (plane_size() + PixelPlane::kSpare) / CacheLine::kPixels + 1;
  memory_.assign(planes, std::vector<CacheLine>(lines));
  for (std::vector<CacheLine>& memory : memory_)
    planes_.push_back({memory[0].pixels, static_cast<std::ptrdiff_t>(stride_)});
}

std::size_t Framebuffer::plane_size() const {
  return stride_ * static_cast<std::size_t>(target_.height);
}

std::optional<FastScene> Framebuffer::prepared(const Scene& scene) const {
  if (!kernels_are_used()) return std::nullopt;
  return fast_scene(scene, choices_);
}

void Framebuffer::clear(const Color& color) {
  std::array<double, 4> components{};
  std::copy(color.begin(), color.end(), components.begin());
  for (std::size_t s = 0; s < places_.size(); ++s)
    std::fill_n(planes_[s].pixels, plane_size(), word_of(components));
}

// Writes the plain stages' results into a primitive's pixels.
class Framebuffer::PlainWords {
 public:
  PlainWords(const ScenePrimitive& primitive, const FastScene& scene, const RuleChoices& choices,
             const Target& target)
      : primitive_(primitive),
        choice_(choices.of(primitive.kind)),
        target_(target),
        attributes_(attributes_of(primitive, choices, target)) {
    if (primitive.state->texture)
      textured_.emplace(scene.textures->stage(), primitive, attributes_);
  }

  PixelWord at(PixelPosition pixel) {
    std::optional<ExactLookup> lookup;
    if (textured_) lookup = textured_->look_up(pixel);
    return word_of(
        shaded(primitive_, attributes_, target_, choice_, pixel, lookup ? &*lookup : nullptr)
            .color);
  }

 private:
  const ScenePrimitive& primitive_;
  const CoverageChoice& choice_;
  const Target& target_;
  const PrimitiveAttributes attributes_;
  std::optional<TexturedPrimitive> textured_;
};

void Framebuffer::draw(const FastScene& scene) {
  const auto part_of = [](const auto& all, const FastBatch& batch) {
    return std::span(all).subspan(batch.first, batch.count);
  };
  for (const FastBatch& batch : scene.batches) switch (batch.kind) {
      case FastBatch::Kind::flat_triangles:
      case FastBatch::Kind::flat_lines:
        draw_flat(scene, batch);
        break;
      case FastBatch::Kind::smooth_triangles:
        draw_interpolated(part_of(scene.smooth_triangles, batch),
                          part_of(scene.smooth_primitives, batch), batch, scene,
                          fill_smooth_triangle);
        break;
      case FastBatch::Kind::textured_triangles:
        draw_interpolated(part_of(scene.textured_triangles, batch),
                          part_of(scene.textured_primitives, batch), batch, scene,
                          fill_textured_triangle);
        break;
      case FastBatch::Kind::plain:
        for (const ScenePrimitive& primitive : part_of(scene.plain_primitives, batch))
          draw_plain(primitive, scene);
        break;
    }
}

void Framebuffer::draw_flat(const FastScene& scene, const FastBatch& batch) {
  std::vector<PixelPlane> planes;
  std::vector<RawPoint> places;
  for (std::size_t s = 0; s < places_.size(); ++s) {
    if (target_.samples > 1 && (batch.samples >> s & 1) == 0) continue;
    planes.push_back(planes_[s]);
    places.push_back(places_[s]);
  }
  const FillTarget target{planes, places, batch.bounds};
  if (batch.kind == FastBatch::Kind::flat_triangles)
    fill_triangles(target, std::span(scene.flat_triangles).subspan(batch.first, batch.count),
                   weights_of(choices_.triangles.ties));
  else
    fill_lines(target, std::span(scene.flat_lines).subspan(batch.first, batch.count),
               weights_of(*choices_.lines.line.boundary->ties));
}

template <class Triangle, class Fill>
void Framebuffer::draw_interpolated(std::span<const Triangle> triangles,
                                    std::span<const ScenePrimitive> primitives,
                                    const FastBatch& batch, const FastScene& scene, Fill fill) {
  const TieWeights ties = weights_of(choices_.triangles.ties);
  const auto draw_part = [&](std::size_t i, const PixelBounds& part) {
    doubtful_.clear();
    fill(planes_[0], part, triangles[i], ties, doubtful_);
    if (doubtful_.empty()) return;
    PlainWords words(primitives[i], scene, choices_, target_);
    for (PixelPosition pixel : doubtful_) planes_[0].row(pixel.y)[pixel.x] = words.at(pixel);
  };
  const auto vertices = [&](std::size_t i) { return triangles[i].vertices; };
  if (!wants_bins(triangles.size(), batch.bounds, vertices)) {
    for (std::size_t i = 0; i < triangles.size(); ++i) draw_part(i, batch.bounds);
    return;
  }
  TileBins bins(batch.bounds);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i].vertices;
    const TriangleSetup setup(a, b, c, ties);
    if (setup.has_area()) bins.add(i, setup.edges_at(kCentrePlace), setup.box_at(kCentrePlace));
  }
  bins.draw([&](std::size_t i, const PixelBounds& part, bool) { draw_part(i, part); });
}

void Framebuffer::draw_plain(const ScenePrimitive& primitive, const FastScene& scene) {
  PlainWords words(primitive, scene, choices_, target_);
  for (PixelPosition pixel : covered_pixels(primitive, target_, choices_.of(primitive.kind)))
    planes_[0].row(pixel.y)[pixel.x] = words.at(pixel);
}

void Framebuffer::resolve() {
  if (target_.samples == 1) return;
  const std::span<const PixelPlane> samples(planes_.data(), places_.size());
  if (is_four_nearest_even(samples.size(), choices_.samples.resolve))
    return resolve_four(samples.first<4>(), planes_.back(), plane_size());
  std::vector<std::uint8_t> values(samples.size());
  auto* const out = reinterpret_cast<std::uint8_t*>(planes_.back().pixels);
  for (std::size_t i = 0; i < sizeof(PixelWord) * plane_size(); ++i) {
    for (std::size_t s = 0; s < values.size(); ++s)
      values[s] = reinterpret_cast<const std::uint8_t*>(samples[s].pixels)[i];
    out[i] = resolved(values, choices_.samples.resolve);
  }
}

std::vector<std::uint8_t> Framebuffer::pixels() const {
  const std::size_t row = sizeof(PixelWord) * static_cast<std::size_t>(target_.width);
  std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(target_.height));
  for (int y = 0; y < target_.height; ++y)
    std::memcpy(pixels.data() + row * static_cast<std::size_t>(y), planes_.back().row(y), row);
  return pixels;
}

}  // namespace edgecase
