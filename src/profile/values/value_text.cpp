// SPDX-License-Identifier: MIT
#include "profile/values/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "model/scene_words.h"
#include "profile/profile_text.h"

namespace edgecase {
namespace {

using Buffer = fmt::memory_buffer;

template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

double ulp_of(const std::optional<ValueExample>& example) {
  return example ? example->ulp : 0;
}

double relative_of(const std::optional<ValueExample>& example) {
  return example ? example->relative : 0;
}

// "2^-1: 12, 2^0: 3": the errors in ULP, by the power of two at or below.
void print_histogram(Buffer& out, const ValueErrors& row) {
  if (row.histogram.empty()) return;
  print(out, "    errors by 2^n ULP:");
  const char* separator = " ";
  for (const auto& [exponent, count] : row.histogram) {
    print(out, "{}{}: {}", separator, exponent, count);
    separator = ", ";
  }
  print(out, "\n");
}

void print_example(Buffer& out, const char* what, ValueKind kind,
                   const std::optional<ValueExample>& found) {
  if (!found) return;
  print(out, "    {}: {} at pixel ({}, {}) is {:.9g}, drawn {:.9g}", what,
        component_name(kind, found->component), found->pixel.x, found->pixel.y, found->exact,
        found->rendered);
  if (found->permitted)
    print(out, ", permitted {:.9g} to {:.9g}", found->permitted->low, found->permitted->high);
  print(out, "; {} {}\n", found->id, scene_words(found->scene));
}

// "2^6": so many ULP are more than the errors of 99 % of the components.
std::string most_of(const ValueErrors& row) {
  const std::optional<int> bound = row.log2_bound(0.99);
  return bound ? fmt::format("2^{}", *bound) : "0";
}

// "12+": there may be more.
std::string beyond_of(const ValueErrors& row) {
  if (row.as_found) return "-";
  return fmt::format("{}{}", row.beyond, row.not_asked > 0 ? "+" : "");
}

void print_row(Buffer& out, const ValueErrors& row) {
  print(out, "  {:<34}{:>10}  {:<9}{:>8}{:>11.4g}{:>13.4g}{:>13.4g}  ",
        row.attribute + (row.as_found ? " *" : ""), row.fragments,
        percent({row.correct, row.components}), most_of(row), row.mean_ulp(), ulp_of(row.worst_ulp),
        relative_of(row.worst_relative));
  print(out, "{:<8} {}\n", beyond_of(row), row.not_numbers);
  print_histogram(out, row);
  print_example(out, "largest in ULP", row.kind, row.worst_ulp);
  print_example(out, "largest of range", row.kind, row.worst_relative);
  print_example(out, "smallest beyond", row.kind, row.smallest_beyond);
}

}  // namespace

const char* component_name(ValueKind kind, int component) {
  constexpr std::array kColors{"red", "green", "blue", "alpha"};
  if (kind == ValueKind::depth) return "depth";
  if (kind == ValueKind::inverse_w) return "gl_FragCoord.w";
  return kColors[static_cast<std::size_t>(component)];
}

std::string value_errors_text(std::span<const ValueErrors> rows) {
  Buffer out;
  if (rows.empty()) return "";
  print(out, "  {:<34}{:>10}  {:<9}{:>8}{:>11}{:>13}{:>13}  {:<8} {}\n", "values of fragments",
        "fragments", "correct", "99 % <", "mean ULP", "largest ULP", "of range", "beyond",
        "no numbers");
  for (const ValueErrors& row : rows) print_row(out, row);
  if (std::any_of(rows.begin(), rows.end(), [](const ValueErrors& row) { return row.as_found; }))
    print(out, "  *: against the rules that the renderer is found to follow, not OpenGL's own\n");
  return fmt::to_string(out);
}

}  // namespace edgecase
