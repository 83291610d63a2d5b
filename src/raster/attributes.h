// SPDX-License-Identifier: MIT
//
// The exact rasterizer's shading stage: the colour, depth and details of a primitive's fragments.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/output/fragment_outcome.h"
#include "rules/values/clipped_attributes.h"
#include "rules/values/derivative.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// A vertex's position for its primitive's coverage: snapped as the choice says, or exact. Vertices
// of a clipped primitive are not snapped, since clipping makes new vertices, which are.
HomogeneousPoint snapped_position(const ScenePrimitive& primitive, std::size_t vertex,
                                  const CoverageChoice& choice, const Target& target);

// The vertices from which attributes are interpolated: a primitive's own or, if some lie outside
// the clip volume, three points of the visible part of a triangle (ClippedPlane) or the two ends of
// the visible part of a line.
class VertexAttributes {
 public:
  // Only vertices take snapped positions; the points of a clipped primitive stay.
  VertexAttributes(const ScenePrimitive& primitive, const RuleChoices& choices,
                   const Target& target);

  // One number at each vertex. If nothing of a clipped primitive is visible, the result is an
  // interpolant without extent and of arbitrary value.
  Interpolant with_values(const std::array<double, 3>& values, bool perspective) const;
  // Window depth, 0 to 1, without a polygon offset.
  Interpolant depth() const;
  Interpolant inverse_w() const;  // 1/w

  // The same, widened by the permitted errors of the operations that make them from clip
  // coordinates (GL 4.6 core, 2.3.4.1): the division by w, the scaling and addition of 13.8.1 and,
  // before these, the means of 13.7.1 at vertices made by clipping.
  Interpolant permitted_depth() const;
  Interpolant permitted_inverse_w() const;

 private:
  Interpolant coordinate() const;
  Interval permitted_w(std::size_t vertex) const;

  const ScenePrimitive* primitive_;
  std::optional<ClippedPlane> plane_;
  std::optional<CutLine> cut_;
  Interpolant geometry_;  // without values
};

class CentreColors;
struct ExactLookup;

// The attributes that are interpolated over one primitive.
struct PrimitiveAttributes {
  // A flat colour has the provoking vertex's value at all vertices. A textured draw has s, t, 0 and
  // 1 here instead of a colour.
  std::array<Interpolant, 4> color;
  // Window depth: 0 to 1, or of any size once a polygon offset is added.
  Interpolant depth;
  Interpolant inverse_w;      // 1/w, the value of gl_FragCoord.w
  bool w_of_centre = false;   // whether the colour is multiplied by w at the pixel's centre
  bool clamps_depth = false;  // with a polygon offset: clamp the interpolated depth to 0..1
};

// A colour component at a point of a pixel, by interpolate_exact or its inexact counterpart.
Interval color_exact(const PrimitiveAttributes& attributes, std::size_t component, Point place,
                     PixelPosition pixel);
Interval color_inexact(const PrimitiveAttributes& attributes, std::size_t component, Point place,
                       PixelPosition pixel);

// A fragment's depth at a point of the window, clamped if `clamps_depth` says so (GL 4.6 core,
// 14.6.5).
Interval depth_exact(const PrimitiveAttributes& attributes, Point place);
// Clamps a depth interpolated from `attributes.depth` or its substitute if `clamps_depth` is set.
Interval clamped_depth(const PrimitiveAttributes& attributes, Interval interpolated);

// Returns true if colour and depth are the same, to the bit, at every sample.
bool are_constant(const PrimitiveAttributes& attributes);

PrimitiveAttributes attributes_of(const ScenePrimitive& primitive, const RuleChoices& choices,
                                  const Target& target);

// PrimitiveAttributes::depth without any polygon offset.
Interpolant depth_without_offset(const ScenePrimitive& primitive, const RuleChoices& choices,
                                 const Target& target);

// Attributes, and the depth and 1/w widened by what is permitted: the error of the vertices' own
// (VertexAttributes) and, for the depth, every polygon offset besides the chosen one. `reach` and
// `fixed_unit` are those of offset_permitted.
struct PermittedAttributes {
  PrimitiveAttributes chosen;
  Interpolant depth;
  Interpolant inverse_w;
};
PermittedAttributes permitted_attributes_of(const ScenePrimitive& primitive,
                                            const RuleChoices& choices, const Target& target,
                                            double reach, Interval fixed_unit);

