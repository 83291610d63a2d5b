// SPDX-License-Identifier: MIT
//
// The colour that a pixel, a sample or a fragment should have: exact's, and the bounds of what a
// renderer may have instead, by the renderer's own fragments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/interval.h"
#include "model/rendering.h"
#include "model/rule_id.h"
#include "model/scene.h"

namespace edgecase {

class ValueContext;

// Component by component, before conversion to 8 bits.
struct PixelTruth {
  // Wider bounds, beyond `permitted`, that a contested ruling accepts.
  struct Contested {
    RuleId rule{};
    int ruling = 0;
    std::array<Interval, 4> bounds{};
  };

  std::array<double, 4> exact{};
  std::array<Interval, 4> permitted{};
  std::vector<Contested> contested{};  // the narrowest first
};

PixelTruth truth_of_clear(const Scene& scene);

// The colour that the renderer reported, or all that it may have had if it reported none.
PixelTruth truth_of_fragment(const ValueContext& context, const Fragment& fragment);

// The permitted component, with all that a contested ruling accepts.
Interval accepted(const PixelTruth& truth, std::size_t component);

// True if a fragment's alpha may be changed after the shader: that of a multisampled point smaller
// than the fade threshold, which is 1, may be multiplied by the square of the size (GL 4.6 core,
// 14.4, equation 14.2, and 17.2).
bool may_fade(const ValueContext& context, const Fragment& fragment);
// An alpha, with all values to which it may fade.
Interval with_fade(const ValueContext& context, const Fragment& fragment, Interval alpha);

// True if the fragment has its provoking vertex' own colour, which no interpolation and no texture
// changes.
bool has_flat_color(const ValueContext& context, const Fragment& fragment);

// Planes like Rendering::sample_pixels. `nearest` is the most likely, and each sample holds a value
// between `low` and `high`, both inclusive.
struct SamplePlanes {
  std::vector<std::uint8_t> low;
  std::vector<std::uint8_t> nearest;
  std::vector<std::uint8_t> high;
};

// Whether to assume that ruling 33 on alphas of 0 and 1 was heeded, if no hits show which samples
// alpha to coverage has left.
enum class AlphaEnds { heeded, open };

}  // namespace edgecase
