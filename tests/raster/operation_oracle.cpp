// SPDX-License-Identifier: MIT
#include "tests/raster/operation_oracle.h"

#include <algorithm>

#include "exact/rational.h"
#include "model/rendering.h"

namespace edgecase::oracle {
namespace {

Rational clamped(const Rational& value) {
  return value < 0 ? Rational(0) : value > 1 ? Rational(1) : value;
}

// The nearest integer, of two the even one.
Integer nearest(const Rational& value) {
  const Integer below = floor_of(value);
  const Rational rest = value - Rational(below);
  if (rest * 2 == 1) return below % 2 == 0 ? below : Integer(below + 1);
  return rest * 2 < 1 ? below : Integer(below + 1);
}

int to_code(const Rational& value) {
  return static_cast<int>(nearest(clamped(value) * 255));
}

double stored_depth(double depth, DepthFormat format) {
  // Clamped whatever the format (ruling 18).
  if (format == DepthFormat::depth32f)
    return static_cast<double>(static_cast<float>(std::min(std::max(depth, 0.0), 1.0)));
  const int largest = format == DepthFormat::depth16 ? 65535 : 16777215;
  const Integer steps = nearest(clamped(rational_of(depth)) * largest);
  return static_cast<double>(steps) / largest;
}

template <class Number>
bool compares(CompareFunction function, const Number& left, const Number& right) {
  switch (function) {
    case CompareFunction::never:
      return false;
    case CompareFunction::less:
      return left < right;
    case CompareFunction::equal:
      return left == right;
    case CompareFunction::lequal:
      return left <= right;
    case CompareFunction::greater:
      return left > right;
    case CompareFunction::notequal:
      return left != right;
    case CompareFunction::gequal:
      return left >= right;
    case CompareFunction::always:
      return true;
  }
  return false;
}

// ------------------------------------------------------------------------------------- stencil

int operated(StencilOperation operation, int stored, int reference) {
  switch (operation) {
    case StencilOperation::keep:
      return stored;
    case StencilOperation::zero:
      return 0;
    case StencilOperation::replace:
      return reference;
    case StencilOperation::incr:
      return stored == 255 ? 255 : stored + 1;
    case StencilOperation::decr:
      return stored == 0 ? 0 : stored - 1;
    case StencilOperation::incr_wrap:
      return stored == 255 ? 0 : stored + 1;
    case StencilOperation::decr_wrap:
      return stored == 0 ? 255 : stored - 1;
    case StencilOperation::invert:
      return 255 - stored;
  }
  return stored;
}

// Bit by bit: where the mask has a 1, the new value's.
int masked(int before, int after, int mask) {
  int result = 0;
  for (int bit = 1; bit < 256; bit *= 2) result += (mask & bit) != 0 ? after & bit : before & bit;
  return result;
}

// ------------------------------------------------------------------------------------ blending

using Rgba = std::array<Rational, 4>;

struct Operands {
  Rgba source;
  Rgba destination;
  Rgba constant;
};

// Table 17.2, of the component c.
Rational factor(BlendFactor name, const Operands& of, std::size_t c) {
  switch (name) {
    case BlendFactor::zero:
      return 0;
    case BlendFactor::one:
      return 1;
    case BlendFactor::src_color:
      return of.source[c];
    case BlendFactor::one_minus_src_color:
      return 1 - of.source[c];
    case BlendFactor::dst_color:
      return of.destination[c];
    case BlendFactor::one_minus_dst_color:
      return 1 - of.destination[c];
    case BlendFactor::src_alpha:
      return of.source[3];
    case BlendFactor::one_minus_src_alpha:
      return 1 - of.source[3];
    case BlendFactor::dst_alpha:
      return of.destination[3];
    case BlendFactor::one_minus_dst_alpha:
      return 1 - of.destination[3];
    case BlendFactor::constant_color:
      return of.constant[c];
    case BlendFactor::one_minus_constant_color:
      return 1 - of.constant[c];
    case BlendFactor::constant_alpha:
      return of.constant[3];
    case BlendFactor::one_minus_constant_alpha:
      return 1 - of.constant[3];
    case BlendFactor::src_alpha_saturate: {
      const Rational rest = 1 - of.destination[3];
      return c == 3 ? Rational(1) : std::min(of.source[3], rest);
    }
  }
  return 0;
}

Rational blended(const BlendTerm& term, const Operands& of, std::size_t c) {
  const Rational source = of.source[c] * factor(term.source, of, c);
  const Rational destination = of.destination[c] * factor(term.destination, of, c);
  switch (term.equation) {
    case BlendEquation::add:
      return source + destination;
    case BlendEquation::subtract:
      return source - destination;
    case BlendEquation::reverse_subtract:
      return destination - source;
    case BlendEquation::min:
      return std::min(of.source[c], of.destination[c]);
    case BlendEquation::max:
      return std::max(of.source[c], of.destination[c]);
  }
  return 0;
}

void write_color(const std::array<double, 4>& color, const FragmentOperations& operations,
                 std::array<int, 4>& stored) {
  Operands of;
  for (std::size_t c = 0; c < 4; ++c) {
    of.source[c] = clamped(rational_of(color[c]));
    of.destination[c] = Rational(stored[c], 255);
    if (operations.blending) of.constant[c] = rational_of(operations.blending->constant[c]);
  }
  for (std::size_t c = 0; c < 4; ++c) {
    if (!operations.color_mask[c]) continue;
    // What is not blended is converted as without any operations.
    const auto& blending = operations.blending;
    stored[c] = blending ? to_code(blended(c == 3 ? blending->alpha : blending->color, of, c))
                         : to_unorm8(color[c]);
  }
}

}  // namespace

Stored cleared(const Target& target) {
  Stored stored;
  for (std::size_t c = 0; c < 4; ++c) stored.color[c] = to_code(rational_of(target.clear[c]));
  stored.depth = stored_depth(static_cast<double>(target.clear_depth), target.depth);
  stored.stencil = target.clear_stencil;
  return stored;
}

void arrive(const Arriving& fragment, const FragmentOperations& operations, const Target& target,
            Stored& stored) {
  StencilFace face;
  if (target.stencil != StencilFormat::none && operations.stencil)
    face = fragment.front_facing ? operations.stencil->front : operations.stencil->back;
  const auto store = [&](StencilOperation operation) {
    const int result = operated(operation, stored.stencil, face.reference);
    stored.stencil = masked(stored.stencil, result, face.write_mask);
  };
  if (!compares(face.function, face.reference & face.read_mask, stored.stencil & face.read_mask)) {
    store(face.fail);
    return;
  }
  if (target.depth != DepthFormat::none) {
    const double depth = stored_depth(fragment.depth, target.depth);
    if (!compares(operations.depth.function, depth, stored.depth)) {
      store(face.depth_fail);
      return;
    }
    if (operations.depth.write) stored.depth = depth;
  }
  store(face.pass);
  ++stored.hits;
  write_color(fragment.color, operations, stored.color);
}

bool faces_front(const ScenePrimitive& primitive) {
  if (primitive.kind != PrimitiveKind::triangle) return true;
  const auto x = [&](int i) {
    return Int128{primitive.vertices[static_cast<std::size_t>(i)]->position.x.raw()};
  };
  const auto y = [&](int i) {
    return Int128{primitive.vertices[static_cast<std::size_t>(i)]->position.y.raw()};
  };
  // Twice the area, equation 14.10.
  const Int128 area =
      x(0) * y(1) - x(1) * y(0) + x(1) * y(2) - x(2) * y(1) + x(2) * y(0) - x(0) * y(2);
  return primitive.state->front_face == FrontFace::ccw ? area > 0 : area < 0;
}

}  // namespace edgecase::oracle
