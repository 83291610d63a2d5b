// SPDX-License-Identifier: MIT
//
// Nearby: numbers c0 + c1 e + c2 e^2 + ..., where e is positive and "chosen to be so small that"
// nothing changes when it is made smaller (GL 4.6 core, 14.5.1).
//
// Such numbers are ordered as a dictionary orders words: for every e below some bound, the first
// coefficient that is not zero gives the sign. Sums and products are those of polynomials. So a
// sample can really be moved by (e, e^2), whatever the size of the coordinates, and a rule's text
// be applied to where it then lies, as if there were no ties. (oracles.h moves it by 2^-16 instead,
// which is good for small coordinates; the two ways check each other.)
#pragma once

#include <array>
#include <cstddef>

#include "tests/oracles/oracles.h"
#include "tests/oracles/rational.h"

namespace edgecase::oracle {

template <std::size_t kDegree>
struct Nearby {
  std::array<Rational, kDegree + 1> c{};

  Nearby() = default;
  Nearby(const Rational& value) { c[0] = value; }  // implicit: numbers are near to themselves

  int sign() const {
    for (const Rational& coefficient : c)
      if (coefficient.sign() != 0) return coefficient.sign();
    return 0;
  }
  friend Nearby operator-(Nearby a) {
    for (Rational& coefficient : a.c) coefficient = -coefficient;
    return a;
  }
  friend Nearby operator+(Nearby a, const Nearby& b) {
    for (std::size_t i = 0; i <= kDegree; ++i) a.c[i] = a.c[i] + b.c[i];
    return a;
  }
  friend Nearby operator-(const Nearby& a, const Nearby& b) { return a + -b; }
  friend Nearby operator*(Nearby a, const Rational& by) {
    for (Rational& coefficient : a.c) coefficient = coefficient * by;
    return a;
  }
  friend bool operator<(const Nearby& a, const Nearby& b) { return (a - b).sign() < 0; }
};

template <std::size_t kA, std::size_t kB>
Nearby<kA + kB> product(const Nearby<kA>& a, const Nearby<kB>& b) {
  Nearby<kA + kB> result;
  for (std::size_t i = 0; i <= kA; ++i)
    for (std::size_t j = 0; j <= kB; ++j) result.c[i + j] = result.c[i + j] + a.c[i] * b.c[j];
  return result;
}

template <std::size_t kDegree>
Nearby<kDegree> magnitude(const Nearby<kDegree>& value) {
  return value.sign() < 0 ? -value : value;
}

// A position that may have been moved.
struct Place {
  Nearby<2> x;
  Nearby<2> y;
};

// One coordinate of a move: 0 or, as in Move, 1 for e and 2 for e^2, negative the other way.
inline Nearby<2> amount(int word) {
  Nearby<2> result;
  if (word != 0) result.c[word == 2 || word == -2 ? 2 : 1] = word < 0 ? -1 : 1;
  return result;
}

inline Place moved(const Spot& p, Move move) {
  return {Nearby<2>(p.x) + amount(move.x), Nearby<2>(p.y) + amount(move.y)};
}

}  // namespace edgecase::oracle
