// SPDX-License-Identifier: MIT
#include "profile/values/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "diff/coverage/vertex_latitude.h"
#include "diff/values/value_diff.h"
#include "raster/attributes.h"
#include "rules/values/interpolation.h"

namespace edgecase {
namespace {

// Ruling 9 permits the last operation alone this relative error.
constexpr double kCertainlyPermitted = 0.99e-5;

// The longer side of a primitive's bounding rectangle, raw.
std::int64_t extent_of(const ScenePrimitive& primitive) {
  std::int64_t extent = 0;
  for (int i = 0; i < vertices_of(primitive.kind); ++i)
    for (int j = 0; j < i; ++j) {
      const Point a = primitive.vertices[static_cast<std::size_t>(i)]->position;
      const Point b = primitive.vertices[static_cast<std::size_t>(j)]->position;
      extent = std::max({extent, std::abs((a.x - b.x).raw()), std::abs((a.y - b.y).raw())});
    }
  return extent;
}

std::pair<int, std::int64_t> size_of(const ValueExample& example) {
  const auto primitives = primitives_of(example.scene);
  return {example.scene.target.width,
          extent_of(primitives[static_cast<std::size_t>(example.primitive)])};
}

// One component of one fragment.
struct Component {
  const std::string& id;
  const Scene& scene;
  const ScenePrimitive& primitive;
  PixelPosition pixel;
  int component;
};

ValueExample example_at(const Component& at) {
  ValueExample example;
  example.id = at.id;
  example.scene = at.scene;
  example.primitive = at.primitive.index;
  example.pixel = at.pixel;
  example.component = at.component;
  return example;
}

// The formula that OpenGL permits, and how far vertices may have moved, in pixels.
struct Allowed {
  const Interpolant& formula;
  double reach;
  bool flat;
};

// The range of ruling 9, or of ruling 8: a flat colour is copied.
Interval permitted_at(const Allowed& allowed, Point sample) {
  if (allowed.flat) return rounded_to_float(interpolate_exact(allowed.formula, sample));
  return rounded_to_float(hull(interpolate_inexact(allowed.formula, sample),
                               interpolate_permitted(allowed.formula, sample, allowed.reach)));
}

bool certainly_permitted(const Allowed& allowed, Point sample, double exact, double rendered) {
  if (!std::isfinite(rendered)) return false;
  if (allowed.flat) return to_float(exact) == to_float(rendered);
  if (std::fabs(rendered - exact) <= kCertainlyPermitted * std::fabs(exact)) return true;
  return rounded_to_float(interpolate_inexact(allowed.formula, sample))
      .contains(to_float(rendered));
}

// Every one of the first, then only some: a triangle's permitted values are found over 64
// combinations of moves of its vertices.
bool is_searched(ValueErrors& row) {
  constexpr std::size_t kFirst = 4096;
  constexpr std::size_t kOneIn = 64;
  const bool searched = row.searches < kFirst || row.searches % kOneIn == 0;
  ++row.searches;
  if (!searched) ++row.not_asked;
  return searched;
}

void count_beyond(ValueErrors& row, const Component& at, const Allowed& allowed, double exact,
                  double rendered) {
  const Point sample = pixel_centre(at.pixel.x, at.pixel.y);
  if (certainly_permitted(allowed, sample, exact, rendered)) return;
  if (!allowed.flat && at.primitive.kind == PrimitiveKind::triangle && !is_searched(row)) return;
  const Interval permitted = permitted_at(allowed, sample);
  if (std::isfinite(rendered) && permitted.contains(to_float(rendered))) return;
  ++row.beyond;
  const std::pair size{at.scene.target.width, extent_of(at.primitive)};
  if (row.smallest_beyond && size_of(*row.smallest_beyond) <= size) return;
  ValueExample example = example_at(at);
  example.exact = exact;
  example.rendered = rendered;
  const double error = std::fabs(rendered - exact);
  example.ulp = error_in_ulp(exact, rendered);
  if (const double range = range_of(allowed.formula); range > 0) example.relative = error / range;
  example.permitted = permitted;
  row.smallest_beyond = std::move(example);
}

void keep_worst(ValueErrors& row, const Component& at, double exact, double rendered, double ulp,
                double relative) {
  const auto offer = [&](std::optional<ValueExample>& worst, double ValueExample::*measure,
                         double value) {
    if (worst ? value <= (*worst).*measure : value <= 0) return;
    worst = example_at(at);
    worst->exact = exact;
    worst->rendered = rendered;
    worst->ulp = ulp;
    worst->relative = relative;
  };
  offer(row.worst_ulp, &ValueExample::ulp, ulp);
  offer(row.worst_relative, &ValueExample::relative, relative);
}

// `allowed`: null if legality is not tested.
void compare(ValueErrors& row, const Component& at, const Interpolant& formula,
             const Allowed* allowed, double rendered) {
  const Interval range = interpolate_exact(formula, pixel_centre(at.pixel.x, at.pixel.y));
  // A primitive that has no extent after snapping has no value.
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return;
  const double exact = middle(range);
  ++row.components;
  if (!std::isfinite(rendered)) {
    ++row.not_numbers;
  } else if (rounded_to_float(range).contains(to_float(rendered))) {
    ++row.correct;
    return;
  } else {
    const double error = std::fabs(rendered - exact);
    const double ulp = error_in_ulp(exact, rendered);
    ++row.histogram[std::ilogb(ulp)];
    row.ulp_sum += ulp;
    const double span = range_of(formula);
    keep_worst(row, at, exact, rendered, ulp, span > 0 ? error / span : 0);
  }
  if (allowed != nullptr) count_beyond(row, at, *allowed, exact, rendered);
}

bool same_values(const ValueChoice& a, const ValueChoice& b) {
  return a.line_parameter == b.line_parameter && a.perspective == b.perspective &&
         a.positions == b.positions && a.provoking == b.provoking;
}

// Whether the renderer's own rules may change the fragments of a mode.
bool matters(const ValueChoice& found, const CoverageChoice& coverage, const ValueMode& mode,
             ValueKind kind) {
  const ValueChoice lawful;
  const bool color = kind == ValueKind::color;
  if (color && mode.interpolation == Interpolation::flat)
    return found.provoking != lawful.provoking;
  return (found.positions != lawful.positions && !coverage.snap.is_none()) ||
         (mode.kind == PrimitiveKind::line && found.line_parameter != lawful.line_parameter) ||
         (color && mode.perspective && found.perspective != lawful.perspective);
}

const Interpolant& formula_of(const PrimitiveAttributes& attributes, ValueKind kind,
                              int component) {
  switch (kind) {
    case ValueKind::color:
      break;
    case ValueKind::depth:
      return attributes.depth;
    case ValueKind::inverse_w:
      return attributes.inverse_w;
  }
  return attributes.color[static_cast<std::size_t>(component)];
}

// Depth and 1/w do not depend on the interpolation of colours, and are compared where colours cost
// least; 1/w only where it is not constant.
bool is_compared(const ValueMode& mode, ValueKind kind) {
  const bool differing_noperspective =
      mode.interpolation == Interpolation::noperspective && mode.perspective;
  if (kind == ValueKind::inverse_w) return differing_noperspective;
  return kind == ValueKind::color || differing_noperspective ||
         mode.interpolation == Interpolation::flat;
}

std::string attribute_of(const ValueMode& mode, ValueKind kind) {
  if (kind == ValueKind::color) return name_of(mode);
  return fmt::format("{} {}", name_of(mode.kind),
                     kind == ValueKind::depth ? "depth" : "gl_FragCoord.w");
}

}  // namespace

std::optional<double> reported(const Rendering& rendering, const Fragment& fragment, ValueKind kind,
                               int component) {
  switch (kind) {
    case ValueKind::color:
      if (!fragment.has_color) return std::nullopt;
      return fragment.color[static_cast<std::size_t>(component)];
    case ValueKind::depth:
      if (!fragment.has_depth) return std::nullopt;
      return fragment.depth;
    case ValueKind::inverse_w: {
      if (fragment.detail < 0) return std::nullopt;
      const FragmentDetail& detail = rendering.details[static_cast<std::size_t>(fragment.detail)];
      if (!detail.coordinates) return std::nullopt;
      return (*detail.coordinates)[3];
    }
  }
  return std::nullopt;
}

ValueErrorTable::ValueErrorTable(const RuleChoices& found, int bits)
    : lawful_(found), found_(found), bits_(bits) {
  lawful_.values = ValueChoice{};
}

ValueErrors& ValueErrorTable::row(const std::string& attribute, ValueKind kind, bool as_found) {
  for (ValueErrors& row : rows_)
    if (row.attribute == attribute && row.as_found == as_found) return row;
  rows_.push_back({});
  rows_.back().attribute = attribute;
  rows_.back().kind = kind;
  rows_.back().as_found = as_found;
  return rows_.back();
}

void ValueErrorTable::add(const ValueMode& mode, const std::string& id, const Scene& scene,
                          const Rendering& rendering) {
  struct Known {
    PrimitiveAttributes lawful;
    PrimitiveAttributes found;
    double reach;
  };
  const auto primitives = primitives_of(scene);
  std::vector<Known> known;
  for (const ScenePrimitive& primitive : primitives)
    known.push_back({attributes_of(primitive, lawful_, scene.target),
                     attributes_of(primitive, found_, scene.target),
                     reach_of(primitive, bits_).to_double()});
  const bool found_differs = !same_values(found_.values, lawful_.values);
  for (const ValueKind kind : {ValueKind::color, ValueKind::depth, ValueKind::inverse_w}) {
    if (!is_compared(mode, kind)) continue;
    const std::string attribute = attribute_of(mode, kind);
    const int components = kind == ValueKind::color ? 4 : 1;
    const bool flat = kind == ValueKind::color && mode.interpolation == Interpolation::flat;
    for (const bool as_found : {false, true}) {
      if (as_found && !(found_differs && matters(found_.values, found_.of(mode.kind), mode, kind)))
        continue;
      ValueErrors& errors = row(attribute, kind, as_found);
      for (const Fragment& fragment : rendering.fragments) {
        const auto index = static_cast<std::size_t>(fragment.primitive);
        if (!reported(rendering, fragment, kind, 0)) continue;
        ++errors.fragments;
        for (int c = 0; c < components; ++c) {
          const Component at{id, scene, primitives[index], {fragment.x, fragment.y}, c};
          const Allowed allowed{formula_of(known[index].lawful, kind, c), known[index].reach, flat};
          compare(errors, at,
                  formula_of(as_found ? known[index].found : known[index].lawful, kind, c),
                  as_found ? nullptr : &allowed, *reported(rendering, fragment, kind, c));
        }
      }
    }
  }
}

}  // namespace edgecase
