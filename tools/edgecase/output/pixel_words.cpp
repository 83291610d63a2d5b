// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/pixel_words.h"

#include <fmt/format.h>

#include <utility>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "suite/expectation_check.h"

namespace edgecase {
namespace {

std::string words_without_passes(const Scene& scene, const Policy& policy, Pixel pixel) {
  std::string text = fmt::format("Pixel ({}, {}), centre ({}, {}), by policy {}:\n", pixel.x,
                                 pixel.y, pixel.x + .5, pixel.y + .5, policy.name);
  for (const PixelExplanation& why : explain_pixel(scene, policy, pixel.x, pixel.y))
    text += fmt::format(
        "  primitive {} {} {} ({}): {}.\n", why.primitive, why.covered ? "draws" : "does not draw",
        why.sample < 0 ? "it" : fmt::format("sample {}", why.sample), name_of(why.rule), why.text);
  return text;
}

std::vector<int> drawn_pixels_of(const Rendering& exact) {
  if (exact.samples == 1) return hits_of(exact);
  std::vector<int> hits;
  for (const std::uint32_t mask : masks_of(exact).covered) hits.push_back(mask != 0 ? 1 : 0);
  return hits;
}

}  // namespace

std::string pixel_words(const Scene& scene, const Policy& policy, Pixel pixel) {
  if (scene.supersampling.empty()) return words_without_passes(scene, policy, pixel);
  std::string text;
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k)
    text += fmt::format("In {}:\n{}", text_of_pass(scene.supersampling, k),
                        words_without_passes(pass_of(scene, k), policy, pixel));
  return text;
}

PixelPicture pixel_picture(const Case& one, const Policy& policy, Pixel pixel) {
  const Scene scene = one.scene.supersampling.empty() ? one.scene : pass_of(one.scene, 0);
  PixelPicture picture;
  picture.width = scene.target.width;
  picture.height = scene.target.height;
  picture.title = fmt::format("Pixel ({}, {}) of {}", pixel.x, pixel.y, one.title);
  picture.hits = drawn_pixels_of(rasterize(scene, policy));
  picture.figure = scene_figure(scene);
  picture.x = pixel.x;
  picture.y = pixel.y;
  for (PixelExplanation& why : explain_pixel(scene, policy, pixel.x, pixel.y))
    picture.decisions.push_back({why.covered, std::move(why.figure)});
  return picture;
}

}  // namespace edgecase
