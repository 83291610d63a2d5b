// SPDX-License-Identifier: MIT
//
// Value traits: which alternatives of the rules for attributes a renderer follows.
//
// A sample votes for the alternative whose exact value is nearest to the rendered one, where the
// alternatives differ by more than inexact arithmetic could make up (ruling 9, with the vertices
// where each alternative has them). Renderings are looked at one by one; samples of them are kept.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "exact/pixel.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/profile.h"
#include "rules/choices.h"

namespace edgecase {

// Some of a scene's fragments, evenly spread over their list.
struct SampledScene {
  struct Sample {
    PixelPosition pixel;
    int primitive = 0;
    std::array<double, 4> color{};
    // dFdx, dFdy, and their fine and coarse forms, where they are told.
    std::array<std::optional<std::array<double, 4>>, kDerivatives> derivatives;
  };
  Scene scene;
  std::vector<Sample> samples;
};

SampledScene sampled(Scene scene, const Rendering& rendering, std::size_t most);

struct ValueTraits {
  std::vector<Trait> traits;  // attribute.perspective, attribute.smooth, attribute.positions
  ValueChoice values;         // what was found, all else as `found` had it
};

// `found`: what is known so far: coverage and snapping.
ValueTraits infer_values(const std::vector<SampledScene>& scenes, const RuleChoices& found);

// derivative.plain, derivative.fine, derivative.coarse: the method that yields most samples, in x
// and in y, every operation inexact. Only samples that some methods yield and some do not count.
ValueTraits infer_derivatives(const std::vector<SampledScene>& scenes, const RuleChoices& found);

// framebuffer.depth:FORMAT, how depths are converted: by what the depth buffer holds where the
// fragment's own depth, as it is told, lies between two values of the format.
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

}  // namespace edgecase
