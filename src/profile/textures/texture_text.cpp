// SPDX-License-Identifier: MIT
#include "profile/textures/texture_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "model/scene_words.h"

namespace edgecase {
namespace {

using Buffer = fmt::memory_buffer;

template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

void print_found(Buffer& out, const LevelResiduals& row) {
  const FormulaResidual& found = row.found();
  print(out, "  {:<34}{:>10}{:>13.4g}{:>13.4g}  {}\n",
        fmt::format("{}, {}", name_of(row.kind), name_of(row.source)), found.fragments,
        found.mean(), found.largest, found.largest <= kMostResidual ? "" : "BEYOND");
  if (!found.worst) return;
  const ResidualExample& worst = *found.worst;
  print(out, "    largest: pixel ({}, {}) is told {:.9g}, by formula {:.9g}; {} {}\n",
        worst.pixel.x, worst.pixel.y, worst.told, worst.formula, worst.id,
        scene_words(worst.scene));
}

// The mean and the largest residual of one formula over all rows of a source.
std::pair<double, double> over_all(std::span<const LevelResiduals> rows, LevelSource source,
                                   std::size_t formula) {
  FormulaResidual sum;
  for (const LevelResiduals& row : rows) {
    if (row.source != source) continue;
    const FormulaResidual& one = row.formulas[formula];
    sum.fragments += one.fragments;
    sum.sum += one.sum;
    sum.largest = std::max(sum.largest, one.largest);
  }
  return {sum.mean(), sum.largest};
}

void print_formulas(Buffer& out, std::span<const LevelResiduals> rows) {
  print(out, "  {:<60}{:>11}{:>11}{:>11}{:>11}\n", "all formulas, over all ramps", "query mean",
        "largest", "color mean", "largest");
  for (std::size_t i = 0; i < rows[0].formulas.size(); ++i) {
    const FormulaResidual& formula = rows[0].formulas[i];
    const auto [query_mean, query_largest] = over_all(rows, LevelSource::query, i);
    const auto [color_mean, color_largest] = over_all(rows, LevelSource::color, i);
    print(out, "  {:<60}{:>11.3g}{:>11.3g}{:>11.3g}{:>11.3g}\n",
          fmt::format("{} + {}{}", name_of(formula.scale_factor), name_of(formula.log2),
                      formula.is_found ? " (found)" : ""),
          query_mean, query_largest, color_mean, color_largest);
  }
}

}  // namespace

std::string level_residuals_text(std::span<const LevelResiduals> rows) {
  Buffer out;
  if (rows.empty()) return "";
  const FormulaResidual& found = rows[0].found();
  print(out,
        "  levels of detail against {} + {}, derivatives {}: at most {:.4g} levels off is asked "
        "for\n",
        name_of(found.scale_factor), name_of(found.log2), rows[0].derivatives, kMostResidual);
  print(out, "  {:<34}{:>10}{:>13}{:>13}\n", "ramp, where the level is told", "fragments", "mean",
        "largest");
  for (const LevelResiduals& row : rows) print_found(out, row);
  print_formulas(out, rows);
  return fmt::to_string(out);
}

}  // namespace edgecase
