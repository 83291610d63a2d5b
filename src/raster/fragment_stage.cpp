// SPDX-License-Identifier: MIT
#include "raster/fragment_stage.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

// Whether a fragment's colour is stored regardless of the old one: written_color then ignores it.
bool replaces_color(const FragmentOperations& operations, const BlendChoice& choice) {
  return !operations.blending && choice.mask == ColorMaskMethod::as_set &&
         std::ranges::all_of(operations.color_mask, std::identity());
}

}  // namespace

FragmentStage::FragmentStage(Rendering& rendering, const Target& target, const OutputChoice& choice)
    : rendering_(rendering), target_(target), choice_(choice) {}

void FragmentStage::draw(const SampleFragment& fragment, const FragmentOperations& operations,
                         std::size_t sample) const {
  if (!passes_tests(fragment, operations, sample)) return;
  if (target_.depth != DepthFormat::none && fragment.writes_depth &&
      stores_depth(operations.depth, choice_.depth_mask))
    rendering_.depths[sample] = to_depth(fragment.depth, target_.depth);
  write_color(fragment, operations, sample);
  ++rendering_.hits[sample];
}

void FragmentStage::draw_at_all(const SampleFragment& fragment,
                                const FragmentOperations& operations,
                                std::span<const PixelPosition> pixels) const {
  const bool is_tested =
      target_.depth != DepthFormat::none || target_.stencil != StencilFormat::none;
  if (is_tested || !replaces_color(operations, choice_.blend)) {
    for (const PixelPosition p : pixels)
      draw(fragment, operations, rendering_.pixel_index(p.x, p.y));
    return;
  }
  const Rgba8 stored = written_color(operations, fragment.color, {}, choice_.blend);
  for (const PixelPosition p : pixels) {
    const std::size_t pixel = rendering_.pixel_index(p.x, p.y);
    std::copy_n(stored.begin(), stored.size(), &rendering_.pixels[4 * pixel]);
    ++rendering_.hits[pixel];
  }
}

bool FragmentStage::passes_tests(const SampleFragment& fragment,
                                 const FragmentOperations& operations, std::size_t sample) const {
  if (target_.stencil == StencilFormat::none || !operations.stencil)
    return passes_depth(fragment.depth, operations.depth, sample);
  const StencilFace& face = face_of(*operations.stencil, fragment.front_facing, choice_.stencil);
  std::uint8_t& stored = rendering_.stencils[sample];
  const auto update = [&](StencilOperation operation) {
    stored = after(operation, face, stored, choice_.stencil);
  };
  if (!passes_stencil_test(face, stored, choice_.stencil)) {
    update(face.fail);
    return false;
  }
  const bool passes = passes_depth(fragment.depth, operations.depth, sample);
  update(passes ? face.pass : face.depth_fail);
  return passes;
}

bool FragmentStage::passes_depth(double depth, const DepthTest& test, std::size_t sample) const {
  if (target_.depth == DepthFormat::none) return true;
  return passes_depth_test(test, depth, rendering_.depths[sample], target_.depth, choice_.depth);
}

void FragmentStage::write_color(const SampleFragment& fragment,
                                const FragmentOperations& operations, std::size_t sample) const {
  std::vector<std::uint8_t>& plane =
      rendering_.samples > 1 ? rendering_.sample_pixels : rendering_.pixels;
  std::uint8_t* const stored = plane.data() + 4 * sample;
  Rgba8 destination{};
  if (replaces_color(operations, choice_.blend)) {
    if (replacing_ != fragment.color) {
      replacing_ = fragment.color;
      replacement_ = written_color(operations, fragment.color, destination, choice_.blend);
    }
    std::ranges::copy(replacement_, stored);
    return;
  }
  std::copy_n(stored, destination.size(), destination.begin());
  std::ranges::copy(written_color(operations, fragment.color, destination, choice_.blend), stored);
}

}  // namespace edgecase
