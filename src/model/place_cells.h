// SPDX-License-Identifier: MIT
//
// A set of places for a sample: squares of 1/16 pixel in its pixel and in the eight around it.
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace edgecase {

class PlaceCells {
 public:
  static constexpr int kOfPixel = 16;         // cells along a side of a pixel
  static constexpr int kSide = 3 * kOfPixel;  // cells along a side of all

  // Places are in pixels from the lower left corner of the sample's pixel, from -1 to 2.
  void add(double x, double y) { bits_.set(index_of(cell_of(x), cell_of(y))); }
  // True if some cell has a place from x_low to x_high and y_low to y_high, borders included.
  bool meets(double x_low, double x_high, double y_low, double y_high) const;

  // Hexadecimal digits, and back; nothing for another text.
  std::string text() const;
  static std::optional<PlaceCells> parse(std::string_view text);

  friend bool operator==(const PlaceCells&, const PlaceCells&) = default;

 private:
  static int cell_of(double place);
  static std::size_t index_of(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }

  std::bitset<static_cast<std::size_t>(kSide) * kSide> bits_;
};

}  // namespace edgecase
