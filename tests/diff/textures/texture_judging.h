// SPDX-License-Identifier: MIT
//
// Textured scenes for tests of judging, and short forms to judge a rendering of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "tests/support/judging.h"

namespace edgecase {

struct TexturedScene {
  std::string name;
  Scene scene;
};

// Scenes in which every choice about textures shows, each in one of them at least.
const std::vector<TexturedScene>& judged_textures();
const Scene& textures_named(const std::string& name);

// A floor in strong perspective, of 24 by 24 pixels; the texture's chain holds random floats.
Scene floor_scene(const Sampler& sampler, const Lookup& lookup = {});
// 16 by 16 pixels, none of four partial derivatives like another, the same everywhere.
Scene rotated_scene(const Sampler& sampler);
// A rectangle of 16 by 16 pixels that shows so many texels of a 32x32 texture to a pixel.
Scene flat_scene(double texels_per_pixel, TextureFormat format, const Sampler& sampler,
                 const Lookup& lookup = {});
// The same rectangle with a texture whose chain the renderer generates.
Scene generated_scene(int width, int height, TextureFormat format);

// "rule=alternative" each.
Policy policy_from(const std::vector<std::string>& choices);

// What `opengl`, or another policy, says of a rendering, of a case by itself.
Result judge_textures(const Scene& scene, const Rendering& rendered, const Policy& policy = {},
                      const Policy* profile = nullptr);
// Of the exact rendering under the other choices.
Result judge_follower(const Scene& scene, const std::vector<std::string>& choices,
                      const Policy* profile = nullptr);

std::string describe_textures(const Result& result);

// Exact's rendering after a change of each fragment of a textured draw, or of one.
using TextureChange = std::function<void(Fragment&, FragmentDetail&)>;
Rendering changed_textures(const Scene& scene, const TextureChange& change);
Rendering changed_texture(const Scene& scene, std::size_t fragment, const TextureChange& change);
// lambda' and what is accessed, moved together by so many levels.
TextureChange level_moved(double by);
// As the GPU has it: every number of fragments and details a float32.
Rendering in_float32(const Scene& scene, Rendering rendering);

}  // namespace edgecase
