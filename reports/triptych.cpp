// SPDX-License-Identifier: MIT
#include "reports/triptych.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace edgecase {
namespace {

using Color = std::array<int, 3>;

constexpr int kSide = 320;     // of an enlarged picture, about
constexpr int kGap = 8;        // between two, enlarged
constexpr int kHaloBelow = 4;  // enlargement
constexpr int kHalo = 2;       // pixels round one that differs
constexpr Color kFrame = {128, 128, 128};

constexpr Color color_of(DisagreementKind kind) {
  switch (kind) {
    case DisagreementKind::missing:
      return {43, 140, 255};
    case DisagreementKind::extra:
      return {255, 107, 26};
    case DisagreementKind::duplicate:
      return {207, 91, 230};
    case DisagreementKind::value:
      break;
  }
  return {18, 179, 155};
}

// Share of `color`, in 256ths, over the other one.
constexpr Color mixed(const Color& color, const Color& under, int share) {
  Color result = under;
  for (std::size_t c = 0; c < 3; ++c) result[c] += (color[c] - under[c]) * share / 256;
  return result;
}

int scale_of(int width, int height) {
  const int side = std::max(width, height);
  return std::clamp(kSide / side, side <= 1024 ? 2 : 1, 16);
}

class Painting {
 public:
  Painting(const CaseResults& one, const Result& result)
      : one_(one),
        exact_((result.exact_pixels->empty() ? one.pixels : result.exact_pixels)->bytes()),
        rendered_(result.pixels->bytes()),
        scale_(scale_of(one.width, one.height)),
        gap_((kGap + scale_ - 1) / scale_),
        width_(3 * one.width + 2 * gap_) {
    mark_bytes();
    for (const Disagreement& d : result.disagreements)
      if (is_inside(d.x, d.y)) marks_[index_of(d.x, d.y)] = color_of(d.kind);
    for (const CountedDisagreements& counted : result.counted)
      for (const PixelRun& run : counted.runs)
        for (int x = run.begin; x < run.end; ++x)
          if (is_inside(x, run.y)) marks_[index_of(x, run.y)] = color_of(counted.kind);
  }

  Triptych paint() {
    const auto area = static_cast<std::size_t>(width_) * static_cast<std::size_t>(one_.height);
    rgba_.resize(4 * area, 255);
    for (std::size_t i = 0; i < area; ++i) set(i, kFrame);
    for (int y = 0; y < one_.height; ++y)
      for (int x = 0; x < one_.width; ++x) {
        set(place_of(0, x, y), stored(exact_, x, y));
        set(place_of(1, x, y), difference_at(x, y));
        set(place_of(2, x, y), stored(rendered_, x, y));
      }
    return {width_, one_.height, std::move(rgba_), scale_};
  }

 private:
  std::size_t index_of(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(one_.width) +
           static_cast<std::size_t>(x);
  }

  std::size_t place_of(int panel, int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(panel * (one_.width + gap_) + x);
  }

  void set(std::size_t pixel, const Color& color) {
    for (std::size_t c = 0; c < 3; ++c) rgba_[4 * pixel + c] = static_cast<std::uint8_t>(color[c]);
  }

  Color stored(const std::vector<std::uint8_t>& pixels, int x, int y) const {
    const std::size_t at = 4 * index_of(x, y);
    return {pixels[at], pixels[at + 1], pixels[at + 2]};
  }

  bool is_inside(int x, int y) const {
    return x >= 0 && y >= 0 && x < one_.width && y < one_.height;
  }

  void mark_bytes() {
    marks_.resize(exact_.size() / 4);
    for (std::size_t pixel = 0; pixel < marks_.size(); ++pixel) {
      const auto at = static_cast<std::ptrdiff_t>(4 * pixel);
      if (!std::equal(exact_.begin() + at, exact_.begin() + at + 4, rendered_.begin() + at))
        marks_[pixel] = mixed(color_of(DisagreementKind::value), {255, 255, 255}, 140);
    }
  }

  std::optional<Color> halo_at(int x, int y) const {
    if (scale_ >= kHaloBelow) return std::nullopt;
    for (int dy = -kHalo; dy <= kHalo; ++dy)
      for (int dx = -kHalo; dx <= kHalo; ++dx)
        if (is_inside(x + dx, y + dy) && marks_[index_of(x + dx, y + dy)])
          return marks_[index_of(x + dx, y + dy)];
    return std::nullopt;
  }

  Color difference_at(int x, int y) const {
    if (const auto& mark = marks_[index_of(x, y)]) return *mark;
    const Color exact = stored(exact_, x, y);
    const int light = (exact[0] + exact[1] + exact[2]) / 3;
    const Color print = mixed({0, 0, 0}, {255, 255, 255}, light / 4);
    if (const auto halo = halo_at(x, y)) return mixed(*halo, print, 96);
    return print;
  }

  const CaseResults& one_;
  const std::vector<std::uint8_t> exact_;
  const std::vector<std::uint8_t> rendered_;
  int scale_;
  int gap_;                                  // pixels
  int width_;                                // of the three
  std::vector<std::optional<Color>> marks_;  // of pixels that differ, the colour to show them in
  std::vector<std::uint8_t> rgba_;
};

}  // namespace

std::optional<Triptych> triptych_of(const CaseResults& one, const Result& result) {
  const auto size = static_cast<std::size_t>(one.width) * static_cast<std::size_t>(one.height);
  const Shared<PackedWords>& exact =
      result.exact_pixels->empty() ? one.pixels : result.exact_pixels;
  if (size == 0 || exact->size() != size || result.pixels->size() != size) return std::nullopt;
  if (result.disagreements.empty() && result.pixels == exact) return std::nullopt;
  return Painting(one, result).paint();
}

}  // namespace edgecase
