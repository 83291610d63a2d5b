// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/block_walks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string_view>

#include "raster/coverage_stages.h"
#include "rules/choices.h"
#include "rules/rule.h"

namespace edgecase {
namespace {

constexpr std::array kSides = {2, 4, 8, 16, 32};

// The sums over a primitive's walk.
struct Totals {
  std::array<int, 3> rejected{};  // by edge
  int accepted = 0;
  int divided = 0;
  int tested = 0;
  int in_vain = 0;  // tested ones of which nothing is covered
  int all_rejected() const { return rejected[0] + rejected[1] + rejected[2]; }
};

// The sums for blocks of one size.
Totals totals_of(const BlockWalk& walk, int size) {
  Totals totals;
  for (const WalkedBlock& block : walk.blocks) {
    if (block.size != size) continue;
    switch (block.decision) {
      case BlockDecision::rejected:
        ++totals.rejected[static_cast<std::size_t>(block.edge)];
        break;
      case BlockDecision::accepted:
        ++totals.accepted;
        break;
      case BlockDecision::divided:
        ++totals.divided;
        break;
      case BlockDecision::tested:
        ++totals.tested;
        totals.in_vain += block.covered.empty() ? 1 : 0;
        break;
    }
  }
  return totals;
}

// "12 accepted, 3 tested, 1 of them for nothing, 2 rejected".
std::string totals_words(const Totals& totals, bool is_last) {
  std::string words = fmt::format("{} accepted, ", totals.accepted);
  words +=
      is_last ? fmt::format("{} tested", totals.tested) : fmt::format("{} divided", totals.divided);
  if (totals.in_vain > 0) words += fmt::format(", {} of them for nothing", totals.in_vain);
  return words + fmt::format(", {} rejected", totals.all_rejected());
}

std::string side_words(int size) {
  return fmt::format("{} x {}", size, size);
}

Point vertex_of(const PrimitiveBlocks& blocks, std::size_t i) {
  return nearest_point(blocks.triangle[i % 3]);
}

char sign_of(const WalkedBlock& block) {
  switch (block.decision) {
    case BlockDecision::rejected:
      return static_cast<char>('0' + block.edge);
    case BlockDecision::accepted:
      return '#';
    case BlockDecision::tested:
      return block.covered.empty() ? '-' : '+';
    case BlockDecision::divided:
      break;
  }
  return '.';
}

// A drawing with a character for each of the smallest blocks, top row first.
std::string drawing_of(const BlockWalk& walk, const Target& target, int smallest) {
  const int columns = (target.width + smallest - 1) / smallest;
  const int rows = (target.height + smallest - 1) / smallest;
  std::vector<std::string> lines(static_cast<std::size_t>(rows),
                                 std::string(static_cast<std::size_t>(columns), '.'));
  for (const WalkedBlock& block : walk.blocks)
    for (int y = block.pixels.y_min / smallest; y <= block.pixels.y_max / smallest; ++y)
      for (int x = block.pixels.x_min / smallest; x <= block.pixels.x_max / smallest; ++x)
        lines[static_cast<std::size_t>(rows - 1 - y)][static_cast<std::size_t>(x)] = sign_of(block);
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

int samples_of(const std::vector<PixelSamples>& covered) {
  int count = 0;
  for (const PixelSamples& pixel : covered) count += std::popcount(pixel.covered);
  return count;
}

int samples_of_box(const PrimitiveBlocks& blocks) {
  const PixelBounds& box = blocks.walk.box;
  return (box.x_max - box.x_min + 1) * (box.y_max - box.y_min + 1) *
         static_cast<int>(blocks.places.size());
}

// The number of rejected blocks by edge, over all sizes.
std::string edge_text(const PrimitiveBlocks& blocks) {
  std::string text;
  for (std::size_t e = 0; e < 3; ++e) {
    const auto count =
        std::ranges::count(blocks.walk.blocks, static_cast<int>(e), &WalkedBlock::edge);
    text += fmt::format("  edge {} from {} to {} rejects {} block{}.\n", e,
                        format_point(vertex_of(blocks, e)), format_point(vertex_of(blocks, e + 1)),
                        count, count == 1 ? "" : "s");
  }
  return text;
}

std::string walk_text(const PrimitiveBlocks& blocks, const Target& target,
                      const BlockSizes& sizes) {
  const BlockWalk& walk = blocks.walk;
  std::string text = drawing_of(walk, target, sizes.back());
  for (int size : sizes)
    text += fmt::format("  blocks of {}: {}.\n", side_words(size),
                        totals_words(totals_of(walk, size), size == sizes.back()));
  text += edge_text(blocks);
  int tested = 0;
  for (const WalkedBlock& block : walk.blocks) tested += samples_of(block.covered);
  const auto places = static_cast<int>(blocks.places.size());
  const int all = samples_of(covered_samples(walk, places));
  text += fmt::format(
      "  {} samples are covered, {} of them by accepted blocks. {} edge functions are evaluated; "
      "to ask the {} samples of the bounding box one by one takes {}.\n",
      all, all - tested, walk.evaluations, samples_of_box(blocks), walk.plain_evaluations);
  return text;
}

DrawnBlock::Kind drawn_kind(BlockDecision decision) {
  switch (decision) {
    case BlockDecision::rejected:
      return DrawnBlock::Kind::rejected;
    case BlockDecision::accepted:
      return DrawnBlock::Kind::accepted;
    case BlockDecision::divided:
      return DrawnBlock::Kind::divided;
    case BlockDecision::tested:
      break;
  }
  return DrawnBlock::Kind::tested;
}

// The tested samples of a block: those in the bounding box.
void add_samples(const WalkedBlock& block, const PrimitiveBlocks& blocks, BlocksPanel& panel) {
  auto covered = block.covered.begin();
  for (int y = block.pixels.y_min; y <= block.pixels.y_max; ++y)
    for (int x = block.pixels.x_min; x <= block.pixels.x_max; ++x) {
      if (!blocks.walk.box.contains({x, y})) continue;
      std::uint32_t mask = 0;
      if (covered != block.covered.end() && covered->pixel == PixelPosition{x, y})
        mask = (covered++)->covered;
      for (std::size_t s = 0; s < blocks.places.size(); ++s)
        panel.samples.push_back(
            {position_of(place_in({x, y}, blocks.places[s])), (mask >> s & 1) != 0});
    }
}

BlocksPanel panel_of(int primitive, const PrimitiveBlocks& blocks, const BlockSizes& sizes) {
  BlocksPanel panel;
  panel.name = fmt::format("primitive {}", primitive);
  panel.outline = {MarkRole::primitive, true, {}, ""};
  for (std::size_t i = 0; i < 3; ++i)
    panel.outline.points.push_back(position_of(vertex_of(blocks, i)));
  for (const WalkedBlock& block : blocks.walk.blocks) {
    const PixelBounds& p = block.pixels;
    panel.blocks.push_back({drawn_kind(block.decision), p.x_min, p.y_min, p.x_max - p.x_min + 1,
                            p.y_max - p.y_min + 1, block.edge});
    if (block.decision == BlockDecision::tested) add_samples(block, blocks, panel);
  }
  for (int size : sizes)
    panel.caption.push_back(
        fmt::format("{}: {}", side_words(size),
                    totals_words(totals_of(blocks.walk, size), size == sizes.back())));
  panel.caption.push_back(fmt::format("{} edge functions, {} sample by sample",
                                      blocks.walk.evaluations, blocks.walk.plain_evaluations));
  return panel;
}

}  // namespace

std::optional<BlockSizes> parse_block_sizes(const std::string& text) {
  BlockSizes sizes;
  std::string_view rest = text;
  while (true) {
    const std::string_view word = rest.substr(0, rest.find(','));
    int size = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    if (std::ranges::find(kSides, size) == kSides.end()) return std::nullopt;
    if (!sizes.empty() && size >= sizes.back()) return std::nullopt;
    sizes.push_back(size);
    if (word.size() == rest.size()) return sizes;
    rest.remove_prefix(word.size() + 1);
  }
}

std::string block_text(const Scene& scene, const Policy& policy, const BlockSizes& sizes) {
  const CoverageChoice choice = resolve(policy, scene.target.surface).triangles;
  std::string text = fmt::format(
      "Blocks of {} by policy {}: # accepted, + tested, - tested for nothing, 0 to 2 rejected by "
      "that "
      "edge, . not asked.\n",
      side_words(sizes.front()) + (sizes.size() > 1 ? ", then smaller ones," : ""), policy.name);
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const PrimitiveBlocks blocks = blocks_of(primitive, scene.target, choice, sizes);
    if (!blocks.absence.empty()) {
      text += fmt::format("primitive {} is not walked: {}.\n", primitive.index, blocks.absence);
      continue;
    }
    text += fmt::format("primitive {}, the triangle {}, {}, {}:\n", primitive.index,
                        format_point(vertex_of(blocks, 0)), format_point(vertex_of(blocks, 1)),
                        format_point(vertex_of(blocks, 2)));
    text += walk_text(blocks, scene.target, sizes);
  }
  return text;
}

BlocksPicture block_picture(const Scene& scene, const Policy& policy, const BlockSizes& sizes) {
  const CoverageChoice choice = resolve(policy, scene.target.surface).triangles;
  BlocksPicture picture;
  picture.width = scene.target.width;
  picture.height = scene.target.height;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const PrimitiveBlocks blocks = blocks_of(primitive, scene.target, choice, sizes);
    if (blocks.absence.empty()) picture.panels.push_back(panel_of(primitive.index, blocks, sizes));
  }
  return picture;
}

}  // namespace edgecase
