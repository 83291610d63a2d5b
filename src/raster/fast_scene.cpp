// SPDX-License-Identifier: MIT
#include "raster/framebuffer.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "raster/attributes.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/samples/sample_mask.h"
#include "rules/values/attributes.h"

namespace edgecase {

namespace {

constexpr float kLargestCoordinate = 1024;
constexpr double kWidestWeight = 0x1p-30;

bool is_power_of_two(int size) {
  return std::has_single_bit(static_cast<unsigned>(size));
}

// Whether coordinates and weights are continuous, and the wrap modes supported.
bool is_known(const TextureUse& use, const TextureChoice& choice) {
  const auto is_wrap_known = [](Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::clamp_to_edge;
  };
  return choice.texel_grid == TexelGrid::none && choice.limits == LevelLimits::as_set &&
         use.sampler.max_anisotropy == 1 &&
         std::all_of(use.sampler.wrap.begin(), use.sampler.wrap.end(), is_wrap_known);
}

bool are_near(const ScenePrimitive& triangle) {
  return std::all_of(triangle.vertices.begin(), triangle.vertices.end(), [](const Vertex* vertex) {
    return std::all_of(vertex->texture_coordinates.begin(), vertex->texture_coordinates.end(),
                       [](float value) { return std::abs(value) <= kLargestCoordinate; });
  });
}

// One word for each texel; nothing if a texel is not made of 8-bit codes.
std::optional<std::vector<PixelWord>> words_of(const TextureLevel& level) {
  std::vector<PixelWord> words;
  for (std::size_t i = 0; i < level.texels.size(); i += 4) {
    std::array<std::uint8_t, 4> codes{};
    for (std::size_t c = 0; c < 4; ++c) {
      const float texel = level.texels[i + c];
      if (!(texel >= 0 && texel <= 255 && texel == std::floor(texel))) return std::nullopt;
      codes[c] = static_cast<std::uint8_t>(texel);
    }
    words.push_back(std::bit_cast<PixelWord>(codes));
  }
  return words;
}

}  // namespace

FastTextures::FastTextures(const Scene& scene, const RuleChoices& choices)
    : scene_(scene), choices_(choices), stage_(scene, choices) {}

const TexelPlane* FastTextures::plane_of(std::size_t texture, int level) {
  const auto [entry, is_new] = planes_.try_emplace({texture, level});
  if (is_new) {
    const auto chain = stage_.chains().find(texture);
    const std::vector<TextureLevel>& levels =
        chain == stage_.chains().end() ? scene_.textures[texture]->levels : chain->second;
    const TextureLevel& image = levels.at(static_cast<std::size_t>(level));
    auto words = words_of(image);
    if (words && is_power_of_two(image.width) && is_power_of_two(image.height)) {
      words_.push_back(std::move(*words));
      entry->second = TexelPlane{words_.back().data(), image.width, image.height};
    }
  }
  return entry->second ? &*entry->second : nullptr;
}

std::optional<TexturedTriangle> FastTextures::looked_up(const ScenePrimitive& triangle) {
  const TextureUse& use = *triangle.state->texture;
  const TextureChoice& choice = choices_.textures;
  const Texture& texture = *scene_.textures[use.texture];
  if (!is_known(use, choice) || !are_near(triangle)) return std::nullopt;
  if (texture.format != TextureFormat::rgba8 || texture.dimensions != 2) return std::nullopt;

  // All pixels have the same level, so any will do.
  const PrimitiveAttributes attributes = attributes_of(triangle, choices_, scene_.target);
  const Interval lambda = stage_.look_up(triangle, attributes, {0, 0}).lambda;
  const LevelRules rules{choice.crossover, choice.nearest_level, choice.level_weight, false, 0};
  const int last = last_level_of(stage_.decoded(use.texture), use.sampler, texture);
  const LevelPicks picks = pick_levels(lambda, use.sampler, last, rules);
  if (picks.size() != 1 || picks[0].filter != Filter::linear) return std::nullopt;
  const LevelPick& pick = picks[0];
  const TexelPlane* const first = plane_of(use.texture, std::min(pick.level, last));
  const TexelPlane* const second = plane_of(use.texture, std::min(pick.next, last));
  if (!first || !second) return std::nullopt;

  TexturedTriangle result;
  result.levels = {*first, *second};
  if (pick.next != pick.level) {
    if (!(pick.weight.high - pick.weight.low < kWidestWeight)) return std::nullopt;
    result.weight = pick.weight.low;
    result.weight_margin = pick.weight.high - pick.weight.low;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [s, t] = triangle.vertices[i]->texture_coordinates;
    result.coordinates[i] = {s, t, 0, 0};
  }
  for (std::size_t c = 0; c < 2; ++c) result.repeats[c] = use.sampler.wrap[c] == Wrap::repeat;
  return result;
}

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

  // The code of a flat colour, which is the provoking vertex's for every fragment.
  PixelWord color_of(const ScenePrimitive& primitive) const {
    const Vertex& vertex =
        *primitive.vertices[provoking_index(primitive, choices_.values.provoking)];
    std::array<std::uint8_t, 4> codes{};
    std::transform(vertex.color.begin(), vertex.color.end(), codes.begin(),
                   [](float value) { return to_unorm8(static_cast<double>(value)); });
    return std::bit_cast<PixelWord>(codes);
  }

  // Returns the kind as which the primitive was added.
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

  // Sets the vertices' positions for coverage and for attributes.
  template <class Interpolated>
  void place(const ScenePrimitive& primitive, Interpolated& triangle) const {
    const Snap& snap = choices_.of(primitive.kind).snap;
    const bool snapped = choices_.values.positions == AttributePositions::snapped;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.vertices[i] = raw_vertex(*primitive.vertices[i], snap);
      triangle.corners[i] = raw_vertex(*primitive.vertices[i], snapped ? snap : Snap());
    }
  }

  // The batch of the primitive that was just added.
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
  const Draw* state_ = nullptr;  // of the latest batch
  FastScene made_;
};

}  // namespace

std::optional<FastScene> fast_scene(const Scene& scene, const RuleChoices& choices) {
  return FastSceneMaker(scene, choices).make();
}

}  // namespace edgecase
