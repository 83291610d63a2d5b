// SPDX-License-Identifier: MIT
//
// Images inside the HTML report: run-length coded pixels in base64.
//
// A report holds the exact image of every case and, of each renderer, only how it differs: the
// exclusive or of the two images, which is nearly all zero and so nearly free. The code is a
// sequence of packets: a variable-length number n (7 bits a byte, low bits first, top bit set while
// more follow); n odd: the four bytes of one pixel follow, n >> 1 times repeated; n even: n >> 1
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
