// SPDX-License-Identifier: MIT
//
// Which kernels run: for who wants to see that it makes no difference, or what it costs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

// What `use_kernels` takes: the SIMD targets that are compiled and that this machine has, by
// Highway's names (AVX2, SSE4, ...), and at last "none".
std::vector<std::string> kernel_names();

// From now on kernels run on this target alone; with "none" the predicates and the plain stages
// decide everything. False, and nothing is changed, where the name is none of kernel_names. To be
// called before anything is drawn by other threads.
bool use_kernels(std::string_view name);

// Is what was asked for last anything but "none"?
bool kernels_are_used();

}  // namespace edgecase
