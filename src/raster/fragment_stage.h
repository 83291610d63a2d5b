// SPDX-License-Identifier: MIT
//
// FragmentStage: what becomes of fragments, one sample at a time, by the rules in rules/output (GL
// 4.6 core, 17.3 and 17.4.2).
//
//   stencil test -> depth test -> blending -> colour mask -> planes of the rendering
//
// Which samples a fragment stands for, and the depth of each, it leaves to those who make it. It
// tells no fragments.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// A fragment as one of its samples has it.
struct SampleFragment {
  std::array<double, 4> color{};  // as the shader writes it
  double depth = 0;               // 0 to 1, of the sample
  bool front_facing = true;
  bool writes_depth = true;  // where the draw does
};

class FragmentStage {
 public:
  // Refers to all of them; the rendering's planes have been cleared.
  FragmentStage(Rendering& rendering, const Target& target, const OutputChoice& choice);

  // `sample`: as Rendering::sample_index has it. Counts a hit where all tests pass.
  void draw(const SampleFragment& fragment, const FragmentOperations& operations,
            std::size_t sample) const;
  // The same fragment at each of these pixels of a target with one sample each.
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
  // The latest colour that was written over whatever was there, and as what: the next one is mostly
  // the same.
  mutable std::array<double, 4> replacing_{};
  mutable Rgba8 replacement_{};
};

}  // namespace edgecase
