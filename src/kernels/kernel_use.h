// SPDX-License-Identifier: MIT
//
// Selects which kernels run, to compare results or to measure costs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// The names that `use_kernels` accepts: the compiled SIMD targets that this machine has, as Highway
// names them (AVX2, SSE4, ...), then "none".
std::vector<std::string> kernel_names();

// Restricts kernels to one target; with "none" the predicates and the plain stages decide
// everything. Returns false and changes nothing if the name is not one of kernel_names. Call it
// before other threads draw.
bool use_kernels(std::string_view name);

// Whether the latest choice is anything but "none".
bool kernels_are_used();

}  // namespace edgecase
