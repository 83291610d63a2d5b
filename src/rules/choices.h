// SPDX-License-Identifier: MIT
//
// Choices: a policy looked up once, so that predicates get values and not names.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/policy.h"
#include "model/scene.h"
#include "model/verdict.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/tie_rule.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "rules/output/blending.h"
#include "rules/output/fragment_tests.h"
#include "rules/output/polygon_offset.h"
#include "rules/samples/attribute_location.h"
#include "rules/samples/multisampled_line.h"
#include "rules/samples/resolve.h"
#include "rules/samples/sample_mask.h"
#include "rules/samples/sample_placement.h"
#include "rules/samples/shading_rate.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/level_selection.h"
#include "rules/textures/mip_chain.h"
#include "rules/textures/texel_filter.h"
#include "rules/textures/texture_image.h"
#include "rules/values/attributes.h"
#include "rules/values/derivative.h"
#include "rules/values/framebuffer.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// A policy's choices for one kind of primitive.
struct CoverageChoice {
  Snap snap;
  RowOrder rows = RowOrder::bottom_up;  // the target's direction for snapping, ties and all else
  // The direction for lines drawn as areas, which have the ties of polygons.
  RowOrder polygon_rows = RowOrder::bottom_up;
  TieRule ties;     // of a point's square, a triangle's edges, a line drawn as an area
  LineChoice line;  // for lines only
  PointOffset point_offset = PointOffset::none;                              // for points only
  PointClip point_clip = PointClip::as_set;                                  // for points only
  TriangleAlgorithm triangle_algorithm = TriangleAlgorithm::edge_functions;  // for triangles only
  FacingMethod facing = FacingMethod::as_set;                                // for triangles only
  ClipMethod clip = ClipMethod::homogeneous;                                 // for triangles only
  LineClip line_clip = LineClip::as_set;                                     // for lines only
  // For multisampled targets.
  SamplePlacement placement;
  MultisampledLine multisampled_line = MultisampledLine::rectangle;  // for lines only
  MultisampleSwitch multisample_switch = MultisampleSwitch::honoured;
  SampleMask sample_mask = SampleMask::applied;
  friend bool operator==(const CoverageChoice&, const CoverageChoice&) = default;
};

// A policy's choices for attributes.
struct ValueChoice {
  ProvokingChoice provoking = ProvokingChoice::as_set;
  LineParameter line_parameter = LineParameter::projection;
  PerspectiveChoice perspective = PerspectiveChoice::as_set;
  AttributePositions positions = AttributePositions::unsnapped;
  // For the plain, fine and coarse forms (form_of in rules/values/derivative.h).
  std::array<DerivativeMethod, 3> derivatives{DerivativeMethod::fine, DerivativeMethod::fine,
                                              DerivativeMethod::coarse_bottom_left};
  RowOrder quad_rows = RowOrder::bottom_up;
  LocationChoice locations;  // on multisampled targets
  OffsetChoice offset;       // for triangles' depths
};

// A policy's choices for texture lookups.
struct TextureChoice {
  WrapChoice wrap = WrapChoice::as_set;
  TexelGrid texel_grid = TexelGrid::none;
  ScaleFactor scale_factor = ScaleFactor::lengths;
  Log2Method log2 = Log2Method::exact;
  DerivativeMethod derivatives = DerivativeMethod::fine;  // from which the scale factor is made
  BiasChoice bias = BiasChoice::as_set;
  Crossover crossover = Crossover::zero;
  NearestLevel nearest_level = NearestLevel::down_at_ties;
  LevelWeight level_weight = LevelWeight::exact;
  LevelLimits limits = LevelLimits::as_set;
  Anisotropy anisotropy = Anisotropy::extension;
  LevelCount level_count = LevelCount::larger_side;
  MipmapMethod mipmap;  // for generated chains

  friend bool operator==(const TextureChoice&, const TextureChoice&) = default;
};

// A policy's choices for invocations and samples of multisampled targets, and for passes.
struct SampleChoice {
  ShadingRate rate = ShadingRate::as_needed;
  AlphaToCoverage alpha_to_coverage = AlphaToCoverage::proportional;
  ResolveMethod resolve = ResolveMethod::nearest_even;
  Accumulation accumulation = Accumulation::exact_mean;  // for supersampled scenes
};

