// SPDX-License-Identifier: MIT
//
// Where the samples of a pixel lie (GL 4.6 core, 14.3.1).
//
// An implementation chooses the locations. They are the same in every pixel of a target with fixed
// sample locations. glGetMultisamplefv(GL_SAMPLE_POSITION) reports them, and coverage is compared
// with what it reports. The other alternatives are known faults: locations that are reported and
// not used, a mirrored pixel, samples in another order.
//
// The standard patterns are those of D3D and Vulkan. In the pattern of n samples no two share one
// of n columns or one of n rows. The patterns are read with y up, as the drivers that report them
// do. The pattern of 4 is a 2 x 2 grid turned by arctan(1/2).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/sampling.h"
#include "rules/rule.h"

namespace edgecase {

Rule sample_positions_rule();  // sample.positions
inline constexpr int kRulingOnOtherPlaces = 47;
inline constexpr int kRulingOnSharedPlaces = 62;
inline constexpr int kRulingOnOnePlace = 65;

struct SamplePlacement {
  enum class Kind {
    as_reported,
    standard,      // the standard pattern, whatever the driver reports
    ordered_grid,  // for 4, 9 and 16 samples: rows of equal distances
    rotated_grid,  // for 4, 9 and 16 samples: the ordered grid turned so that no two share a row
    centre,        // all at the pixel's centre
    mirrored_x,    // left and right exchanged
    mirrored_y,    // top and bottom exchanged
    turned,        // both: half a turn
    swapped,       // two samples exchanged
  };
  Kind kind = Kind::as_reported;
  int first = 0;  // for `swapped`: sample indices
  int second = 0;
  friend bool operator==(const SamplePlacement&, const SamplePlacement&) = default;
};
template <>
inline constexpr auto kNames<SamplePlacement::Kind> = std::to_array<
    TabledAlternative<SamplePlacement::Kind>>(
    {{SamplePlacement::Kind::as_reported, "as-reported", Openness::mandated,
      "where the renderer reports them; without a report, where the case puts them, else the "
      "standard pattern"},
     {SamplePlacement::Kind::standard, "standard", Openness::illegal,
      "the pattern that D3D and Vulkan call standard, although other positions are reported"},
     {SamplePlacement::Kind::ordered_grid, "ordered-grid", Openness::illegal,
      "rows and columns at equal distances, for 4, 9 and 16 samples"},
     {SamplePlacement::Kind::rotated_grid, "rotated-grid", Openness::illegal,
      "the ordered grid of 4, 9 and 16 samples, turned so that no two share a row or a column; for "
      "4 samples it is the standard pattern"},
     {SamplePlacement::Kind::centre, "centre", Openness::illegal,
      "all samples at the pixel's centre"},
     {SamplePlacement::Kind::mirrored_x, "mirrored-x", Openness::illegal,
      "left and right exchanged"},
     {SamplePlacement::Kind::mirrored_y, "mirrored-y", Openness::illegal,
      "top and bottom exchanged"},
     {SamplePlacement::Kind::turned, "turned", Openness::illegal,
      "turned by 180 degrees about the pixel's centre"},
     {SamplePlacement::Kind::swapped, "swapped", Openness::illegal,
      "two samples exchanged; a policy that names it exchanges samples 0 and 1"}});

// The standard pattern. Counts other than 1, 2, 4, 8 and 16 take the first samples of the next
// larger pattern. samples: 1 to kMaxSamples.
SamplePositions standard_pattern(int samples);

// The true positions of the samples of a renderer that reports these positions. A mirrored sample
// at 0 lies at 1, on the pixel's right or top side. Grids for other counts, and a pair beyond the
// samples, change nothing.
SamplePositions placed(const SamplePlacement& placement, const SamplePositions& reported);

// The distinct placements of a count of samples: `as_reported` first, then each swapped pair.
std::vector<SamplePlacement> placements_of(int samples);

// The alternative of sample.positions; all swapped pairs have the same one.
std::string name_of(const SamplePlacement& placement);
// False if there is none of that name. `swapped`: samples 0 and 1.
bool parse_name(std::string_view name, SamplePlacement& placement);

}  // namespace edgecase
