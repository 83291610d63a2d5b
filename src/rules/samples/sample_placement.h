// SPDX-License-Identifier: MIT
//
// Where the samples of a pixel lie (GL 4.6 core, 14.3.1).
//
// An implementation puts them where it likes, the same in every pixel of a target whose locations
// are fixed, and says where with glGetMultisamplefv(GL_SAMPLE_POSITION); what it says is what
// coverage is held against. The other alternatives are what goes wrong: positions that are reported
// and not used, a pixel seen in a mirror, samples in another order.
//
// The standard patterns are those that D3D and Vulkan name: with n samples no two of them lie in
// the same of n columns or of n rows (of 16: of 16 columns). Their numbers are taken with y up, as
// the drivers that report them do. The pattern of 4 is a 2 x 2 grid turned by arctan(1/2).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/sampling.h"
#include "rules/rule.h"

namespace edgecase {

Rule sample_positions_rule();  // sample.positions

struct SamplePlacement {
  enum class Kind {
    as_reported,
    standard,      // the standard pattern, whatever is reported
    ordered_grid,  // of 4, 9 and 16 samples: rows of equal distances
    rotated_grid,  // of 4, 9 and 16 samples: the ordered grid turned so that no two share a row
    centre,        // all at the pixel's centre
    mirrored_x,    // left and right exchanged
    mirrored_y,    // top and bottom exchanged
    turned,        // both: by half a turn
    swapped,       // two samples exchanged
  };
  Kind kind = Kind::as_reported;
  int first = 0;  // of `swapped`: sample indices
  int second = 0;
  friend bool operator==(const SamplePlacement&, const SamplePlacement&) = default;
};

// The standard pattern. Counts other than 1, 2, 4, 8 and 16 take the first samples of the next
// larger pattern. samples: 1 to kMaxSamples.
SamplePositions standard_pattern(int samples);

// Where the samples lie that a renderer reports at these positions. A mirrored sample at 0 lies at
// 1, on the pixel's right or top side. Grids of other counts and a pair beyond the samples change
// nothing.
SamplePositions placed(const SamplePlacement& placement, const SamplePositions& reported);

// The placements of a count of samples that can differ: `as_reported` first, each swapped pair.
std::vector<SamplePlacement> placements_of(int samples);

// The alternative of sample.positions; every swapped pair has the same.
std::string name_of(const SamplePlacement& placement);
// False when there is none of that name. `swapped`: samples 0 and 1.
bool parse_name(std::string_view name, SamplePlacement& placement);

}  // namespace edgecase
