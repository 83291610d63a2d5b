// SPDX-License-Identifier: MIT
#include "reference/sample_stencils.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "reference/depth_buffer.h"
#include "reference/read_back.h"
#include "reference/sample_pass.h"
#include "reference/shaders.h"
#include "reference/stencil_buffer.h"

namespace edgecase {

namespace {

constexpr int kProvenWidth = 3;  // pixels
constexpr int kProvenHeight = 2;

constexpr GLint kHeightUniform = 0;
constexpr GLint kFirstUniform = 1;
constexpr GLenum kImageOfSamples = GL_TEXTURE1;
constexpr const char* kFetchShader = R"(
layout(location = 0) uniform int height;
layout(location = 1) uniform int first;
layout(binding = 1) uniform usampler2DMS image;
layout(location = 0) out vec4 target;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint stencil = texelFetch(image, ivec2(at.x, at.y % height), first + at.y / height).r;
  target = vec4(float(min(stencil, 256u)), 0.0, 0.0, 0.0);
}
)";
constexpr const char* kNothingShader = R"(
layout(location = 0) out vec4 target;
void main() { target = vec4(0.0); }
)";

// Differs between samples in most bits.
std::uint8_t proven_stencil(int sample, std::uint8_t flipped) {
  return static_cast<std::uint8_t>((0x5a + 37 * sample) ^ flipped);
}

}  // namespace

std::variant<SampleStencils, ProgramError> SampleStencils::make(const GladGLContext& gl) {
  auto fetch = make_program(gl, shaders::kEverywhere, kFetchShader);
  if (auto* error = std::get_if<ProgramError>(&fetch)) return std::move(*error);
  auto nothing = make_program(gl, shaders::kEverywhere, kNothingShader);
  if (auto* error = std::get_if<ProgramError>(&nothing)) return std::move(*error);
  return SampleStencils(gl, std::get<GlProgram>(std::move(fetch)),
                        std::get<GlProgram>(std::move(nothing)));
}

SampleStencils::SampleStencils(const GladGLContext& gl, GlProgram fetch, GlProgram nothing)
    : gl_(&gl),
      fetch_(std::move(fetch)),
      nothing_(std::move(nothing)),
      vertex_array_(make_vertex_array(gl)) {}

void SampleStencils::fetch(const MultisampleTarget& target, int first) const {
  begin_sample_pass(*gl_, vertex_array_, target.width, target.planes * target.height);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.float_planes.name());
  gl_->UseProgram(fetch_.name());
  gl_->Uniform1i(fetch_.location(kHeightUniform), target.height);
  gl_->Uniform1i(fetch_.location(kFirstUniform), first);
  gl_->ActiveTexture(kImageOfSamples);
  gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, target.depth_image.name());
  const bool packed = target.depth != DepthFormat::none;
  const auto set_mode = [&](GLint mode) {
    if (packed) gl_->TexParameteri(GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH_STENCIL_TEXTURE_MODE, mode);
  };
  set_mode(GL_STENCIL_INDEX);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  set_mode(GL_DEPTH_COMPONENT);
  // This image is drawn to again later, so it must not stay bound for reading.
  gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  gl_->ActiveTexture(GL_TEXTURE0);
}

std::vector<std::uint8_t> SampleStencils::read(const MultisampleTarget& target) const {
  std::vector<float> floats(area_of(target) * static_cast<std::size_t>(target.samples));
  for (int first = 0; first < target.samples; first += target.planes) {
    fetch(target, first);
    const int count = std::min(target.planes, target.samples - first);
    read_red(*gl_, Channels::floats, target.width, count * target.height,
             floats.data() + area_of(target) * static_cast<std::size_t>(first));
  }
  const auto is_stencil = [](float value) { return value >= 0 && value <= 255; };
  if (!std::all_of(floats.begin(), floats.end(), is_stencil)) return {};
  std::vector<std::uint8_t> stencils(floats.size());
  std::transform(floats.begin(), floats.end(), stencils.begin(),
                 [](float value) { return static_cast<std::uint8_t>(value); });
  return stencils;
}

void SampleStencils::write_samples(const MultisampleTarget& target, std::uint8_t flipped) const {
  begin_sample_pass(*gl_, vertex_array_, target.width, target.height);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.color.name());
  gl_->UseProgram(nothing_.name());
  gl_->Enable(GL_STENCIL_TEST);
  gl_->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  gl_->Enable(GL_SAMPLE_MASK);
  for (int sample = 0; sample < target.samples; ++sample) {
    gl_->SampleMaski(0, GLbitfield{1} << sample);
    gl_->StencilFunc(GL_ALWAYS, proven_stencil(sample, flipped), 0xff);
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  }
  gl_->SampleMaski(0, ~GLbitfield{0});
  gl_->Disable(GL_SAMPLE_MASK);
  gl_->StencilFunc(GL_ALWAYS, 0, 0xff);
  gl_->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl_->Disable(GL_STENCIL_TEST);
}

std::string SampleStencils::doubt_of(const Target& target) {
  const std::tuple formats(target.depth, target.stencil, target.samples);
  auto found = doubts_.find(formats);
  if (found == doubts_.end()) found = doubts_.emplace(formats, prove(target)).first;
  return found->second;
}

std::string SampleStencils::prove(const Target& asked) const {
  Target target;
  target.width = kProvenWidth;
  target.height = kProvenHeight;
  target.samples = asked.samples;
  target.depth = asked.depth;
  target.stencil = asked.stencil;
  MultisampleTarget made;
  if (std::string problem = make_multisample_target(*gl_, target, made); !problem.empty())
    return problem;
  for (std::uint8_t flipped : {std::uint8_t{0}, std::uint8_t{0xff}}) {
    write_samples(made, flipped);
    std::vector<std::uint8_t> expected;
    for (int sample = 0; sample < target.samples; ++sample)
      expected.insert(expected.end(), area_of(made), proven_stencil(sample, flipped));
    if (read(made) != expected)
      return another_framebuffer(text_of_formats(target.depth, target.stencil),
                                 "its samples do not hold the stencils that were written to them");
  }
  return "";
}

}  // namespace edgecase
