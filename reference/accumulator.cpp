// SPDX-License-Identifier: MIT
#include "reference/accumulator.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "reference/depth_buffer.h"
#include "reference/draw_state.h"
#include "reference/shaders.h"

namespace edgecase {

namespace {

constexpr GLint kNumberUniform = 0;
constexpr GLenum kSourceUnit = GL_TEXTURE1;
constexpr const char* kSource = R"(
layout(location = 0) uniform float number;
layout(binding = 1) uniform sampler2D image;
layout(location = 0) out vec4 target;
)";
constexpr const char* kProduct = R"(
void main() { target = texelFetch(image, ivec2(gl_FragCoord.xy), 0) * number; }
)";
constexpr const char* kQuotient = R"(
void main() { target = texelFetch(image, ivec2(gl_FragCoord.xy), 0) / number; }
)";

// Colours and weights whose products and sums are all float32 numbers that need all 24 digits, and
// which lie outside [0, 1].
constexpr std::array<Color, 2> kProven = {{{-2.5F, 0x1p-20F, 0x1p21F, 1}, {1, 1, 1, 0.75F}}};
constexpr std::array<std::int64_t, 2> kProvenWeights = {7, 1};
constexpr std::array<double, 4> kProvenSum = {-16.5, 7 * 0x1p-20 + 1, 7 * 0x1p21 + 1, 7.75};

}  // namespace

std::string Accumulator::compile() {
  const std::pair<GlProgram*, const char*> wanted[] = {{&product_, kProduct},
                                                       {&quotient_, kQuotient}};
  for (const auto& [program, text] : wanted) {
    auto made = make_program(*gl_, shaders::kEverywhere, std::string(kSource) + text);
    if (auto* error = std::get_if<ProgramError>(&made)) return std::move(error->message);
    *program = std::get<GlProgram>(std::move(made));
  }
  vertex_array_ = make_vertex_array(*gl_);
  return "";
}

bool Accumulator::make_image(Image& image) {
  image.texture = make_texture(*gl_);
  gl_->ActiveTexture(kSourceUnit);
  gl_->BindTexture(GL_TEXTURE_2D, image.texture.name());
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width_, height_, 0, GL_RGBA, GL_FLOAT, nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->BindTexture(GL_TEXTURE_2D, 0);
  gl_->ActiveTexture(GL_TEXTURE0);
  image.framebuffer = make_framebuffer(*gl_);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, image.framebuffer.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                            image.texture.name(), 0);
  return gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

std::string Accumulator::make(const Target& target) {
  width_ = target.width;
  height_ = target.height;
  depth_ = target.depth;
  bool complete = make_image(sum_);
  bytes_image_ = make_renderbuffer(*gl_);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, bytes_image_.name());
  gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
  bytes_ = make_framebuffer(*gl_);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, bytes_.name());
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               bytes_image_.name());
  complete = complete && gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  complete = make_image(pass_) && complete;
  if (depth_ != DepthFormat::none) {
    depth_image_ = make_renderbuffer(*gl_);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_image_.name());
    gl_->RenderbufferStorage(GL_RENDERBUFFER, storage_of(depth_), width_, height_);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                 depth_image_.name());
    complete = complete && gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  if (complete) return "";
  width_ = 0;
  return fmt::format("this driver has no {}x{} framebuffer of 32-bit floating-point colours{}",
                     target.width, target.height,
                     depth_ == DepthFormat::none ? "" : std::string(" with ") + name_of(depth_));
}

std::string Accumulator::prove() {
  if (std::string problem = compile(); !problem.empty()) return problem;
  Target one;
  one.width = 1;
  one.height = 1;
  if (std::string problem = make(one); !problem.empty()) return problem;
  constexpr Color kNothing = {0, 0, 0, 0};
  clear(*gl_, sum_.framebuffer.name(), kNothing);
  for (std::size_t k = 0; k < kProven.size(); ++k) {
    clear(*gl_, pass(), kProven[k]);
    add(kProvenWeights[k]);
  }
  std::array<float, 4> sum{};
  gl_->BindFramebuffer(GL_FRAMEBUFFER, sum_.framebuffer.name());
  gl_->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, sum.data());
  width_ = 0;
  if (const GLenum error = take_error(*gl_); error != GL_NO_ERROR)
    return fmt::format("adding 32-bit floating-point colours by blending raised {}",
                       name_of_error(error));
  for (std::size_t c = 0; c < sum.size(); ++c)
    if (static_cast<double>(sum[c]) != kProvenSum[c])
      return "this driver does not add 32-bit floating-point colours by blending: what should be " +
             fmt::format("{:.9g} is {:.9g}", kProvenSum[c], sum[c]);
  return "";
}

std::string Accumulator::begin(const Target& target) {
  if (!problem_) problem_ = prove();
  if (!problem_->empty()) return *problem_;
  const bool fits = width_ == target.width && height_ == target.height && depth_ == target.depth;
  if (!fits)
    if (std::string problem = make(target); !problem.empty()) return problem;
  constexpr Color kNothing = {0, 0, 0, 0};
  clear(*gl_, sum_.framebuffer.name(), kNothing);
  total_ = 0;
  return "";
}

void Accumulator::set_state() {
  constexpr GLenum kSwitchedOff[] = {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_DITHER,
                                     GL_CULL_FACE};
  for (GLenum off : kSwitchedOff) gl_->Disable(off);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->BindVertexArray(vertex_array_.name());
  gl_->Viewport(0, 0, width_, height_);
}

void Accumulator::draw(const GlProgram& program, double number, const Image& from, GLuint to) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, to);
  gl_->UseProgram(program.name());
  gl_->Uniform1f(program.location(kNumberUniform), static_cast<float>(number));
  gl_->ActiveTexture(kSourceUnit);
  gl_->BindTexture(GL_TEXTURE_2D, from.texture.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  // This image is drawn to again later, so it must not stay bound for reading.
  gl_->BindTexture(GL_TEXTURE_2D, 0);
  gl_->ActiveTexture(GL_TEXTURE0);
}

void Accumulator::add(std::int64_t weight) {
  set_state();
  gl_->Enable(GL_BLEND);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFunc(GL_ONE, GL_ONE);
  draw(product_, static_cast<double>(weight), pass_, sum_.framebuffer.name());
  gl_->Disable(GL_BLEND);
  total_ += weight;
}

void Accumulator::read(Rendering& rendering) {
  set_state();
  std::vector<float> mean(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  // The last pass has been added, so its image is free for the mean.
  draw(quotient_, static_cast<double>(total_), sum_, pass());
  gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, mean.data());
  rendering.accumulated.assign(mean.begin(), mean.end());
  draw(product_, 1, pass_, bytes_.name());
  rendering.pixels.resize(mean.size());
  gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rendering.pixels.data());
}

}  // namespace edgecase
