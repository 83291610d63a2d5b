// SPDX-License-Identifier: MIT
//
// The exact rasterizer's shading stage: what a primitive's fragments carry, under a policy.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "exact/pixel.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/values/derivative.h"
#include "rules/values/interpolation.h"

namespace edgecase {

class CentreColors;
struct ExactLookup;

// The attributes that are interpolated over one primitive.
struct PrimitiveAttributes {
  // A flat colour is the same at all vertices, that of the provoking one. A textured draw has s, t,
  // 0 and 1 in the colour's place.
  std::array<Interpolant, 4> color;
  // Window depth, 0 to 1; with the polygon offset, where there is one, and then of any size.
  Interpolant depth;
  Interpolant inverse_w;      // 1/w, as gl_FragCoord.w has it
  bool w_of_centre = false;   // the colour is multiplied by w at the centre of the pixel
  bool clamps_depth = false;  // to 0 to 1, once it is interpolated: there is a polygon offset
};

// A component of the colour at a place of a pixel, as interpolate_exact has it.
Interval color_exact(const PrimitiveAttributes& attributes, std::size_t component, Point place,
                     PixelPosition pixel);
Interval color_inexact(const PrimitiveAttributes& attributes, std::size_t component, Point place,
                       PixelPosition pixel);

// A fragment's depth at a place of the window: clamped where the attributes say so (GL 4.6
// core, 14.6.5).
Interval depth_exact(const PrimitiveAttributes& attributes, Point place);
// Of a depth that was interpolated from `attributes.depth`, or from what takes its place.
Interval clamped_depth(const PrimitiveAttributes& attributes, Interval interpolated);

// Do colour and depth stay the same to the bit, wherever the sample lies?
bool are_constant(const PrimitiveAttributes& attributes);

PrimitiveAttributes attributes_of(const ScenePrimitive& primitive, const RuleChoices& choices,
                                  const Target& target);

// PrimitiveAttributes::depth without any polygon offset.
Interpolant depth_without_offset(const ScenePrimitive& primitive, const RuleChoices& choices,
                                 const Target& target);

// PrimitiveAttributes::depth with all that the vertices' depths may be off by
// (VertexAttributes::permitted_depth), and every polygon offset that is permitted in place of the
// one that the choices say: as wide as offset_permitted is. `reach`, `fixed_unit`: as there.
Interpolant permitted_depth(const ScenePrimitive& primitive, const RuleChoices& choices,
                            const Target& target, double reach, Interval fixed_unit);
// The same of PrimitiveAttributes::inverse_w.
Interpolant permitted_inverse_w(const ScenePrimitive& primitive, const RuleChoices& choices,
                                const Target& target);

// The pixel within its quad.
QuadPixel quad_of(PixelPosition pixel, const ValueChoice& choice, const Target& target);

// The double nearest to the middle: the interval is narrower than what any format can hold. One
// that holds zero is zero: beside it, any other number would look exact to many places.
double middle(Interval value);

// The fragment that a primitive has at a pixel's centre: colour and depth are the doubles nearest
// to the exact values, to within 2^-48 of the largest vertex value. `lookup`: that of a textured
// draw, whose colour is what was looked up.
Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, const ExactLookup* lookup = nullptr);

// The same, its colour taken from `colors`, which are of these attributes.
Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, CentreColors& colors);

// Where in the window a fragment of a multisampled target takes its values.
struct ShadingPlaces {
  Point color;
  Point depth;        // gl_FragCoord.z
  Point coordinates;  // gl_FragCoord.xy, and w
};
Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, const ShadingPlaces& places);
// gl_FragCoord.
std::array<double, 4> coordinates_at(const PrimitiveAttributes& attributes,
                                     const ShadingPlaces& places);

// What a scene asks to be told of the fragment beside; of textures, where there is a lookup.
// `colors`: of these attributes.
FragmentDetail shade_details(const PrimitiveAttributes& attributes, CentreColors& colors,
                             const QuadPixel& at, const ValueChoice& choice, const Details& asked,
                             const ExactLookup* lookup = nullptr);

// Is what shade_details tells the same for all fragments of the primitive?
bool are_details_constant(const PrimitiveAttributes& attributes, const Details& asked,
                          bool has_lookup);

// CentreColors: what the colours of primitives, one after another, are at pixels' centres, for
// derivatives, which are differences of neighbours.
class CentreColors {
 public:
  // `width`: of the target, pixels.
  explicit CentreColors(int width);

  // From now on the primitive with these components. They have the same vertices and line
  // parameter, and those that have perspective the same w; they must stay where they are.
  void take(const std::array<Interpolant, 4>& components);

  using Components = std::array<Interval, 4>;
  struct Derivatives {
    Components exact;
    std::array<double, 4> middles{};  // see raster/attributes.h
  };
  // As interpolate_exact and derivative_exact have them. What is linear has the same derivatives at
  // all pixels. Of the rest, asked row by row: of the latest rows, colours and their differences,
  // which the pixels of a quad share, are kept. Valid until the next question.
  const Components& at(PixelPosition pixel);
  const Derivatives& derivatives(const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  struct AtPixel {
    std::size_t primitive = 0;
    PixelPosition pixel;
    Components values;
  };
  struct AtNeighbours {
    std::size_t primitive = 0;
    Neighbours pixels;
    Derivatives derivatives;
  };

  std::size_t place_of(PixelPosition pixel) const;
  Components difference(const Neighbours& of, Axis axis);

  const std::array<Interpolant, 4>* components_ = nullptr;
  std::array<bool, 4> are_linear_{};
  std::array<Derivatives, 2> slopes_;  // of those, by axis
  std::size_t primitive_ = 0;          // taken so far
  std::size_t columns_;                // a power of two
  // By row and column, the lowest bits of each; differences by axis and by their first pixel.
  std::vector<AtPixel> known_;
  std::array<std::vector<AtNeighbours>, 2> differences_;
  Derivatives analytic_;  // the latest
};

}  // namespace edgecase
