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
#include <string>
#include <vector>

namespace edgecase {

using Bytes = std::vector<std::uint8_t>;

std::string to_base64(const Bytes& bytes);

// Packs RGBA8 pixels; the size must be a multiple of 4.
Bytes pack_pixels(const Bytes& rgba);
// The inverse.
Bytes unpack_pixels(const Bytes& packed);

// Byte by byte exclusive or of two images of the same size.
Bytes difference_of(const Bytes& a, const Bytes& b);

}  // namespace edgecase
