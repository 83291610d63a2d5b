// SPDX-License-Identifier: MIT
#include "profile/output/output_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace edgecase {
namespace {

constexpr std::size_t kMostTerms = 8;

using Buffer = fmt::memory_buffer;

template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

// "at it 120 (0 to 0.5 of a step above it), +1 130 (0.5 to 0.99)"
void print_codes(Buffer& out, const CodeEvidence& evidence) {
  std::vector<std::string> parts;
  for (const auto& [distance, step] : evidence.steps)
    parts.push_back(fmt::format("{:+} {} (of {:.4f} to {:.4f} steps above)", distance, step.numbers,
                                step.least, step.largest));
  print(out, "    {:<10}{} numbers, from the code at or below them: {}\n", evidence.id,
        evidence.numbers, fmt::join(parts, ", "));
}

void print_unit(Buffer& out, const MeasuredUnit& unit) {
  const bool is_float = unit.format == DepthFormat::depth32f;
  const std::string of =
      is_float ? fmt::format("2^({} - 23)", unit.exponent) : std::string("the format's steps");
  print(out, "    {:<10}one unit of offset is {:.7g} to {:.7g} {}, {} depths\n",
        name_of(unit.format), unit.least, unit.largest, of, unit.depths);
}

void print_residual(Buffer& out, const BlendResidual& residual) {
  std::vector<std::string> off;
  for (const auto& [difference, values] : residual.off)
    off.push_back(fmt::format("{:+} {}", difference, values));
  print(out, "    {:<7}{:<18}{:<27}{:<27}{:>6} values, off by {}\n",
        residual.is_alpha ? "alpha" : "colour", name_of(residual.term.equation),
        name_of(residual.term.source), name_of(residual.term.destination), residual.values,
        fmt::join(off, ", "));
}

void print_blending(Buffer& out, const std::vector<BlendResidual>& residuals) {
  if (residuals.empty()) return;
  print(out, "  blended values that no alternative yields, by term, against the closest one:\n");
  const std::size_t shown = std::min(kMostTerms, residuals.size());
  for (std::size_t i = 0; i < shown; ++i) print_residual(out, residuals[i]);
  if (shown < residuals.size())
    print(out, "    and {} more terms; --json has all\n", residuals.size() - shown);
}

}  // namespace

std::string output_profile_text(const OutputProfile& output) {
  Buffer out;
  if (output.codes.empty()) return "";
  print(out, "  stored codes and units of offset:\n");
  for (const CodeEvidence& evidence : output.codes) print_codes(out, evidence);
  for (const MeasuredUnit& unit : output.units) print_unit(out, unit);
  print_blending(out, output.blending);
  return fmt::to_string(out);
}

}  // namespace edgecase
