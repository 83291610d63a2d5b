// SPDX-License-Identifier: MIT
//
// Anisotropic filters: several lookups along the longer vector of a footprint (GL 4.6 core, 8.14.1,
// with the text of EXT_texture_filter_anisotropic). Each lookup reads a finer level than that
// vector alone would select. OpenGL gives one method as an example. Implementations may use
// another, on levels that the sampler lets them access. Pmax and Pmin are the lengths of the
// vectors:
//
//   extension   N = min(ceil(Pmax / Pmin), max_anisotropy) lookups of equal weight at
//               i / (N + 1) - 1/2 of the longer vector, i = 1 to N, in the level log2(Pmax / N); N
//               is rounded down where max_anisotropy is not an integer
//   gaussian-5  a course's: five lookups at -2/5, -1/5, 0, 1/5, 2/5 of the longer vector, weights
//               proportional to exp(-2 (2x)^2) at x of it, in the level log2(max(Pmin, Pmax / 5))
//
// If the vectors have equal lengths, the one along y counts as the longer, as in the extension.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "exact/interval.h"
#include "rules/rule.h"
#include "rules/textures/level_of_detail.h"

namespace edgecase {

Rule anisotropy_rule();  // texture.anisotropy

enum class Anisotropy {
  extension,
  gaussian_5,
  none,  // as if max_anisotropy were 1
};
template <>
inline constexpr auto kNames<Anisotropy> = std::to_array<TabledAlternative<Anisotropy>>(
    {{Anisotropy::extension, "extension", Openness::open,
      "up to max_anisotropy lookups of equal weight along the longer vector; the level is that of "
      "its length divided by their number, as in the example of EXT_texture_filter_anisotropic"},
     {Anisotropy::gaussian_5, "gaussian-5", Openness::open,
      "five lookups with Gaussian weights along the longer vector; the level is that of the "
      "shorter "
      "vector or of a fifth of the longer one"},
     {Anisotropy::none, "none", Openness::open, "one lookup, whatever the sampler says"}});

// One lookup: how far along the longer vector from the footprint's centre, -1/2 to 1/2, and its
// share of the colour.
struct Probe {
  double offset;
  Interval weight;
};

struct ProbeRow {
  bool along_x = false;       // the longer vector is that along x; arbitrary for one probe
  Interval scale_factor;      // texels per pixel; its logarithm is lambda_base
  std::vector<Probe> probes;  // from -1/2 on; without anisotropy one at 0, of weight 1
};

// If the lengths are known only as intervals, their middles decide which is longer and how many
// lookups there are. `max_anisotropy` is 1 to 16; for 1, and under `none`, the scale factor is that
// of `isotropic`.
ProbeRow probes(const Footprint& footprint, float max_anisotropy, Anisotropy choice,
                ScaleFactor isotropic);

}  // namespace edgecase
