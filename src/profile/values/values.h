// SPDX-License-Identifier: MIT
//
// Values: how a renderer interpolates attributes, takes derivatives and stores depths, and how far
// its fragments' values are from the exact ones.
//
//   samples of renderings -> traits, derivatives, depth buffers -> all fragments -> errors
//
// A sample votes for the alternative with the nearest exact value, provided that the alternatives
// differ by more than inexact arithmetic explains (ruling 9, with each alternative's vertices).
// Renderings are processed one by one; only samples of them are kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "generate/random_scenes.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "rules/choices.h"

namespace edgecase {

// Random scenes for measuring values: colours, depths, derivatives, depth buffers.
//
// Each depends only on its seed and index, like those of generate/random_scenes.h, with the same
// shapes and grids. The inputs of interpolation vary as well: colours in 0 to 1 and beyond, through
// zero, of tiny and of huge ranges, constant; any depths; equal w or ratios up to 2^16.
//
// OpenGL gets the exact numbers: (window position - centre) / (size / 2) * w is a float32 number,
// and so is z * w. Every w is a power of two times 1, 3, 5 or 7, and just a power of two if the odd
// factor would take bits that the coordinates need.

// A primitive and its interpolation; errors are counted separately for each mode.
struct ValueMode {
  PrimitiveKind kind = PrimitiveKind::triangle;  // a triangle or lines
  Interpolation interpolation = Interpolation::smooth;
  bool perspective = false;  // the w of a primitive differ
};

// Triangles, then lines.
std::span<const ValueMode> all_value_modes();
// "triangle smooth", "line noperspective, w differ", …
std::string name_of(const ValueMode& mode);

// Scenes of different purposes are independent.
enum class ValuePurpose { traits, errors };

struct ValueScenes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  ValueMode mode;
  ValuePurpose purpose = ValuePurpose::errors;
};

// One draw: a triangle, or kLinesPerScene separate lines, all with extent. If the w differ and
// colours are noperspective, gl_FragCoord is requested.
constexpr int kLinesPerScene = 24;
Scene value_scene(const ValueScenes& of, std::uint64_t index);

// A triangle of some hundred pixels with ratios of w from 4 up, so that derivative methods differ;
// requests the derivatives. The target's height is even or odd.
Scene derivative_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// A large triangle with depths spread over 0 to 1, on a target with a depth buffer.
Scene depth_scene(std::uint64_t seed, Surface surface, DepthFormat format, std::uint64_t index);

// Some of a scene's fragments, evenly spread over their list.
struct SampledScene {
  struct Sample {
    PixelPosition pixel;
    int primitive = 0;
    std::array<double, 4> color{};
    DerivativeValues derivatives;
  };
  Scene scene;
  std::vector<Sample> samples;
};
SampledScene sampled(Scene scene, const Rendering& rendering, std::size_t most);

// derivative.plain, derivative.fine, derivative.coarse: the method that yields most samples, in x
// and in y, with every operation inexact; and derivative.quad-rows. Only samples that some methods
// yield and some do not count.
std::vector<Trait> infer_derivatives(std::span<const SampledScene> scenes, RuleChoices& found);

// framebuffer.depth:FORMAT, how depths are converted: by the depth buffer's value where the
// fragment's own depth lies between two values of the format.
class DepthTrait {
 public:
  explicit DepthTrait(DepthFormat format) : format_(format) {}
  void add(const Rendering& rendering);
  void add_failure(const std::string& reason);
  Trait trait() const;

 private:
  DepthFormat format_;
  std::array<std::size_t, 3> agreeing_{};  // nearest, truncate, up
  std::size_t of_ = 0;
  std::size_t neither_ = 0;
  std::string failure_;
};

// Counts the errors of one surface.
class ValueErrorTable {
 public:
  // `found`: what the renderer was found to follow. `bits`: as in ruling 4.
  ValueErrorTable(const RuleChoices& found, int bits);

  // Adds the rendering of one scene of a mode.
  void add(const ValueMode& mode, const std::string& id, const Scene& scene,
           const Rendering& rendering);

  // In the order in which modes were added.
  std::vector<ValueErrors>& rows() { return rows_; }

 private:
  ValueErrors& row(const std::string& attribute, ValueKind kind, bool as_found);

  RuleChoices lawful_;
  RuleChoices found_;
  int bits_;
  std::vector<ValueErrors> rows_;
};

// The value that a renderer reports for a fragment; nothing if it reports none.
std::optional<double> reported(const Rendering& rendering, const Fragment& fragment, ValueKind kind,
                               int component);

// The number of scenes in which errors are counted, for each mode.
std::size_t error_scene_count(std::size_t scenes_per_kind);

extern const Subject kValueSubject;

}  // namespace edgecase
