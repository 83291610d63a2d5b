// SPDX-License-Identifier: MIT
//
// Textures: a scene's textures and samplers as GL objects, kept for the next scene with the same
// content.
//
// Every level that a scene gives is uploaded unchanged. Levels that the driver generates are made
// once and read back, since they are part of the rendering. A sampler's state is in a sampler
// object, except for the base and the largest level, which belong to the texture (GL 4.6 core, 8.2)
// and are set for each draw.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "model/texture.h"
#include "reference/gl_objects.h"

namespace edgecase {

// Texture unit of the fragment shaders' image, of either dimension.
constexpr GLuint kImageUnit = 0;

class Textures {
 public:
  // The context must be current and outlive the textures.
  explicit Textures(const GladGLContext& gl);

  // Largest max_anisotropy of a sampler; 1 if the driver has no anisotropic filtering.
  float max_anisotropy() const { return max_anisotropy_; }

  // Binds a texture and the sampler of its use.
  void bind(const std::shared_ptr<const Texture>& texture, const Sampler& sampler);
  // All levels of a texture that the driver generated, in the texture's units, with the number and
  // sizes that the driver reports. Valid until the next call of a member.
  const std::vector<TextureLevel>& generated_chain(const std::shared_ptr<const Texture>& texture);

 private:
  struct Image {
    std::shared_ptr<const Texture> content;
    GlTexture object;
    std::vector<TextureLevel> chain;  // of a texture with generated levels
  };
  struct SamplerObject {
    Sampler content;
    GlSampler object;
  };

  const Image& find(const std::shared_ptr<const Texture>& texture);
  Image make(const std::shared_ptr<const Texture>& texture) const;
  GLuint find_sampler(const Sampler& sampler);
  GlSampler make(const Sampler& sampler) const;

  const GladGLContext& gl_;
  float max_anisotropy_ = 1;
  int max_level_ = 0;        // of a texture on this driver
  std::list<Image> images_;  // the most recently used one first
  std::size_t numbers_ = 0;  // total size of images_
  std::list<SamplerObject> samplers_;
};

}  // namespace edgecase
