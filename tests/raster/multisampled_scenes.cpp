// SPDX-License-Identifier: MIT
#include "tests/raster/multisampled_scenes.h"

#include <map>
#include <utility>

#include "rules/coverage/tie_rule.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

// As many hexadecimal digits as there are samples to four.
std::string hexadecimal(std::uint32_t mask, int samples) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (int digit = (samples + 3) / 4 - 1; digit >= 0; --digit)
    text += kDigits[mask >> (4 * digit) & 15];
  return text;
}

}  // namespace

Scene multisampled_scene(int size, int samples, Primitive primitive, std::vector<Point> positions) {
  Scene scene = blank_scene(size, size);
  scene.target.samples = samples;
  scene.draws = {make_draw(primitive, positions)};
  return scene;
}

std::string masks_drawn(const Rendering& rendering) {
  std::map<std::pair<int, int>, std::uint32_t> masks;
  for (const Fragment& fragment : rendering.fragments)
    masks[{fragment.x, fragment.y}] |= fragment.coverage;
  std::string rows;
  for (int y = rendering.height - 1; y >= 0; --y) {
    for (int x = 0; x < rendering.width; ++x) {
      const auto found = masks.find({x, y});
      if (x > 0) rows += ' ';
      rows += found == masks.end() ? "." : hexadecimal(found->second, rendering.samples);
    }
    rows += '/';
  }
  return rows;
}

std::uint32_t mask_at(const SampleCoverage& coverage, PixelPosition pixel) {
  std::uint32_t mask = 0;
  for (std::size_t s = 0; s < coverage.size(); ++s)
    for (PixelPosition covered : coverage[s])
      if (covered == pixel) mask |= std::uint32_t{1} << s;
  return mask;
}

std::vector<std::string> perturbed_ties() {
  std::vector<std::string> names;
  for (const TieRule& rule : all_tie_rules())
    if (rule.kind == TieRule::Kind::perturbed) names.emplace_back(rule.name);
  return names;
}

SamplePositions RandomPoints::positions(int samples, int parts) {
  SamplePositions positions;
  for (int s = 0; s < samples; ++s) {
    const auto part = [&] {
      return Fixed::from_raw(between(0, parts - 1) * (Fixed::kOne / parts));
    };
    const Fixed x = part();
    positions.push_back({x, part()});
  }
  return positions;
}

}  // namespace edgecase
