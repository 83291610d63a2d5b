// SPDX-License-Identifier: MIT
//
// Colours that a case file leaves open, salted by the case's id.
//
// If every case drew white on black, a renderer that answers a constant, or another case's image,
// would be right by accident. So each case gets colours of its own: a 64-bit hash (FNV-1a and a
// final mixing, so that every bit of the id reaches every bit of the hash) of its id yields
//  - the clear colour: red, green and blue k/255 with k from 0 to 63, alpha 1: dark;
//  - the colour of primitive p: brightest channel at least 192/255, dimmest at most 71/255,
//  alpha 1.
//    The hue turns by the golden ratio from one primitive to the next, about 138 degrees, so that
//    neighbours in drawing order never look alike; the three lowest bits of each channel are salt.
// The result depends on the id and on p alone, on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "model/scene.h"

namespace edgecase {

std::uint64_t hash_of_id(std::string_view id);

Color salted_clear(std::uint64_t hash);

// `primitive`: index in drawing order over all draws of the case.
Color salted_primitive(std::uint64_t hash, std::uint64_t primitive);

// Which of those colours each vertex of a draw has, counted from the draw's first: separate
// primitives have one each. The vertices of strips, loops and fans are shared, so that each vertex
// has one of its own, and hues of primitives that follow each other are a sixth of a turn apart at
// least, whichever vertex provokes; a loop's last segment and its first follow each other, too.
std::vector<std::uint64_t> salted_indices(Primitive primitive, std::size_t vertices);

}  // namespace edgecase
