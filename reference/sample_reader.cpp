// SPDX-License-Identifier: MIT
#include "reference/sample_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/depth_buffer.h"
#include "reference/read_back.h"
#include "reference/sample_pass.h"
#include "reference/shaders.h"
#include "reference/stencil_buffer.h"

namespace edgecase {

namespace {

constexpr GLint kHeightUniform = 0;
constexpr GLint kFirstUniform = 1;
constexpr GLenum kImageOfSamples = GL_TEXTURE1;
constexpr const char* kFetchShader = R"(
layout(location = 0) uniform int height;
layout(location = 1) uniform int first;
layout(binding = 1) uniform sampler2DMS image;
layout(location = 0) out vec4 target;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  target = texelFetch(image, ivec2(at.x, at.y % height), first + at.y / height);
}
)";

// At scale 0, the depth is 1 everywhere. At scale 1, the highest row has the depths just below 1,
// and the others a ramp with every depth of 16 bits: the two conversions of a fetch differ for only
// 512 of them. The red channel marks where it was drawn.
constexpr GLint kScaleUniform = 0;
constexpr int kRampWidth = 256;  // pixels
constexpr int kRampHeight = 257;
constexpr const char* kDepthShader = R"(
layout(location = 0) uniform float scale;
layout(location = 0) out vec4 target;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float below = at.y == 256 ? float(at.x) * exp2(-24.0) : float(at.y * 256 + at.x) / 65535.0;
  gl_FragDepth = 1.0 - scale * below;
  target = vec4(1.0);
}
)";

// The result of fetching an integer of a depth buffer.
float fetched_from(double integer, double largest, DepthConversion conversion) {
  if (conversion == DepthConversion::quotient) return static_cast<float>(integer / largest);
  return static_cast<float>(integer) * static_cast<float>(1 / largest);
}

// The integer, nearest to the fetched number, whose fetch gives that number; nothing if there is
// none.
std::optional<double> integer_of(float fetched, double largest, DepthConversion conversion) {
  const double nearest = std::round(static_cast<double>(fetched) * largest);
  for (double integer : {nearest, nearest + 1, nearest - 1})
    if (integer >= 0 && integer <= largest && fetched_from(integer, largest, conversion) == fetched)
      return integer;
  return std::nullopt;
}

}  // namespace

std::variant<SampleReader, ProgramError> SampleReader::make(const GladGLContext& gl) {
  auto fetch = make_program(gl, shaders::kEverywhere, kFetchShader);
  if (auto* error = std::get_if<ProgramError>(&fetch)) return std::move(*error);
  auto depth = make_program(gl, shaders::kEverywhere, kDepthShader);
  if (auto* error = std::get_if<ProgramError>(&depth)) return std::move(*error);
  return SampleReader(gl, std::get<GlProgram>(std::move(fetch)),
                      std::get<GlProgram>(std::move(depth)));
}

SampleReader::SampleReader(const GladGLContext& gl, GlProgram fetch, GlProgram depth)
    : gl_(&gl),
      fetch_(std::move(fetch)),
      depth_(std::move(depth)),
      vertex_array_(make_vertex_array(gl)) {}

void SampleReader::fetch(const MultisampleTarget& target, const GlTexture& image,
                         const GlFramebuffer& planes, int first) const {
  begin_sample_pass(*gl_, vertex_array_, target.width, target.planes * target.height);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, planes.name());
  gl_->UseProgram(fetch_.name());
  gl_->Uniform1i(fetch_.location(kHeightUniform), target.height);
  gl_->Uniform1i(fetch_.location(kFirstUniform), first);
  gl_->ActiveTexture(kImageOfSamples);
  gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, image.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  // This image is drawn to again later, so it must not stay bound for reading.
  gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  gl_->ActiveTexture(GL_TEXTURE0);
}

