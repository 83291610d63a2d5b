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
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "profile/values/value_scenes.h"
#include "rules/choices.h"

namespace edgecase {

// Some of a scene's fragments, evenly spread over their list.
struct SampledScene {
  struct Sample {
    PixelPosition pixel;
    int primitive = 0;
    std::array<double, 4> color{};
    // dFdx, dFdy, and their fine and coarse forms, if they are reported.
    std::array<std::optional<std::array<double, 4>>, kDerivatives> derivatives;
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
