// SPDX-License-Identifier: MIT
//
// Images inside the HTML report: run-length coded pixels in base64.
//
// A report holds the exact image of every case and, for each renderer, the exclusive or of its
// image and exact's, which is nearly all zero. The code is a sequence of packets. Each begins with
// a variable-length number n (7 bits a byte, low bits first, top bit set while more follow). If n
// is odd, one pixel of four bytes follows, which is repeated n >> 1 times; if n is even, n >> 1
// pixels follow. viewer/data.js reads it.
#pragma once

#include <cstdint>
#include <vector>

#include "results/base64.h"
#include "results/picture_difference.h"

namespace edgecase {

using Bytes = std::vector<std::uint8_t>;

// Packs RGBA8 pixels; the size must be a multiple of 4.
Bytes pack_pixels(const Bytes& rgba);
// The inverse.
Bytes unpack_pixels(const Bytes& packed);

}  // namespace edgecase
