// SPDX-License-Identifier: MIT
#include "profile/output/code_rounding.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace edgecase {
namespace {

struct NamedRounding {
  CodeRounding rounding;
  const char* name;
};
constexpr NamedRounding kRoundings[] = {{CodeRounding::nearest, "nearest"},
                                        {CodeRounding::nearest_of_float, "nearest-of-float32"},
                                        {CodeRounding::half_up_of_float, "half-up-of-float32"},
                                        {CodeRounding::truncated, "truncate"},
                                        {CodeRounding::truncated_of_float, "truncate-of-float32"},
                                        {CodeRounding::up, "up"},
                                        {CodeRounding::power_nearest, "nearest-of-power"},
                                        {CodeRounding::power_truncated, "truncate-of-power"}};

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const NamedRounding& one : kRoundings) names.emplace_back(one.name);
  return names;
}

double as_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace

long code_by(CodeRounding rounding, double value, int bits) {
  const double power = std::ldexp(1.0, bits);
  const double largest = power - 1;
  const double clamped = std::clamp(value, 0.0, 1.0);
  // 24 bits times 24 bits: exact.
  const double product = clamped * largest;
  const auto code = [&]() -> double {
    switch (rounding) {
      case CodeRounding::nearest:
        return std::nearbyint(product);
      case CodeRounding::nearest_of_float:
        return std::nearbyint(as_float(product));
      case CodeRounding::half_up_of_float:
        return std::floor(as_float(as_float(product) + 0.5));
      case CodeRounding::truncated:
        return std::floor(product);
      case CodeRounding::truncated_of_float:
        return std::floor(as_float(product));
      case CodeRounding::up:
        return std::ceil(product);
      case CodeRounding::power_nearest:
        return std::nearbyint(clamped * power);
      case CodeRounding::power_truncated:
        return std::floor(clamped * power);
    }
    return 0;
  };
  return static_cast<long>(std::min(code(), largest));
}

CodeTally::CodeTally(std::string id, int bits) : tally_(all_names(), 0) {
  evidence_.id = std::move(id);
  evidence_.bits = bits;
}

void CodeTally::add(double value, long code) {
  std::vector<bool> yields;
  for (const NamedRounding& one : kRoundings)
    yields.push_back(code_by(one.rounding, value, evidence_.bits) == code);
  tally_.add(yields);
  const double product = std::clamp(value, 0.0, 1.0) * (std::ldexp(1.0, evidence_.bits) - 1);
  const double below = std::floor(product);
  ++evidence_.numbers;
  CodeStep& step = evidence_.steps[code - static_cast<long>(below)];
  const double above = product - below;
  step.least = step.numbers == 0 ? above : std::min(step.least, above);
  step.largest = std::max(step.largest, above);
  ++step.numbers;
}

}  // namespace edgecase
