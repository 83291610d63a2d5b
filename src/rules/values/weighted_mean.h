// SPDX-License-Identifier: MIT
//
// The formulas of interpolation, once for all kinds of numbers (GL 4.6 core, 14.5.1 and 14.6.1). A
// primitive has `count` vertices; entries beyond them are left as they are.
//
//   mean    sum(w_i f_i) / sum(w_i), each weight w_i divided by its vertex's clip w for perspective
//   slope   sum(w_i' (f_i - f)) / sum(w_i), for the mean f and the weights' own slopes w_i'
//
//   numbers                       arithmetic       instance
//   forms with exact quotients    their operators  rational_interpolation
//   intervals, alone or in lanes  their operators  exact_interpolation, clipped_attributes
//   intervals, alone or in lanes  Inexact          inexact_ and permitted_interpolation
//   planes of doubles             their operators  kernels/color_planes
//
// The order of operations is the same for all, since it decides the last digits. What a sum starts
// from is the caller's choice: for its first term, Inexact counts an addition to 0 that errs, too.
// The weights themselves are shared where the arithmetic allows it: exact intervals are made of
// integer determinants, which round once.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "exact/homogeneous.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// A number's own operators. The result is of the left operand's kind.
struct OwnOperators {
  template <class A, class B>
  static A add(const A& a, const B& b) {
    return a + b;
  }
  template <class A, class B>
  static A subtract(const A& a, const B& b) {
    return a - b;
  }
  template <class A, class B>
  static A multiply(const A& a, const B& b) {
    return a * b;
  }
  template <class A, class B>
  static A divide(const A& a, const B& b) {
    return a / b;
  }
};
inline constexpr OwnOperators kOwnOperators;

// Whether `Arithmetic` computes means of `Value`s by weights that are `Number`s.
template <class Arithmetic, class Number, class Value>
concept Averages = requires(const Arithmetic& op, const Number& weight, const Value& value) {
  { op.add(weight, weight) } -> std::same_as<Number>;
  { op.multiply(weight, value) } -> std::same_as<Number>;
};

// One per vertex.
template <class Number>
using WeightsOf = std::array<Number, 3>;

// `sum` and, for each vertex from `first` on, w_i f_i.
template <class Arithmetic, class Number, class Value>
requires Averages<Arithmetic, Number, Value> Number add_weighted(const Arithmetic& op, Number sum,
                                                                 const WeightsOf<Number>& weights,
                                                                 const std::array<Value, 3>& values,
                                                                 std::size_t first,
                                                                 std::size_t count) {
  for (std::size_t i = first; i < count; ++i) sum = op.add(sum, op.multiply(weights[i], values[i]));
  return sum;
}

// The sum of w_i f_i, from its first term on.
template <class Arithmetic, class Number, class Value>
Number weighted_sum(const Arithmetic& op, const WeightsOf<Number>& weights,
                    const std::array<Value, 3>& values, std::size_t count) {
  return add_weighted(op, op.multiply(weights[0], values[0]), weights, values, 1, count);
}

// `sum` and, for each vertex from `first` on, w_i.
template <class Arithmetic, class Number>
Number add_weights(const Arithmetic& op, Number sum, const WeightsOf<Number>& weights,
                   std::size_t first, std::size_t count) {
  for (std::size_t i = first; i < count; ++i) sum = op.add(sum, weights[i]);
  return sum;
}

// The weights with perspective.
template <class Arithmetic, class Number, class Value>
WeightsOf<Number> divided_by_w(const Arithmetic& op, WeightsOf<Number> weights,
                               const std::array<Value, 3>& w, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) weights[i] = op.divide(weights[i], w[i]);
  return weights;
}

// The numerator of a slope without its first term, if `first` is 1. The first term is 0 where f is
// the first vertex's value.
template <class Arithmetic, class Number, class Value>
Number slope_sum(const Arithmetic& op, const WeightsOf<Number>& slopes, std::array<Value, 3> values,
                 const Value& mean, std::size_t first, std::size_t count) {
  for (std::size_t i = first; i < count; ++i) values[i] = op.subtract(values[i], mean);
  return add_weighted(op, Number{}, slopes, values, first, count);
}

// What each vertex of a triangle has of the edge opposite to it, which runs from the next vertex to
// the one after that.
template <class Vertex, class Function>
auto by_opposite_edge(const std::array<Vertex, 3>& v, const Function& of_edge) {
  return std::array{of_edge(v[1], v[2]), of_edge(v[2], v[0]), of_edge(v[0], v[1])};
}

// A triangle's weights, from the determinants that its edges form with the sample: each holds all
// denominators except that of the vertex opposite to it. `Factor`: what a weight is multiplied by.
template <class Factor, class Function>
auto triangle_weights(const std::array<HomogeneousPoint, 3>& v, const Function& side_of) {
  auto weights = by_opposite_edge(v, side_of);
  for (std::size_t i = 0; i < 3; ++i) weights[i] = weights[i] * static_cast<Factor>(v[i].w);
  return weights;
}

// A line's weights at p, pixels: 1 - t and t, as LineParameter says.
template <class Arithmetic, class Number, class Coordinate>
WeightsOf<Number> line_weights(const Arithmetic& op, const Interpolant& line,
                               const std::array<std::array<Coordinate, 2>, 3>& v,
                               const std::array<Number, 2>& p) {
  const Coordinate dx = op.subtract(v[1][0], v[0][0]);
  const Coordinate dy = op.subtract(v[1][1], v[0][1]);
  Number t;
  if (line.line_parameter != LineParameter::projection) {
    const std::size_t axis = goes_by_x(line) ? 0 : 1;
    t = op.divide(op.subtract(p[axis], v[0][axis]), axis == 0 ? dx : dy);
  } else {
    const Number along = op.add(op.multiply(op.subtract(p[0], v[0][0]), dx),
                                op.multiply(op.subtract(p[1], v[0][1]), dy));
    const Coordinate squared_length = op.add(op.multiply(dx, dx), op.multiply(dy, dy));
    t = op.divide(along, squared_length);
  }
  return {op.subtract(Number(1), t), t, Number{}};
}

}  // namespace edgecase
