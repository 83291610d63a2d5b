// SPDX-License-Identifier: MIT
//
// FragmentStage: applies the per-fragment operations of rules/output to one sample at a time (GL
// 4.6 core, 17.3 and 17.4.2).
//
//   stencil test -> depth test -> blending -> colour mask -> planes of the rendering
//
// Callers decide which samples a fragment stands for, and the depth of each. This stage reports no
// fragments.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// A fragment's values at one of its samples.
struct SampleFragment {
  std::array<double, 4> color{};  // the shader's output
  double depth = 0;               // 0 to 1, at the sample
  bool front_facing = true;
  bool writes_depth = true;  // if the draw writes depth at all
};

class FragmentStage {
 public:
  // Refers to all arguments; the rendering's planes must have been cleared.
  FragmentStage(Rendering& rendering, const Target& target, const OutputChoice& choice);

  // `sample` as in Rendering::sample_index. Counts a hit if all tests pass.
  void draw(const SampleFragment& fragment, const FragmentOperations& operations,
            std::size_t sample) const;
  // Draws the same fragment at each of these pixels; the target has one sample per pixel.
  void draw_at_all(const SampleFragment& fragment, const FragmentOperations& operations,
                   std::span<const PixelPosition> pixels) const;

 private:
  bool passes_tests(const SampleFragment& fragment, const FragmentOperations& operations,
                    std::size_t sample) const;
  bool passes_depth(double depth, const DepthTest& test, std::size_t sample) const;
  void write_color(const SampleFragment& fragment, const FragmentOperations& operations,
                   std::size_t sample) const;

  Rendering& rendering_;
  const Target& target_;
  const OutputChoice& choice_;
  // The latest colour that replaced a pixel, and its code. The next colour is usually the same.
  mutable std::array<double, 4> replacing_{};
  mutable Rgba8 replacement_{};
};

}  // namespace edgecase
