// SPDX-License-Identifier: MIT
#include "tests/adversaries/freedoms.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace edgecase::adversary {
namespace {

Arithmetic arithmetic = Arithmetic::exact;
std::uint64_t state = 0;

// About 1 part in 10^5, and no more.
constexpr double kPart = 0.999e-5;

}  // namespace

std::uint64_t hash_of(double number) {
  return hash(std::bit_cast<std::uint64_t>(number));
}

void set_arithmetic(Arithmetic chosen) {
  arithmetic = chosen;
}

void seed_errors(std::uint64_t seed) {
  state = seed;
}

double rounded(double exact) {
  switch (arithmetic) {
    case Arithmetic::exact:
      return exact;
    case Arithmetic::binary32:
      return static_cast<double>(static_cast<float>(exact));
    case Arithmetic::low:
      return exact * (1 - kPart);
    case Arithmetic::high:
      return exact * (1 + kPart);
    case Arithmetic::either:
      break;
  }
  state = hash(state);
  return exact * (1 + ((state & 1) != 0 ? kPart : -kPart));
}

double converted(const Freedoms& freedoms, double number, double most) {
  const double scaled = std::clamp(number, 0.0, 1.0) * most, down = std::floor(scaled);
  // A number that is a multiple, but for the errors of double, stays one.
  const double near = std::nearbyint(scaled);
  if (std::abs(scaled - near) < 1e-7) return near / most;
  bool up = scaled - down > 0.5;
  if (freedoms.conversion == Conversion::down) up = false;
  if (freedoms.conversion == Conversion::up) up = true;
  if (freedoms.conversion == Conversion::either) up = (hash_of(number) & 1) != 0;
  const double hair = freedoms.crime == "codes one beyond" ? (up ? 1 : -1) : 0;
  return std::clamp((up ? down + 1 : down) + hair, 0.0, most) / most;
}

}  // namespace edgecase::adversary
