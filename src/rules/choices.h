// SPDX-License-Identifier: MIT
//
// Choices: a policy looked up once, so that predicates get values and not names.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "model/policy.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/polygon_facing.h"
#include "rules/coverage/snap.h"
#include "rules/coverage/tie_rule.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/window.h"
#include "rules/output/blending.h"
#include "rules/output/depth_test.h"
#include "rules/output/polygon_offset.h"
#include "rules/output/stencil_test.h"
#include "rules/samples/accumulation.h"
#include "rules/samples/alpha_to_coverage.h"
#include "rules/samples/attribute_location.h"
#include "rules/samples/multisampled_line.h"
#include "rules/samples/resolve.h"
#include "rules/samples/sample_mask.h"
#include "rules/samples/sample_placement.h"
#include "rules/samples/shading_rate.h"
#include "rules/textures/anisotropy.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/level_selection.h"
#include "rules/textures/mip_chain.h"
#include "rules/textures/texel_filter.h"
#include "rules/textures/wrap.h"
#include "rules/values/derivative.h"
#include "rules/values/flat_attribute.h"
#include "rules/values/interpolation.h"
#include "rules/values/smooth_attribute.h"

namespace edgecase {

// What a policy says for one kind of primitive.
struct CoverageChoice {
  Snap snap;
  RowOrder rows = RowOrder::bottom_up;  // snapping, ties and all else see the target so
  // Lines that are drawn as areas have the ties of polygons, which see the target so.
  RowOrder polygon_rows = RowOrder::bottom_up;
  TieRule ties;     // of a point's square, a triangle's edges, a line drawn as an area
  LineChoice line;  // of lines alone
  PointOffset point_offset = PointOffset::none;                              // of points alone
  TriangleAlgorithm triangle_algorithm = TriangleAlgorithm::edge_functions;  // of triangles alone
  FacingMethod facing = FacingMethod::as_set;                                // of triangles alone
  ClipMethod clip = ClipMethod::homogeneous;                                 // of triangles alone
  // Of multisampled targets.
  SamplePlacement placement;
  MultisampledLine multisampled_line = MultisampledLine::rectangle;  // of lines alone
  MultisampleSwitch multisample_switch = MultisampleSwitch::honoured;
  SampleMask sample_mask = SampleMask::applied;
  friend bool operator==(const CoverageChoice&, const CoverageChoice&) = default;
};

// What a policy says of attributes.
struct ValueChoice {
  ProvokingChoice provoking = ProvokingChoice::as_set;
  LineParameter line_parameter = LineParameter::projection;
  PerspectiveChoice perspective = PerspectiveChoice::as_set;
  AttributePositions positions = AttributePositions::unsnapped;
  // Of the plain, the fine and the coarse forms (form_of in rules/values/derivative.h).
  std::array<DerivativeMethod, 3> derivatives{DerivativeMethod::fine, DerivativeMethod::fine,
                                              DerivativeMethod::coarse_bottom_left};
  RowOrder quad_rows = RowOrder::bottom_up;
  LocationChoice locations;  // of multisampled targets
  OffsetChoice offset;       // of triangles' depths
};

// What a policy says of texture lookups.
struct TextureChoice {
  WrapChoice wrap = WrapChoice::as_set;
  TexelGrid texel_grid = TexelGrid::none;
  ScaleFactor scale_factor = ScaleFactor::lengths;
  Log2Method log2 = Log2Method::exact;
  DerivativeMethod derivatives = DerivativeMethod::fine;  // that the scale factor is made of
  BiasChoice bias = BiasChoice::as_set;
  Crossover crossover = Crossover::zero;
  NearestLevel nearest_level = NearestLevel::down_at_ties;
  LevelWeight level_weight = LevelWeight::exact;
  Anisotropy anisotropy = Anisotropy::extension;
  LevelCount level_count = LevelCount::larger_side;
  MipmapMethod mipmap;  // of generated chains

  friend bool operator==(const TextureChoice&, const TextureChoice&) = default;
};

// What a policy says of invocations and samples of multisampled targets, and of passes.
struct SampleChoice {
  ShadingRate rate = ShadingRate::as_needed;
  AlphaToCoverage alpha_to_coverage = AlphaToCoverage::proportional;
  ResolveMethod resolve = ResolveMethod::nearest_even;
  Accumulation accumulation = Accumulation::exact_mean;  // of supersampled scenes
};

// What a policy says of what becomes of fragments.
struct OutputChoice {
  DepthTestMethod depth = DepthTestMethod::as_set;
  DepthMaskMethod depth_mask = DepthMaskMethod::as_set;
  StencilMethod stencil = StencilMethod::as_set;
  BlendChoice blend;
};

// What a policy says for one surface.
struct RuleChoices {
  CoverageChoice points;
  CoverageChoice lines;
  CoverageChoice triangles;
  ValueChoice values;
  TextureChoice textures;
  SampleChoice samples;
  OutputChoice output;

  const CoverageChoice& of(PrimitiveKind kind) const;
};

// Rules and alternatives that the policy names must be of the catalogue.
RuleChoices resolve(const Policy& policy, Surface surface);

// What OpenGL's own policy, which chooses nothing, has on every surface.
const RuleChoices& standard_choices();

// A policy with its choices looked up for every surface: once, and then handed down.
class ResolvedPolicy {
 public:
  ResolvedPolicy(const Policy& policy = {});  // implicit: whoever has a policy may draw by it

  const RuleChoices& on(Surface surface) const {
    return choices_[static_cast<std::size_t>(surface)];
  }
  Latitude latitude() const { return latitude_; }
  // Does the policy choose nothing?
  bool is_standard() const { return is_standard_; }

 private:
  std::array<RuleChoices, values_of<Surface>().size()> choices_;
  Latitude latitude_;
  bool is_standard_;
};

// The rules by which ties of a kind of primitive are decided, of its snapping and its row order.
RuleId coverage_rule_of(PrimitiveKind kind);
RuleId snap_rule_of(PrimitiveKind kind);
RuleId row_order_rule_of(PrimitiveKind kind);

}  // namespace edgecase
