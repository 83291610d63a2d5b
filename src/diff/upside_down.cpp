// SPDX-License-Identifier: MIT
#include "diff/upside_down.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

#include "diff/coverage/legality.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

const std::string& sentence() {
  static const std::string text = fmt::format(
      " Ruling {}: with its rows in the opposite order, nothing of the whole answer disagrees.",
      kRulingOnOrigin);
  return text;
}

// Reverses the rows of each plane; `row` is the count of numbers in a row.
template <class Number>
void turn_rows_over(std::vector<Number>& planes, std::size_t row, std::size_t height) {
  for (std::size_t plane = 0; plane + row * height <= planes.size(); plane += row * height)
    for (std::size_t y = 0; y < height / 2; ++y) {
      const auto begin = planes.begin() + static_cast<std::ptrdiff_t>(plane + row * y);
      const auto opposite =
          planes.begin() + static_cast<std::ptrdiff_t>(plane + row * (height - 1 - y));
      std::swap_ranges(begin, begin + static_cast<std::ptrdiff_t>(row), opposite);
    }
}

auto place_within_row(const Fragment& f) {
  return std::tuple(f.x, f.primitive, f.coverage);
}

bool drawing_is_covered_upside_down(const Rendering& exact, const Rendering& rendered) {
  if (exact.fragments.size() != rendered.fragments.size()) return false;
  // Both are sorted by row: one is read from the lowest row, the other from the highest.
  auto row_end = rendered.fragments.end();
  for (auto own = exact.fragments.begin(); own != exact.fragments.end();) {
    if (row_end == rendered.fragments.begin()) return false;
    auto other = std::prev(row_end);
    if (other->y != exact.height - 1 - own->y) return false;
    while (other != rendered.fragments.begin() && std::prev(other)->y == other->y) --other;
    const auto row_begin = other;
    const int y = own->y;
    for (; own != exact.fragments.end() && own->y == y; ++own, ++other)
      if (other == row_end || place_within_row(*own) != place_within_row(*other)) return false;
    if (other != row_end) return false;
    row_end = row_begin;
  }
  return true;
}

}  // namespace

Rendering turned_over(Rendering rendering) {
  const auto width = static_cast<std::size_t>(rendering.width);
  const auto height = static_cast<std::size_t>(rendering.height);
  turn_rows_over(rendering.pixels, 4 * width, height);
  turn_rows_over(rendering.sample_pixels, 4 * width, height);
  turn_rows_over(rendering.hits, width, height);
  turn_rows_over(rendering.depths, width, height);
  turn_rows_over(rendering.stencils, width, height);
  turn_rows_over(rendering.accumulated, 4 * width, height);
  for (Fragment& fragment : rendering.fragments) fragment.y = rendering.height - 1 - fragment.y;
  for (FragmentDetail& detail : rendering.details)
    if (auto& at = detail.coordinates) (*at)[1] = rendering.height - (*at)[1];
  sort_fragments(rendering);
  for (Rendering& pass : rendering.passes) pass = turned_over(std::move(pass));
  return rendering;
}

bool is_covered_upside_down(const Rendering& exact, const Rendering& rendered) {
  if (exact.passes.size() != rendered.passes.size()) return false;
  for (std::size_t k = 0; k < exact.passes.size(); ++k)
    if (!drawing_is_covered_upside_down(exact.passes[k], rendered.passes[k])) return false;
  return drawing_is_covered_upside_down(exact, rendered);
}

bool breaks_a_ruling(const Result& result) {
  const std::size_t snaps = all_snaps().size();
  return any_class(
             result,
             [](const DisagreementClass& d) { return !is_legal(d) && !is_about_a_line(d); }) ||
         std::any_of(
             result.evidence.begin(), result.evidence.end(),
             [&](const Result::Evidence& e) { return e.illegal_line_snaps.size() == snaps; });
}

void note_upside_down(Result& result) {
  Result::Evidence evidence;
  evidence.primitive = kWholeAnswer;
  if (breaks_a_ruling(result)) evidence.causes = {AlternativeId{kWindowOrigin}};
  result.evidence.push_back(std::move(evidence));
}

bool is_noted_upside_down(const Result& result) {
  return std::any_of(result.evidence.begin(), result.evidence.end(),
                     [](const Result::Evidence& e) { return e.primitive == kWholeAnswer; });
}

void report_upside_down(Result& result) {
  for (Disagreement& d : result.disagreements)
    if (!d.upright) d.explanation += sentence();
  for_each_class(result, [](DisagreementClass& d) {
    if (d.upright) return;
    d.upright = DisagreementClass::Upright{d.rule, d.ruling, d.legality, d.cause};
    d.rule = kWindowOrigin;
    d.cause = AlternativeId{kWindowOrigin};
    d.ruling = kRulingOnOrigin;
    d.legality = Legality::illegal;
  });
}

void report_upright(Result& result) {
  for (Disagreement& d : result.disagreements)
    if (d.upright && d.explanation.ends_with(sentence()))
      d.explanation.resize(d.explanation.size() - sentence().size());
  for_each_class(result, [](DisagreementClass& d) {
    if (!d.upright) return;
    d.rule = d.upright->rule;
    d.ruling = d.upright->ruling;
    d.legality = d.upright->legality;
    d.cause = d.upright->cause;
    d.upright.reset();
  });
}

}  // namespace edgecase
