// SPDX-License-Identifier: MIT
//
// The capture of a scene in parts: SceneRenderer's passes for reference/word_capture.h.
#include <algorithm>

#include "reference/scene_renderer.h"

namespace edgecase {

namespace {

// Whether each fragment that a capture tells is also counted as a hit.
bool counts_all(const Scene& scene) {
  return !has_fragment_operations(scene) &&
         std::none_of(scene.draws.begin(), scene.draws.end(),
                      [](const Draw& draw) { return draw.multisampling.alpha_to_coverage; });
}

}  // namespace

std::vector<std::uint8_t> SceneRenderer::draw_part(const Scene& scene, const Surfaces& surfaces,
                                                   const Pass& pass, const Rendering& rendering) {
  clear_for(scene, surfaces.color, {0, 0, 0, 0});
  draw_all(scene, pass);
  if (surfaces.multisampled != nullptr)
    return objects_->targets.samples().colors(*surfaces.multisampled);
  std::vector<std::uint8_t> colors(4 * rendering.pixel_index(0, rendering.height));
  gl_.ReadPixels(0, 0, rendering.width, rendering.height, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
  return colors;
}

std::optional<std::string> SceneRenderer::capture_words(const Scene& scene,
                                                        const Surfaces& surfaces, Pass pass,
                                                        Capture::Form form, bool coverage_only,
                                                        Rendering& rendering) {
  WordCapture& words = objects_->words;
  words.begin(scene, form, coverage_only, rendering);
  const auto draw = [&](int part) {
    pass.part = part;
    return draw_part(scene, surfaces, pass, rendering);
  };
  while (words.doubt().empty() && words.take_first(draw(words.parts().front()))) {
    for (std::size_t i = 1; i < words.parts().size(); ++i)
      words.take(words.parts()[i], draw(words.parts()[i]));
    words.finish_layer(rendering);
  }
  sort_fragments(rendering);
  if (words.doubt().empty()) return std::nullopt;
  return words.doubt();
}

std::optional<std::string> SceneRenderer::doubt_of_words(const Scene& scene,
                                                         const Surfaces& surfaces,
                                                         const Rendering& rendering) {
  std::string doubt = objects_->words.doubt_of_hits(
      counts_all(scene) ? rendering.hits
                        : count_hits(scene, surfaces, PassKind::capture, rendering));
  if (doubt.empty()) return std::nullopt;
  return doubt;
}

}  // namespace edgecase
