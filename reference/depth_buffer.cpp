// SPDX-License-Identifier: MIT
#include "reference/depth_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/gl_api.h"

namespace edgecase {

namespace {

// The 32-bit integer for a depth of 1.
constexpr double kLargest32 = 4294967295.0;

int bits_of(DepthFormat format) {
  switch (format) {
    case DepthFormat::none:
      return 0;
    case DepthFormat::depth16:
      return 16;
    case DepthFormat::depth24:
      return 24;
    case DepthFormat::depth32f:
      return 32;
  }
  return 0;
}

std::string doubt_of_claims(const GladGLContext& gl, GLenum attachment, DepthFormat format) {
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return "it has no depth buffer";
  const GLint bits = ask(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  if (bits != bits_of(format)) return fmt::format("its depth buffer has {} bits", bits);
  const bool is_float = ask(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  if (is_float != holds_floats(format))
    return fmt::format("its depth buffer holds {}", is_float ? "floats" : "integers");
  return "";
}

// The stored depth of the lowest left pixel. OpenGL ES reads floats only from float buffers.
double read_depth(const GladGLContext& gl, bool is_float) {
  if (is_es(gl) && !is_float) {
    GLuint expanded = 0;
    gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &expanded);
    return expanded / kLargest32;
  }
  float read = 0;
  gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &read);
  return static_cast<double>(read);
}

// Clears to a depth between the integers 1 and 2, where float32 numbers are dense.
std::string doubt_of_contents(const GladGLContext& gl, DepthFormat format) {
  const bool is_float = holds_floats(format);
  const double largest = is_float ? 65535 : largest_depth(format);
  const auto cleared = static_cast<float>(1.375 / largest);
  gl.Disable(GL_SCISSOR_TEST);
  gl.DepthMask(GL_TRUE);
  gl.ClearBufferfv(GL_DEPTH, 0, &cleared);
  const double read = read_depth(gl, is_float);
  const double steps = read * largest;
  const bool is_integer = std::abs(steps - std::round(steps)) < 0.125;
  if (is_float ? read == static_cast<double>(cleared) : is_integer) return "";
  return fmt::format("its depth buffer, cleared to {}, holds {}", cleared, read);
}

}  // namespace

GLenum storage_of(DepthFormat format) {
  switch (format) {
    case DepthFormat::none:
      return 0;
    case DepthFormat::depth16:
      return GL_DEPTH_COMPONENT16;
    case DepthFormat::depth24:
      return GL_DEPTH_COMPONENT24;
    case DepthFormat::depth32f:
      return GL_DEPTH_COMPONENT32F;
  }
  return 0;
}

double largest_depth(DepthFormat format) {
  return std::ldexp(1.0, bits_of(format)) - 1;
}

std::string another_framebuffer(const std::string& formats, const std::string& doubt) {
  return fmt::format("asked for {}, this driver makes another framebuffer: {}", formats, doubt);
}

std::string doubt_of_depth_buffer(const GladGLContext& gl, GLenum attachment, DepthFormat format) {
  std::string doubt = doubt_of_claims(gl, attachment, format);
  return doubt.empty() ? doubt_of_contents(gl, format) : doubt;
}

std::vector<double> read_depths(const GladGLContext& gl, DepthFormat format, int width,
                                int height) {
  const std::size_t area = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (holds_floats(format)) {
    std::vector<float> floats(area);
    gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, floats.data());
    return {floats.begin(), floats.end()};
  }
  // Fewer bits are expanded to 32, by repetition or multiplication. In both cases the stored
  // integer is the nearest one.
  const double largest = largest_depth(format);
  std::vector<GLuint> expanded(area);
  gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, expanded.data());
  std::vector<double> depths(area);
  std::transform(expanded.begin(), expanded.end(), depths.begin(), [&](GLuint value) {
    return std::round(value * (largest / kLargest32)) / largest;
  });
  return depths;
}

}  // namespace edgecase