// The pixel and its place in its 2x2 quad.
QuadPixel quad_of(PixelPosition pixel, const ValueChoice& choice, const Target& target);

// The double nearest to the middle of an interval that is narrower than any format resolves. An
// interval that holds zero gives zero: any other number would wrongly look exact to many digits.
double middle(Interval value);

// A fragment without a colour.
Fragment fragment_at(const ScenePrimitive& primitive, PixelPosition pixel, Interval depth);

// The fragment of a primitive at a pixel's centre. Colour and depth are the doubles nearest to the
// exact values, to within 2^-48 of the largest vertex value. In a textured draw `lookup` gives the
// colour; otherwise it is null.
Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, const ExactLookup* lookup = nullptr);

// The points of the window at which a fragment of a multisampled target takes its values.
struct ShadingPlaces {
  Point color;
  Point depth;        // gl_FragCoord.z
  Point coordinates;  // gl_FragCoord.xy, and w
};
Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, const ShadingPlaces& places);
// The value of gl_FragCoord.
std::array<double, 4> coordinates_at(const PrimitiveAttributes& attributes,
                                     const ShadingPlaces& places);

// The further values of a fragment that a scene requests; those of textures need a lookup. `colors`
// must have taken these attributes.
FragmentDetail shade_details(const PrimitiveAttributes& attributes, CentreColors& colors,
                             const QuadPixel& at, const ValueChoice& choice, const Details& asked,
                             const ExactLookup* lookup = nullptr);

// Returns true if shade_details gives the same result for all fragments of the primitive.
bool are_details_constant(const PrimitiveAttributes& attributes, const Details& asked,
                          bool has_lookup);

// CentreColors: the colours of one primitive after another at pixels' centres. Derivatives are
// differences between neighbouring ones.
class CentreColors {
 public:
  // `width` of the target, in pixels.
  explicit CentreColors(int width);

  // Selects the primitive with these components. All share vertices and line parameter; those with
  // perspective share w. They are not copied and must stay valid.
  void take(const std::array<Interpolant, 4>& components);

  using Components = std::array<Interval, 4>;
  struct Derivatives {
    Components exact;
    std::array<double, 4> middles{};  // see `middle`
  };
  // The values of interpolate_exact and derivative_exact. A linear component has one derivative for
  // all pixels. For the others, recent rows of colours and of differences, which a quad's pixels
  // share, are kept, so query row by row. A result is valid until the next query.
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
  bool is_known(PixelPosition pixel) const;
  std::size_t run_from(PixelPosition pixel) const;
  Components difference(const Neighbours& of, Axis axis);

  const std::array<Interpolant, 4>* components_ = nullptr;
  std::array<bool, 4> are_linear_{};
  std::array<Derivatives, 2> slopes_;  // of linear components, by axis
  std::size_t primitive_ = 0;          // the number of primitives taken so far
  std::size_t columns_;                // a power of two
  // Indexed by the lowest bits of row and column; differences by axis and by their first pixel.
  std::vector<AtPixel> known_;
  std::array<std::vector<AtNeighbours>, 2> differences_;
  Derivatives analytic_;  // the latest result of the analytic method
};

// FragmentStage: what rules/output/fragment_outcome.h makes of fragments, in the planes of a
// rendering. Callers decide which samples a fragment stands for, and the depth of each.

class FragmentStage {
 public:
  // Refers to rendering and target; the rendering's planes must have been cleared.
  FragmentStage(Rendering& rendering, const Target& target, const OutputChoice& choice);

  // `sample` as in Rendering::sample_index. Counts a hit if all tests pass.
  void draw(const ExactFragment& fragment, const FragmentOperations& operations,
            std::size_t sample) const;
  // Draws the same fragment at each of these pixels; the target has one sample per pixel.
  void draw_at_all(const ExactFragment& fragment, const FragmentOperations& operations,
                   std::span<const PixelPosition> pixels) const;

 private:
  Rendering& rendering_;
  const OutputRules rules_;
  // By sample: SampleValues::operated, where the choice asks for it.
  mutable std::vector<const FragmentOperations*> operated_;
};

}  // namespace edgecase
