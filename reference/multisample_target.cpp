// SPDX-License-Identifier: MIT
#include "reference/multisample_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/draw_state.h"
#include "reference/gl_api.h"
#include "reference/stencil_buffer.h"

namespace edgecase {

namespace {

// The texture unit on which images are made; the unit of scenes' lookups is not changed.
constexpr GLenum kWorkUnit = GL_TEXTURE1;

GlTexture make_image(const GladGLContext& gl, GLenum format, const Target& target) {
  GlTexture image = make_texture(gl);
  gl.ActiveTexture(kWorkUnit);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, image.name());
  // Placed samples do not have fixed locations.
  const GLboolean fixed = target.sample_positions.empty() ? GL_TRUE : GL_FALSE;
  // OpenGL ES only has images of immutable size.
  (is_es(gl) ? gl.TexStorage2DMultisample : gl.TexImage2DMultisample)(
      GL_TEXTURE_2D_MULTISAMPLE, target.samples, format, target.width, target.height, fixed);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  gl.ActiveTexture(GL_TEXTURE0);
  return image;
}

// The number of samples of the bound framebuffer; 0 if it is not complete.
int samples_of_framebuffer(const GladGLContext& gl) {
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return 0;
  GLint samples = 0;
  gl.GetIntegerv(GL_SAMPLES, &samples);
  return samples;
}

// A framebuffer of an image and, unless its name is 0, a depth or stencil buffer. Leaves it bound.
GlFramebuffer make_framebuffer_of(const GladGLContext& gl, const GlTexture& image,
                                  const GlTexture& depth, GLenum attachment) {
  GlFramebuffer framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE,
                          image.name(), 0);
  if (depth.name() != 0)
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D_MULTISAMPLE, depth.name(), 0);
  return framebuffer;
}

// Makes a single-sampled framebuffer; false if the driver cannot.
bool make_single(const GladGLContext& gl, GLenum format, int width, int height,
                 GlRenderbuffer& image, GlFramebuffer& framebuffer) {
  image = make_renderbuffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, image.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image.name());
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

// The number of planes of the target's size, stacked vertically, in an image of this driver.
int planes_at_once(const GladGLContext& gl, const Target& target) {
  GLint rows = 0;
  std::array<GLint, 2> viewport{};
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &rows);
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  return std::clamp(std::min(rows, viewport[1]) / target.height, 1, target.samples);
}

// Places the samples of the bound framebuffer, in all pixels alike. Returns why that is impossible;
// empty on success.
std::string place_samples(const GladGLContext& gl, const SamplePositions& positions) {
  GLint bits = 0;
  gl.GetIntegerv(GL_SAMPLE_LOCATION_SUBPIXEL_BITS_ARB, &bits);
  const std::int64_t step = Fixed::kOne >> std::clamp(bits, 0, 16);
  std::vector<GLfloat> coordinates;
  for (const Point& position : positions) {
    for (Fixed coordinate : {position.x, position.y}) {
      if (coordinate.raw() % step != 0)
        return fmt::format("this driver places samples at multiples of 2^-{} pixel", bits);
      coordinates.push_back(static_cast<GLfloat>(coordinate.to_double()));
    }
  }
  gl.FramebufferSampleLocationsfvARB(GL_FRAMEBUFFER, 0, static_cast<GLsizei>(positions.size()),
                                     coordinates.data());
  gl.FramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_SAMPLE_LOCATION_PIXEL_GRID_ARB, GL_FALSE);
  gl.FramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_PROGRAMMABLE_SAMPLE_LOCATIONS_ARB,
                           GL_TRUE);
  return "";
}

// Of the bound framebuffer, y up. Its rows are those of the window, so nothing is turned.
SamplePositions positions_of_framebuffer(const GladGLContext& gl, const Target& target) {
  const GLenum name =
      target.sample_positions.empty() ? GL_SAMPLE_POSITION : GL_PROGRAMMABLE_SAMPLE_LOCATION_ARB;
  SamplePositions positions;
  for (int sample = 0; sample < target.samples; ++sample) {
    std::array<GLfloat, 2> place{};
    gl.GetMultisamplefv(name, static_cast<GLuint>(sample), place.data());
    const auto nearest = [](GLfloat value) {
      return Fixed::from_raw(std::llround(std::ldexp(static_cast<double>(value), 16)));
    };
    positions.push_back({nearest(place[0]), nearest(place[1])});
  }
  return positions;
}

