// SPDX-License-Identifier: MIT
#include "reference/textures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "reference/gl_api.h"

namespace edgecase {

namespace {

// The number of objects kept. A suite uses a handful of textures, and draws cases that share one
// consecutively.
constexpr std::size_t kMostImages = 16;
constexpr std::size_t kMostSamplers = 64;
// Two of the largest textures with whole chains, at four numbers per texel.
constexpr std::size_t kMostNumbers = std::size_t{12} * kMaxTextureSize * kMaxTextureSize;

bool has_extension(const GladGLContext& gl, std::string_view name) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLubyte* text = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (text != nullptr && name == reinterpret_cast<const char*>(text)) return true;
  }
  return false;
}

// Anisotropic filtering is part of OpenGL 4.6, and an extension before.
float find_max_anisotropy(const GladGLContext& gl) {
  float most = 1;
  if (gl.VERSION_4_6 || has_extension(gl, "GL_ARB_texture_filter_anisotropic") ||
      has_extension(gl, "GL_EXT_texture_filter_anisotropic"))
    gl.GetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &most);
  return most;
}

GLenum target_of(const Texture& texture) {
  return texture.dimensions == 1 ? GL_TEXTURE_1D : GL_TEXTURE_2D;
}

GLint storage_of(TextureFormat format) {
  switch (format) {
    case TextureFormat::rgba8:
      return GL_RGBA8;
    case TextureFormat::srgb8:
      return GL_SRGB8_ALPHA8;
    case TextureFormat::rgba32f:
      return GL_RGBA32F;
  }
  return GL_RGBA8;
}

GLint wrap_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return GL_REPEAT;
    case Wrap::mirrored_repeat:
      return GL_MIRRORED_REPEAT;
    case Wrap::clamp_to_edge:
      return GL_CLAMP_TO_EDGE;
    case Wrap::clamp_to_border:
      return GL_CLAMP_TO_BORDER;
  }
  return GL_REPEAT;
}

GLint filter_of(Filter filter) {
  switch (filter) {
    case Filter::nearest:
      return GL_NEAREST;
    case Filter::linear:
      return GL_LINEAR;
  }
  return GL_NEAREST;
}

// The minifying filter combines both filters (GL 4.6 core, table 8.20).
GLint filter_of(Filter filter, MipFilter mipmap) {
  const bool nearest = filter == Filter::nearest;
  switch (mipmap) {
    case MipFilter::none:
      return filter_of(filter);
    case MipFilter::nearest:
      return nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST;
    case MipFilter::linear:
      return nearest ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR;
  }
  return GL_NEAREST;
}

// NaN equals itself here, and the two zeros differ.
bool same_level(const TextureLevel& a, const TextureLevel& b) {
  return a.width == b.width && a.height == b.height && a.texels.size() == b.texels.size() &&
         std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

bool same_content(const Texture& a, const Texture& b) {
  return a.dimensions == b.dimensions && a.format == b.format && a.generated == b.generated &&
         std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(), same_level);
}

std::size_t numbers_of(const Texture& texture) {
  std::size_t numbers = 0;
  for (const TextureLevel& level : texture.levels) numbers += level.texels.size();
  return numbers;
}

void upload(const GladGLContext& gl, const Texture& texture) {
  const GLint storage = storage_of(texture.format);
  const auto image = [&](GLint number, const TextureLevel& level, GLenum type, const void* data) {
    if (texture.dimensions == 1)
      gl.TexImage1D(GL_TEXTURE_1D, number, storage, level.width, 0, GL_RGBA, type, data);
    else
      gl.TexImage2D(GL_TEXTURE_2D, number, storage, level.width, level.height, 0, GL_RGBA, type,
                    data);
  };
  for (std::size_t k = 0; k < texture.levels.size(); ++k) {
    const TextureLevel& level = texture.levels[k];
    const auto number = static_cast<GLint>(k);
    if (holds_floats(texture.format)) {
      image(number, level, GL_FLOAT, level.texels.data());
      continue;
    }
    std::vector<std::uint8_t> codes(level.texels.size());
    std::transform(level.texels.begin(), level.texels.end(), codes.begin(),
                   [](float code) { return static_cast<std::uint8_t>(code); });
    image(number, level, GL_UNSIGNED_BYTE, codes.data());
  }
}

// OpenGL ES only reads framebuffers; all of our formats can be attached to one. A draw may be in
// progress, so the bound framebuffer is restored.
void read_attached(const GladGLContext& gl, GLuint name, GLint level, int width, int height,
                   GLenum type, void* data) {
  const GlFramebuffer framebuffer = make_framebuffer(gl);
  GLint bound = 0;
  gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, level);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, type, data);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
}

// One level of the bound texture, which has this name. sRGB codes are returned as stored (GL 4.6
// core, 8.11.4).
TextureLevel read_level(const GladGLContext& gl, const Texture& texture, GLuint name, GLint number,
                        int width, int height) {
  TextureLevel level{width, height, {}};
  level.texels.resize(level.index(0, height));
  const GLenum target = target_of(texture);
  const auto read = [&](GLenum type, void* data) {
    if (is_es(gl))
      read_attached(gl, name, number, width, height, type, data);
    else
      gl.GetTexImage(target, number, GL_RGBA, type, data);
  };
  if (holds_floats(texture.format)) {
    read(GL_FLOAT, level.texels.data());
    return level;
  }
  std::vector<std::uint8_t> codes(level.texels.size());
  read(GL_UNSIGNED_BYTE, codes.data());
  std::copy(codes.begin(), codes.end(), level.texels.begin());
  return level;
}

