// SPDX-License-Identifier: MIT
#include "diff/coverage/supported_sizes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace edgecase {
namespace {

SizeSteps steps_in(const std::map<std::string, std::string>& traits, const char* name) {
  const auto trait = traits.find(name);
  if (trait == traits.end()) return {};
  const std::string& text = trait->second;
  const std::size_t by = text.find(" by ");
  if (by == std::string::npos) return {};
  const double least = std::strtod(text.c_str(), nullptr);
  const double step = std::strtod(text.c_str() + by + 4, nullptr);
  const bool is_sensible = std::isfinite(least) && std::isfinite(step) && least > 0 && step > 0;
  return is_sensible ? SizeSteps{least, step} : SizeSteps{};
}

Fixed rounded_out(double size, bool upwards) {
  const double raw = size * static_cast<double>(Fixed::kOne);
  return Fixed::from_raw(static_cast<std::int64_t>(upwards ? std::ceil(raw) : std::floor(raw)));
}

}  // namespace

SupportedSizes supported_sizes(const std::map<std::string, std::string>& traits) {
  return {steps_in(traits, "point_size_steps"), steps_in(traits, "sampled_line_width_steps")};
}

SizeRange permitted_sizes(Fixed asked, const SizeSteps& supported) {
  const double size = asked.to_double();
  if (supported.step == 0 || size == 1) return {asked, asked};
  // Ranges and steps are reported as float32 numbers; this is as accurate as those.
  const double steps = (size - supported.least) / supported.step;
  if (std::fabs(steps - std::round(steps)) * supported.step <= 1e-5 * size) return {asked, asked};
  const Fixed least = Fixed::from_raw(1);
  return {std::max(least, rounded_out(size - supported.step / 2, false)),
          rounded_out(size + supported.step / 2, true)};
}

}  // namespace edgecase
