// SPDX-License-Identifier: MIT
#include "casefile/mask_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "casefile/text.h"

namespace edgecase {
namespace {

using Masks = std::vector<std::uint32_t>;

std::vector<std::string_view> cells_of(std::string_view row) {
  std::vector<std::string_view> cells;
  for (std::size_t start = row.find_first_not_of(' '); start != row.npos;
       start = row.find_first_not_of(' ', start)) {
    const std::size_t end = std::min(row.find(' ', start), row.size());
    cells.push_back(row.substr(start, end - start));
    start = end;
  }
  return cells;
}

// Up to four hexadecimal digits, enough for 16 samples.
std::optional<std::uint32_t> parse_mask(std::string_view cell) {
  constexpr std::size_t kMostDigits = 4;
  std::uint32_t mask = 0;
  const char* end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, mask, 16);
  if (error != std::errc() || stop != end || cell.size() > kMostDigits) return std::nullopt;
  return mask;
}

std::uint32_t read_cell(const Place& row, std::string_view cell, int samples, Findings& findings) {
  if (cell == ".") return 0;
  const auto mask = parse_mask(cell);
  if (!mask) {
    findings.add(row, fmt::format("a row has the unknown cell {}", quote(cell)),
                 "write a mask in hexadecimal digits, or . for none");
    return 0;
  }
  const std::uint32_t all = (1U << (samples > 0 ? samples : kMaxSamples)) - 1;
  if (*mask == 0)
    findings.add(row, "a row has the mask 0", "write . where no sample is covered");
  else if (*mask > all)
    findings.add(row,
                 fmt::format("a row has the mask {:x}, and the target {} samples", *mask, samples),
                 fmt::format("write 1 to {:x}, or . for none", all));
  return *mask;
}

Masks read_row(const Place& place, const Target& target, Findings& findings) {
  Masks masks;
  if (!expect_kind(place, JsonKind::string, "a row of a drawing", findings)) return masks;
  const std::vector<std::string_view> cells = cells_of(place.node->text);
  if (target.width > 0 && cells.size() != static_cast<std::size_t>(target.width))
    findings.add(
        place,
        fmt::format("a row has {} cells, and the target is {} wide", cells.size(), target.width),
        fmt::format("draw {} cells, separated by blanks", target.width));
  for (const std::string_view cell : cells)
    masks.push_back(read_cell(place, cell, target.samples, findings));
  return masks;
}

}  // namespace

std::vector<std::uint32_t> read_masks(const Place& place, const Target& target,
                                      Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "masks", findings)) return {};
  const std::size_t height = place.node->children.size();
  if (target.height > 0 && height != static_cast<std::size_t>(target.height))
    findings.add(
        place, fmt::format("the drawing has {} rows, and the target has {}", height, target.height),
        fmt::format("draw {} rows, the top one first", target.height));
  Masks result;
  for (std::size_t i = height; i-- > 0;) {
    const Masks row = read_row(place.child(i), target, findings);
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

}  // namespace edgecase
