// SPDX-License-Identifier: MIT
//
// Blending without an error: the 8-bit value nearest to what the formula yields.
//
// Most results lie well between the borders at which values round one way or the other, and an
// interval tells; those that do not are asked again as quotients of integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/fragment_operations.h"

namespace edgecase {

// A component's nearest value, a tie to the even one. Source and constant: finite; they are clamped
// to 0 to 1.
std::uint8_t exactly_blended(const BlendTerm& term, const std::array<double, 4>& source,
                             const std::array<std::uint8_t, 4>& destination,
                             const std::array<float, 4>& constant, std::size_t component);

}  // namespace edgecase