// The size of a level of the bound texture; zeros beyond the last one. OpenGL ES 3.0 cannot be
// asked: there it is the size that the level has to have (OpenGL ES 3.0, 3.8.10.4).
std::array<GLint, 2> size_of_level(const GladGLContext& gl, const Texture& texture, GLint number) {
  std::array<GLint, 2> size{0, 0};
  if (gl.GetTexLevelParameteriv == nullptr) {
    const TextureLevel& base = texture.levels.front();
    if (number < level_count(base.width, base.height))
      size = {std::max(base.width >> number, 1), std::max(base.height >> number, 1)};
    return size;
  }
  gl.GetTexLevelParameteriv(target_of(texture), number, GL_TEXTURE_WIDTH, &size[0]);
  gl.GetTexLevelParameteriv(target_of(texture), number, GL_TEXTURE_HEIGHT, &size[1]);
  return size;
}

// Every level of the bound texture, up to the first without a size.
std::vector<TextureLevel> read_chain(const GladGLContext& gl, const Texture& texture, GLuint name,
                                     int max_level) {
  std::vector<TextureLevel> chain;
  for (GLint number = 0; number <= max_level; ++number) {
    const auto [width, height] = size_of_level(gl, texture, number);
    if (width <= 0 || height <= 0) break;
    chain.push_back(read_level(gl, texture, name, number, width, height));
  }
  return chain;
}

}  // namespace

Textures::Textures(const GladGLContext& gl) : gl_(gl), max_anisotropy_(find_max_anisotropy(gl)) {
  GLint size = 1;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
  max_level_ = level_count(size, 1) - 1;
}

Textures::Image Textures::make(const std::shared_ptr<const Texture>& texture) const {
  Image image{texture, make_texture(gl_), {}};
  const GLenum target = target_of(*texture);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.BindTexture(target, image.object.name());
  upload(gl_, *texture);
  if (!texture->generated) return image;
  gl_.GenerateMipmap(target);
  image.chain = read_chain(gl_, *texture, image.object.name(), max_level_);
  return image;
}

const Textures::Image& Textures::find(const std::shared_ptr<const Texture>& texture) {
  const auto found = std::find_if(images_.begin(), images_.end(), [&](const Image& image) {
    return image.content == texture || same_content(*image.content, *texture);
  });
  if (found != images_.end()) {
    images_.splice(images_.begin(), images_, found);
    return images_.front();
  }
  numbers_ += numbers_of(*texture);
  while (!images_.empty() && (images_.size() >= kMostImages || numbers_ > kMostNumbers)) {
    numbers_ -= numbers_of(*images_.back().content);
    images_.pop_back();
  }
  images_.push_front(make(texture));
  return images_.front();
}

GlSampler Textures::make(const Sampler& sampler) const {
  GlSampler object = make_sampler(gl_);
  const GLuint name = object.name();
  gl_.SamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap_of(sampler.wrap[0]));
  gl_.SamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap_of(sampler.wrap[1]));
  gl_.SamplerParameteri(name, GL_TEXTURE_MAG_FILTER, filter_of(sampler.magnify));
  gl_.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER, filter_of(sampler.minify, sampler.mipmap));
  if (!is_es(gl_)) gl_.SamplerParameterf(name, GL_TEXTURE_LOD_BIAS, sampler.lod_bias);
  gl_.SamplerParameterf(name, GL_TEXTURE_MIN_LOD, sampler.min_lod);
  gl_.SamplerParameterf(name, GL_TEXTURE_MAX_LOD, sampler.max_lod);
  // Borders are not set on a driver without them.
  const bool has_border = std::find(sampler.wrap.begin(), sampler.wrap.end(),
                                    Wrap::clamp_to_border) != sampler.wrap.end();
  if (!is_es(gl_) || has_border)
    gl_.SamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, sampler.border.data());
  if (max_anisotropy_ > 1)
    gl_.SamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY, sampler.max_anisotropy);
  return object;
}

GLuint Textures::find_sampler(const Sampler& sampler) {
  const auto found =
      std::find_if(samplers_.begin(), samplers_.end(),
                   [&](const SamplerObject& kept) { return kept.content == sampler; });
  if (found != samplers_.end()) {
    samplers_.splice(samplers_.begin(), samplers_, found);
    return samplers_.front().object.name();
  }
  if (samplers_.size() >= kMostSamplers) samplers_.pop_back();
  samplers_.push_front({sampler, make(sampler)});
  return samplers_.front().object.name();
}

void Textures::bind(const std::shared_ptr<const Texture>& texture, const Sampler& sampler) {
  const GLenum target = target_of(*texture);
  gl_.ActiveTexture(GL_TEXTURE0 + kImageUnit);
  const Image& image = find(texture);
  gl_.BindTexture(target, image.object.name());
  // A texture of one level is complete by itself; levels beyond the last of a chain do not exist.
  const auto levels = static_cast<int>(texture->levels.size());
  const int last = texture->generated || levels > 1 ? sampler.max_level : 0;
  gl_.TexParameteri(target, GL_TEXTURE_BASE_LEVEL, sampler.base_level);
  gl_.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, last);
  gl_.BindSampler(kImageUnit, find_sampler(sampler));
}

const std::vector<TextureLevel>& Textures::generated_chain(
    const std::shared_ptr<const Texture>& texture) {
  gl_.ActiveTexture(GL_TEXTURE0 + kImageUnit);
  return find(texture).chain;
}

}  // namespace edgecase