std::vector<std::uint8_t> SampleReader::resolved(const MultisampleTarget& target) const {
  begin_sample_pass(*gl_, vertex_array_, target.width, target.height);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, target.color.name());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.resolved.name());
  gl_->BlitFramebuffer(0, 0, target.width, target.height, 0, 0, target.width, target.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.resolved.name());
  std::vector<std::uint8_t> pixels(4 * area_of(target));
  gl_->ReadPixels(0, 0, target.width, target.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

std::vector<std::uint8_t> SampleReader::colors(const MultisampleTarget& target) const {
  const std::size_t plane = 4 * area_of(target);
  std::vector<std::uint8_t> bytes(plane * static_cast<std::size_t>(target.samples));
  for (int first = 0; first < target.samples; first += target.planes) {
    fetch(target, target.color_image, target.color_planes, first);
    const int count = std::min(target.planes, target.samples - first);
    gl_->ReadPixels(0, 0, target.width, count * target.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    bytes.data() + plane * static_cast<std::size_t>(first));
  }
  return bytes;
}

std::vector<float> SampleReader::fetched_floats(const MultisampleTarget& target,
                                                const GlTexture& image) const {
  std::vector<float> floats(area_of(target) * static_cast<std::size_t>(target.samples));
  for (int first = 0; first < target.samples; first += target.planes) {
    fetch(target, image, target.float_planes, first);
    const int count = std::min(target.planes, target.samples - first);
    read_red(*gl_, Channels::floats, target.width, count * target.height,
             floats.data() + area_of(target) * static_cast<std::size_t>(first));
  }
  return floats;
}

std::vector<float> SampleReader::counts(const MultisampleTarget& target) const {
  return fetched_floats(target, target.count_image);
}

void SampleReader::draw_depths(const GlFramebuffer& framebuffer, int width, int height, GLenum test,
                               float scale) const {
  begin_sample_pass(*gl_, vertex_array_, width, height);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(test);
  gl_->DepthMask(GL_TRUE);
  gl_->UseProgram(depth_.name());
  gl_->Uniform1f(depth_.location(kScaleUniform), scale);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

// For each sample, whether its depth is 1, the largest.
std::vector<float> SampleReader::largest_depths(const MultisampleTarget& target) const {
  constexpr float kNone[] = {0, 0, 0, 0};
  begin_sample_pass(*gl_, vertex_array_, target.width, target.height);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.count.name());
  gl_->ClearBufferfv(GL_COLOR, 0, kNone);
  draw_depths(target.count, target.width, target.height, GL_EQUAL, 0);
  return counts(target);
}

std::optional<std::vector<double>> SampleReader::depths(const MultisampleTarget& target) const {
  const std::vector<float> fetched = fetched_floats(target, target.depth_image);
  std::vector<double> depths(fetched.begin(), fetched.end());
  if (holds_floats(target.depth)) return depths;
  const DepthConversion conversion =
      conversions_.at({target.depth, target.stencil, target.samples});
  const double largest = largest_depth(target.depth);
  for (double& depth : depths) {
    const auto integer = integer_of(static_cast<float>(depth), largest, conversion);
    if (!integer) return std::nullopt;
    depth = *integer / largest;
  }
  // The two largest integers may give the same number.
  if (fetched_from(largest - 1, largest, conversion) < 1 ||
      std::find(depths.begin(), depths.end(), 1.0) == depths.end())
    return depths;
  const std::vector<float> is_largest = largest_depths(target);
  for (std::size_t i = 0; i < depths.size(); ++i)
    if (depths[i] == 1 && is_largest[i] == 0) depths[i] = (largest - 1) / largest;
  return depths;
}

std::string SampleReader::doubt_of_depths(const Target& target) {
  if (target.depth == DepthFormat::none) return "";
  const Formats formats(target.depth, target.stencil, target.samples);
  auto found = doubts_.find(formats);
  if (found == doubts_.end()) found = doubts_.emplace(formats, prove(target)).first;
  return found->second;
}

std::string SampleReader::prove(const Target& asked) {
  Target target;
  target.width = kRampWidth;
  target.height = kRampHeight;
  target.samples = asked.samples;
  target.depth = asked.depth;
  target.stencil = asked.stencil;
  MultisampleTarget made;
  if (std::string problem = make_multisample_target(*gl_, target, made); !problem.empty())
    return problem;
  const std::string formats = text_of_formats(target.depth, target.stencil);
  const DepthStencilStorage storage = storage_of(target.depth, target.stencil);
  const GlRenderbuffer depth_image = make_renderbuffer(*gl_);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_image.name());
  gl_->RenderbufferStorage(GL_RENDERBUFFER, storage.format, kRampWidth, kRampHeight);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, made.resolved.name());
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, storage.attachment, GL_RENDERBUFFER,
                               depth_image.name());
  if (const std::string doubt = doubt_of_depth_buffer(*gl_, GL_DEPTH_ATTACHMENT, target.depth);
      !doubt.empty())
    return another_framebuffer(formats, doubt);
  draw_depths(made.color, kRampWidth, kRampHeight, GL_ALWAYS, 1);
  draw_depths(made.resolved, kRampWidth, kRampHeight, GL_ALWAYS, 1);
  const std::vector<double> plane = read_depths(*gl_, target.depth, kRampWidth, kRampHeight);
  std::vector<double> expected;
  for (int i = 0; i < target.samples; ++i)
    expected.insert(expected.end(), plane.begin(), plane.end());
  for (DepthConversion conversion : {DepthConversion::quotient, DepthConversion::product}) {
    conversions_[{target.depth, target.stencil, target.samples}] = conversion;
    if (depths(made) == expected) return "";
  }
  return another_framebuffer(formats, "its samples do not hold what a buffer without them holds");
}

}  // namespace edgecase