// Checks, places and describes the bound framebuffer's samples. Returns what is not as requested.
std::string settle_samples(const GladGLContext& gl, const Target& target,
                           SamplePositions& positions) {
  const int samples = samples_of_framebuffer(gl);
  const std::string formats = text_of_formats(target.depth, target.stencil);
  if (samples == 0)
    return fmt::format("this driver has no {}x{} framebuffer with {} samples{}{}", target.width,
                       target.height, target.samples, formats.empty() ? "" : " and ", formats);
  if (samples != target.samples)
    return fmt::format("asked for {} samples, this driver makes {}", target.samples, samples);
  if (!target.sample_positions.empty())
    if (std::string problem = place_samples(gl, target.sample_positions); !problem.empty())
      return problem;
  positions = positions_of_framebuffer(gl, target);
  const auto is_within = [](Fixed place) { return place.raw() >= 0 && place.raw() < Fixed::kOne; };
  for (const Point& position : positions)
    if (!is_within(position.x) || !is_within(position.y))
      return "this driver reports sample positions outside the pixel";
  if (!target.sample_positions.empty() && positions != target.sample_positions)
    return "this driver does not place the samples where the case asks for them";
  return "";
}

}  // namespace

std::vector<int> find_sample_counts(const GladGLContext& gl) {
  std::vector<int> counts;
  if (is_es(gl) && !gl.ES_VERSION_3_1) return counts;  // it has no multisampled textures
  for (int samples : {2, 4, 8, 16}) {
    Target target;
    target.width = target.height = 1;
    target.samples = samples;
    const GlTexture image = make_image(gl, GL_RGBA8, target);
    const GlFramebuffer framebuffer = make_framebuffer_of(gl, image, {}, 0);
    if (samples_of_framebuffer(gl) == samples) counts.push_back(samples);
  }
  take_error(gl);
  return counts;
}

bool can_place_samples(const GladGLContext& gl) {
  return gl.ARB_sample_locations != 0 && gl.FramebufferParameteri != nullptr;
}

bool fits(const MultisampleTarget& made, const Target& target) {
  return made.width == target.width && made.height == target.height &&
         made.samples == target.samples && made.depth == target.depth &&
         made.stencil == target.stencil && made.placed == target.sample_positions;
}

std::string make_multisample_target(const GladGLContext& gl, const Target& target,
                                    MultisampleTarget& made) {
  made.width = target.width;
  made.height = target.height;
  made.samples = target.samples;
  made.depth = target.depth;
  made.stencil = target.stencil;
  made.placed = target.sample_positions;
  const DepthStencilStorage storage = storage_of(target.depth, target.stencil);
  if (storage.format != 0) made.depth_image = make_image(gl, storage.format, target);
  made.color_image = make_image(gl, GL_RGBA8, target);
  made.count_image = make_image(gl, GL_R32F, target);
  SamplePositions positions_of_count;
  made.count = make_framebuffer_of(gl, made.count_image, made.depth_image, storage.attachment);
  if (std::string problem = settle_samples(gl, target, positions_of_count); !problem.empty())
    return problem;
  made.color = make_framebuffer_of(gl, made.color_image, made.depth_image, storage.attachment);
  if (std::string problem = settle_samples(gl, target, made.positions); !problem.empty())
    return problem;
  if (positions_of_count != made.positions)
    return "this driver has other sample positions in R32F than in RGBA8";
  made.planes = planes_at_once(gl, target);
  const int rows = made.planes * target.height;
  if (make_single(gl, GL_RGBA8, target.width, target.height, made.resolved_image, made.resolved) &&
      make_single(gl, GL_RGBA8, target.width, rows, made.color_planes_image, made.color_planes) &&
      make_single(gl, GL_R32F, target.width, rows, made.float_planes_image, made.float_planes))
    return "";
  return fmt::format("this driver has no {}x{} framebuffer", target.width, rows);
}

}  // namespace edgecase