// A policy's choices for per-fragment operations: tests, blending, masks.
struct OutputChoice {
  DepthTestMethod depth = DepthTestMethod::as_set;
  DepthMaskMethod depth_mask = DepthMaskMethod::as_set;
  DepthBits depth_bits = DepthBits::as_set;
  StencilMethod stencil = StencilMethod::as_set;
  BlendChoice blend;
};

// All choices of a policy for one surface.
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

// Rules and alternatives that the policy names must exist in the catalogue.
RuleChoices resolve(const Policy& policy, Surface surface);

// The choices of OpenGL's own policy, which names none, on every surface.
const RuleChoices& standard_choices();

// A policy whose choices are looked up once for every surface, and then passed on.
class ResolvedPolicy {
 public:
  ResolvedPolicy(const Policy& policy = {});  // implicit: a policy is enough to draw

  const RuleChoices& on(Surface surface) const {
    return choices_[static_cast<std::size_t>(surface)];
  }
  Latitude latitude() const { return latitude_; }
  // True if the policy chooses nothing.
  bool is_standard() const { return is_standard_; }

 private:
  std::array<RuleChoices, values_of<Surface>().size()> choices_;
  Latitude latitude_;
  bool is_standard_;
};

// The rules by which ties of a kind of primitive are decided, and those of its snapping and rows.
RuleId coverage_rule_of(PrimitiveKind kind);
RuleId snap_rule_of(PrimitiveKind kind);
RuleId row_order_rule_of(PrimitiveKind kind);

// Changes: the alternatives of a rule besides the chosen one, to be tried one after another, alone
// and in pairs (rules/change_search.h).

// Another alternative of one rule.
struct Change {
  AlternativeId id;
  // For sample.positions, whose alternative `swapped` has a placement for each pair of samples.
  std::optional<SamplePlacement> placement = {};

  void apply(RuleChoices& choices) const;
  RuleChoices applied_to(RuleChoices choices) const {
    apply(choices);
    return choices;
  }
};
using Changes = std::vector<Change>;

// The cause of all changes together, without repetition.
Cause cause_of(const Changes& changes);
RuleChoices applied(const Changes& changes, RuleChoices choices);

// The alternatives of a rule, or of several one after another, except the chosen ones.
Changes changes_beside(RuleId rule, const RuleChoices& chosen);
Changes changes_beside(std::span<const RuleId> rules, const RuleChoices& chosen);
// The change from one choice of the rule to another; none if both are the same.
std::optional<Change> change_between(RuleId rule, const RuleChoices& from, const RuleChoices& to);

// The traits that decide which rules affect a primitive's coverage.
struct CoverageTraits {
  PrimitiveKind kind = PrimitiveKind::point;
  int samples = 1;  // of the target
  bool is_multisampled = false;
  bool is_switched_off = false;  // GL_MULTISAMPLE, on a target of several samples
  bool heeds_mask = false;
  bool is_wide = false;  // a line that is not 1 pixel wide
  bool is_clipped = false;
  bool leaves_sides = false;  // a vertex lies beyond the viewport's sides
  bool is_culled_by_facing = false;
  friend bool operator==(const CoverageTraits&, const CoverageTraits&) = default;
};
CoverageTraits coverage_traits(const ScenePrimitive& primitive, const Target& target);

// The alternatives of every rule that affects what the primitive covers, rule by rule.
std::vector<Changes> coverage_changes(const CoverageTraits& traits, const RuleChoices& chosen);
// The changes from one choice to another, one for each such rule in which they differ; also the
// ties of polygons, if the other choice draws lines as areas. No cause is searched for among those:
// with free ties, areas draw nearly anything.
Changes coverage_changes_between(const ScenePrimitive& primitive, const Target& target,
                                 const RuleChoices& from, const RuleChoices& to);

// The alternatives of every rule that affects a scene's per-fragment operations.
Changes operations_changes(const Scene& scene, const RuleChoices& chosen);

// The rules that affect lookups of textures, in the order of their ids.
const std::vector<RuleId>& lookup_rules();

// The rules that affect what primitives cover, in the order of their ids.
const std::vector<RuleId>& coverage_rules();

// One character per alternative of these rules, rule by rule, and a last one for window.origin: '1'
// if the set has it, else '0'; empty for an empty set. And the inverse.
std::string text_of_refuted(const AlternativeSet& refuted);
std::optional<AlternativeSet> parse_refuted(std::string_view text);

}  // namespace edgecase
