// SPDX-License-Identifier: MIT
#include "reports/pixels.h"

#include <algorithm>
#include <cstddef>

namespace edgecase {
namespace {

constexpr std::size_t kPixel = 4;  // bytes

void put_number(Bytes& out, std::size_t number) {
  while (number >= 0x80) {
    out.push_back(static_cast<std::uint8_t>(number & 0x7F) | 0x80);
    number >>= 7;
  }
  out.push_back(static_cast<std::uint8_t>(number));
}

std::size_t take_number(const Bytes& bytes, std::size_t& at) {
  std::size_t number = 0;
  for (unsigned shift = 0; at < bytes.size(); shift += 7) {
    const std::uint8_t byte = bytes[at++];
    number |= static_cast<std::size_t>(byte & 0x7F) << shift;
    if (byte < 0x80) break;
  }
  return number;
}

// The number of equal pixels from byte `at` on.
std::size_t run_at(const Bytes& rgba, std::size_t at) {
  std::size_t end = at + kPixel;
  while (end + kPixel <= rgba.size() && std::equal(&rgba[at], &rgba[at] + kPixel, &rgba[end]))
    end += kPixel;
  return (end - at) / kPixel;
}

void append(Bytes& out, const Bytes& from, std::size_t begin, std::size_t end) {
  out.insert(out.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
             from.begin() + static_cast<std::ptrdiff_t>(end));
}

void put_literals(Bytes& out, const Bytes& rgba, std::size_t begin, std::size_t end) {
  if (begin == end) return;
  put_number(out, (end - begin) / kPixel << 1);
  append(out, rgba, begin, end);
}

}  // namespace

Bytes pack_pixels(const Bytes& rgba) {
  Bytes out;
  std::size_t pending = 0;  // first byte that is not written yet
  for (std::size_t at = 0; at + kPixel <= rgba.size();) {
    const std::size_t run = run_at(rgba, at);
    if (run > 1) {
      put_literals(out, rgba, pending, at);
      put_number(out, run << 1 | 1);
      append(out, rgba, at, at + kPixel);
      pending = at + run * kPixel;
    }
    at += run * kPixel;
  }
  put_literals(out, rgba, pending, rgba.size());
  return out;
}

Bytes unpack_pixels(const Bytes& packed) {
  Bytes out;
  for (std::size_t at = 0; at < packed.size();) {
    const std::size_t number = take_number(packed, at);
    const std::size_t count = number >> 1;
    const std::size_t stored = number & 1 ? kPixel : count * kPixel;
    if (at + stored > packed.size()) break;
    for (std::size_t i = 0; i < (number & 1 ? count : 1); ++i) append(out, packed, at, at + stored);
    at += stored;
  }
  return out;
}

}  // namespace edgecase
