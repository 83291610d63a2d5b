// SPDX-License-Identifier: MIT
#include "raster/fast_scene.h"

#include <algorithm>
#include <bit>

#include "raster/fast_coverage.h"
#include "raster/rasterizer.h"
#include "raster/vertex_attributes.h"
#include "rules/samples/sample_mask.h"
#include "rules/values/flat_attribute.h"
#include "rules/values/smooth_attribute.h"

namespace edgecase {
namespace {

using Kind = FastBatch::Kind;

bool has_equal_w(const ScenePrimitive& primitive) {
  const auto& v = primitive.vertices;
  return v[0]->w == v[1]->w && v[0]->w == v[2]->w;
}

RawPoint raw_vertex(const Vertex& vertex, const Snap& snap) {
  return raw_point(snap(vertex.position));
}

bool has_area(const std::array<RawPoint, 3>& corners) {
  return TriangleSetup(corners[0], corners[1], corners[2], TieWeights()).has_area();
}

class FastSceneMaker {
 public:
  FastSceneMaker(const Scene& scene, const RuleChoices& choices)
      : scene_(scene), choices_(choices) {}

  std::optional<FastScene> make() {
    if (!is_simple()) return std::nullopt;
    if (!scene_.textures.empty()) made_.textures = std::make_unique<FastTextures>(scene_, choices_);
    for (const ScenePrimitive& primitive : primitives_of(scene_)) {
      const Kind kind = add(primitive);
      if (scene_.target.samples > 1 && !takes_samples(primitive, kind)) return std::nullopt;
      ++batch_for(primitive, kind).count;
    }
    return std::move(made_);
  }

 private:
  bool is_simple() const {
    const bool tests_depth = scene_.target.depth != DepthFormat::none &&
                             choices_.output.depth != DepthTestMethod::as_set;
    return scene_.supersampling.empty() && !has_fragment_operations(scene_) && !tests_depth;
  }

  bool takes_samples(const ScenePrimitive& primitive, Kind kind) const {
    return kind == Kind::flat_triangles && !primitive.state->multisampling.alpha_to_coverage &&
           sampling_of(primitive, scene_.target, choices_.triangles) == Unsampled::by_each_sample;
  }

  Kind kind_for(const ScenePrimitive& primitive) const {
    const Draw& draw = *primitive.state;
    if (!is_walked(primitive, choices_.of(primitive.kind)) || draw.cull != CullMode::none)
      return Kind::plain;
    const bool is_flat = draw.interpolation == Interpolation::flat;
    if (primitive.kind == PrimitiveKind::line)
      return is_flat && !draw.texture ? Kind::flat_lines : Kind::plain;
    const bool divides = divides_by_w(draw.interpolation, choices_.values.perspective);
    if (draw.texture)
      return is_flat || (divides && !has_equal_w(primitive)) ? Kind::plain
                                                             : Kind::textured_triangles;
    if (is_flat) return Kind::flat_triangles;
    return divides && !has_equal_w(primitive) ? Kind::plain : Kind::smooth_triangles;
  }

  // The code of a flat colour: that of the provoking vertex, wherever the fragment lies.
  PixelWord color_of(const ScenePrimitive& primitive) const {
    const Vertex& vertex =
        *primitive.vertices[provoking_index(primitive, choices_.values.provoking)];
    std::array<std::uint8_t, 4> codes{};
    std::transform(vertex.color.begin(), vertex.color.end(), codes.begin(),
                   [](float value) { return to_unorm8(static_cast<double>(value)); });
    return std::bit_cast<PixelWord>(codes);
  }

  // Tells as what it was added.
  Kind add(const ScenePrimitive& primitive) {
    const auto& v = primitive.vertices;
    const Snap& snap = choices_.of(primitive.kind).snap;
    const Kind kind = kind_for(primitive);
    switch (kind) {
      case Kind::flat_triangles:
        made_.flat_triangles.push_back(
            {{raw_vertex(*v[0], snap), raw_vertex(*v[1], snap), raw_vertex(*v[2], snap)},
             color_of(primitive)});
        return kind;
      case Kind::flat_lines:
        made_.flat_lines.push_back(
            {raw_vertex(*v[0], snap), raw_vertex(*v[1], snap), color_of(primitive)});
        return kind;
      case Kind::smooth_triangles: {
        SmoothTriangle triangle;
        place(primitive, triangle);
        for (std::size_t i = 0; i < 3; ++i) triangle.colors[i] = v[i]->color;
        if (!has_area(triangle.corners)) break;
        made_.smooth_triangles.push_back(triangle);
        made_.smooth_primitives.push_back(primitive);
        return kind;
      }
      case Kind::textured_triangles: {
        std::optional<TexturedTriangle> triangle = made_.textures->looked_up(primitive);
        if (!triangle) break;
        place(primitive, *triangle);
        if (!has_area(triangle->corners)) break;
        made_.textured_triangles.push_back(*triangle);
        made_.textured_primitives.push_back(primitive);
        return kind;
      }
      case Kind::plain:
        break;
    }
    made_.plain_primitives.push_back(primitive);
    return Kind::plain;
  }

  // Where coverage has the vertices, and where attributes have them.
  template <class Interpolated>
  void place(const ScenePrimitive& primitive, Interpolated& triangle) const {
    const Snap& snap = choices_.of(primitive.kind).snap;
    const bool snapped = choices_.values.positions == AttributePositions::snapped;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.vertices[i] = raw_vertex(*primitive.vertices[i], snap);
      triangle.corners[i] = raw_vertex(*primitive.vertices[i], snapped ? snap : Snap());
    }
  }

  // The batch that the primitive just added belongs to.
  FastBatch& batch_for(const ScenePrimitive& primitive, Kind kind) {
    if (primitive.state != state_ || made_.batches.back().kind != kind) {
      state_ = primitive.state;
      const std::size_t sizes[] = {made_.flat_triangles.size(), made_.flat_lines.size(),
                                   made_.smooth_triangles.size(), made_.textured_triangles.size(),
                                   made_.plain_primitives.size()};
      made_.batches.push_back({kind, sizes[static_cast<std::size_t>(kind)] - 1, 0,
                               drawable_bounds(*state_, scene_.target),
                               writable_samples(state_->multisampling, scene_.target.samples,
                                                choices_.of(primitive.kind).sample_mask)});
    }
    return made_.batches.back();
  }

  const Scene& scene_;
  const RuleChoices& choices_;
  const Draw* state_ = nullptr;  // of the last batch
  FastScene made_;
};

}  // namespace

std::optional<FastScene> fast_scene(const Scene& scene, const RuleChoices& choices) {
  return FastSceneMaker(scene, choices).make();
}

}  // namespace edgecase
