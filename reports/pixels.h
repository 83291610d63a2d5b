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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgecase {

using Bytes = std::vector<std::uint8_t>;

// Packs RGBA8 pixels; the size must be a multiple of 4.
Bytes pack_pixels(const Bytes& rgba);
// The inverse.
Bytes unpack_pixels(const Bytes& packed);

// Byte by byte exclusive or of two pictures of the same size. Of one picture and its difference
// from another, the other one.
inline Bytes difference_of(const Bytes& a, const Bytes& b) {
  Bytes out(std::min(a.size(), b.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] ^ b[i];
  return out;
}

}  // namespace edgecase
