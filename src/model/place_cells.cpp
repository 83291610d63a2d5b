// SPDX-License-Identifier: MIT
#include "model/place_cells.h"

#include <algorithm>
#include <cmath>

namespace edgecase {

namespace {

constexpr std::string_view kDigits = "0123456789abcdef";
constexpr std::size_t kBits = 4;  // of a digit

}  // namespace

int PlaceCells::cell_of(double place) {
  return std::clamp(static_cast<int>(std::floor((place + 1) * kOfPixel)), 0, kSide - 1);
}

bool PlaceCells::meets(double x_low, double x_high, double y_low, double y_high) const {
  // A place on the border of two cells is of both.
  const auto first = [](double low) { return cell_of(std::nexttoward(low, -2.0L)); };
  for (int y = first(y_low); y <= cell_of(y_high); ++y)
    for (int x = first(x_low); x <= cell_of(x_high); ++x)
      if (bits_.test(index_of(x, y))) return true;
  return false;
}

std::string PlaceCells::text() const {
  std::string text;
  for (std::size_t at = 0; at < bits_.size(); at += kBits) {
    std::size_t digit = 0;
    for (std::size_t bit = 0; bit < kBits; ++bit)
      digit |= (bits_.test(at + bit) ? std::size_t{1} : 0) << bit;
    text += kDigits[digit];
  }
  return text;
}

std::optional<PlaceCells> PlaceCells::parse(std::string_view text) {
  PlaceCells cells;
  if (text.size() * kBits != cells.bits_.size()) return std::nullopt;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = kDigits.find(text[i]);
    if (digit == std::string_view::npos) return std::nullopt;
    for (std::size_t bit = 0; bit < kBits; ++bit)
      cells.bits_.set(i * kBits + bit, (digit >> bit & 1) != 0);
  }
  return cells;
}

}  // namespace edgecase
