// SPDX-License-Identifier: MIT
#include "tests/diff/textures/texture_judging.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

#include "diff/compare.h"
#include "diff/judge.h"
#include "diff/values/value_diff.h"
#include "raster/rasterizer.h"
#include "tests/diff/values/value_mutants.h"
#include "tests/raster/random_scenes.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

constexpr TextureFormat kFloats = TextureFormat::rgba32f;
constexpr TextureFormat kCodes = TextureFormat::rgba8;

Texture random_chain(int width, int height, TextureFormat format) {
  RandomNumbers numbers(42);
  return chain_of(width, height, format, random_texels(numbers, format));
}

// Stripes of two rows, each with a level of its own that the shader asks for.
Scene striped_scene(const std::vector<float>& levels, const Sampler& sampler) {
  Scene scene = blank_scene(16, 2 * static_cast<int>(levels.size()));
  scene.details.texture = true;
  const Texture texture = random_chain(32, 32, kFloats);
  scene.textures = {std::make_shared<const Texture>(texture)};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Placement place{{0, static_cast<double>(2 * i)}, {16, 2}, {0.01f, 0.02f}, {1.25f, 0.75f}};
    Draw draw = textured_scene(16, 2, texture, place, sampler).draws[0];
    draw.texture->lookup = {LookupKind::lod, levels[i], {}, {}};
    scene.draws.push_back(draw);
  }
  return scene;
}

// Four by four pixels, so that what a formula may err is far less than what the bias is rounded by.
Scene odd_bias_scene() {
  Sampler sampler = sampler_of(Filter::linear, MipFilter::linear);
  sampler.lod_bias = 0.3066f;
  const Placement place{{0, 0}, {4, 4}, {0, 0}, {0.3625f, 0.25f}};
  return textured_scene(4, 4, random_chain(32, 32, kFloats), place, sampler);
}

// So far magnified that a bias beyond OpenGL's largest leads to the middle of the chain.
Scene far_biased_scene() {
  Sampler sampler = sampler_of(Filter::nearest, MipFilter::nearest);
  sampler.lod_bias = 10;
  const Placement place{{0, 0}, {16, 16}, {0, 0}, {0x1p-15f, 0x1p-15f}};
  Scene scene = textured_scene(16, 16, random_chain(32, 32, kFloats), place, sampler);
  scene.draws[0].texture->lookup = {LookupKind::bias, 9, {}, {}};
  return scene;
}

// Odd steps of 1/256 texel from pixel to pixel, from half a step on: ties of grids of 8 bits.
Scene grid_tie_scene(TextureFormat format) {
  constexpr double kTexels = 17.0 / 256;
  return flat_scene(kTexels, format, sampler_of(Filter::linear, MipFilter::none));
}

// Its upper half is not filtered, and lies just below borders of texels.
Scene half_linear_scene() {
  Scene scene = grid_tie_scene(kCodes);
  constexpr float kStart = (8.5f - 0x1p-10f) / 32;
  const Placement place{{0, 8}, {16, 8}, {kStart, kStart}, {kStart + 0.5f, kStart + 0.25f}};
  scene.draws.push_back(textured_scene(16, 16, *scene.textures[0], place,
                                       sampler_of(Filter::nearest, MipFilter::none))
                            .draws[0]);
  for (std::size_t v : {2u, 3u}) {
    Vertex& upper = scene.draws[0].vertices[v];
    upper.position.y = Fixed::from_integer(8);
    upper.texture_coordinates[1] = (upper.texture_coordinates[1] + 0.5f) / 2;
  }
  return scene;
}

// Six by six pixels, in which derivatives change much from each to the next.
Scene steep_scene(std::array<float, 4> w) {
  const Placement place{{0, 0}, {6, 6}, {0, 0}, {0.5f, 0.625f}};
  Scene scene = textured_scene(6, 6, random_chain(64, 64, kFloats), place,
                               sampler_of(Filter::linear, MipFilter::linear));
  for (std::size_t v = 0; v < 4; ++v) scene.draws[0].vertices[v].w = w[v];
  return scene;
}

Scene with_bias_of(Scene scene, float bias) {
  scene.draws[0].texture->sampler.lod_bias = bias;
  return scene;
}

Scene anisotropic_scene() {
  Sampler sampler = sampler_of(Filter::linear, MipFilter::linear);
  sampler.max_anisotropy = 8;
  const Placement place{{0, 0}, {16, 16}, {0, 0}, {3.3f, 0.55f}};
  return textured_scene(16, 16, random_chain(32, 32, kFloats), place, sampler);
}

// Of which little is left open: one of the partial derivatives is far larger than all others.
Scene narrow_scene() {
  const Placement place{{0, 0}, {16, 16}, {0, 0}, {0.075f, 2.6f}};
  return textured_scene(16, 16, random_chain(32, 32, kFloats), place,
                        sampler_of(Filter::linear, MipFilter::linear));
}

// Both ways across the window lead almost the same way across the texture.
Scene parallel_scene() {
  const Placement place{{0, 0}, {16, 16}, {0, 0}, {1, 1}};
  Scene scene = textured_scene(16, 16, random_chain(32, 32, kFloats), place,
                               sampler_of(Filter::linear, MipFilter::linear));
  for (Vertex& vertex : scene.draws[0].vertices) {
    const auto [s, t] = vertex.texture_coordinates;
    vertex.texture_coordinates = {1.375f * s + 1.125f * t, 0.0625f * s - 0.03125f * t};
  }
  return scene;
}

Scene mirrored_scene(Filter filter) {
  return flat_scene(3.3, kFloats, sampler_of(filter, MipFilter::none, Wrap::mirrored_repeat));
}

Sampler disputed_crossover(MipFilter mipmap) {
  Sampler sampler = sampler_of(Filter::nearest, mipmap);
  sampler.magnify = Filter::linear;
  return sampler;
}

// max_lod counts from the base level, and max_level does not.
Scene limited_scene(int base_level, int max_level, float max_lod) {
  Sampler sampler = sampler_of(Filter::nearest, MipFilter::nearest);
  sampler.magnify = Filter::linear;
  sampler.base_level = base_level;
  sampler.max_level = max_level;
  sampler.max_lod = max_lod;
  return flat_scene(20, kFloats, sampler);
}

std::vector<TexturedScene> all_scenes() {
  const Sampler between = sampler_of(Filter::linear, MipFilter::linear);
  const Sampler nearest_level = sampler_of(Filter::nearest, MipFilter::nearest);
  return {
      {"floor", floor_scene(between)},
      {"floor of nearest levels", floor_scene(nearest_level)},
      {"rotated", rotated_scene(between)},
      {"parallel", parallel_scene()},
      {"narrow", narrow_scene()},
      {"steep", steep_scene({1, 2, 8, 3})},
      {"steep to the left", steep_scene({5, 1, 2, 1.5f})},
      {"steep upwards", steep_scene({1, 1.25f, 5, 7})},
      {"gradients", floor_scene(with_bias_of(floor_scene(between), 1).draws[0].texture->sampler,
                                {LookupKind::gradients, 0, {0.1f, 0.02f}, {-0.03f, 0.09f}})},
      {"ties of levels", striped_scene({0.5f, 1.5f, 2.5f, 3.5f}, nearest_level)},
      {"ties between levels", striped_scene({0.25f, 0.5f, 1.5f, 2.375f}, between)},
      {"crossover",
       striped_scene({-0.25f, 0.25f, 0.5f, 0.75f}, disputed_crossover(MipFilter::nearest))},
      {"crossover between levels",
       striped_scene({0.125f, 0.25f, 0.75f}, disputed_crossover(MipFilter::linear))},
      {"magnified floats", grid_tie_scene(kFloats)},
      {"magnified codes", half_linear_scene()},
      {"off the grid", flat_scene(0.0631, kFloats, sampler_of(Filter::linear, MipFilter::none))},
      {"odd bias", odd_bias_scene()},
      {"far bias", far_biased_scene()},
      {"mirrored", mirrored_scene(Filter::nearest)},
      {"mirrored linear", mirrored_scene(Filter::linear)},
      {"anisotropic", anisotropic_scene()},
      {"level 0 alone", limited_scene(0, 0, 1000)},
      {"levels up to 2", limited_scene(0, 2, 1000)},
      {"levels 1 to 3", limited_scene(1, 3, 1000)},
      {"levels of detail up to 2", limited_scene(1, 1000, 2)},
      {"generated codes", generated_scene(13, 6, kCodes)},
      {"generated even codes", generated_scene(16, 8, kCodes)},
      {"generated sRGB", generated_scene(7, 9, TextureFormat::srgb8)},
      {"generated floats", generated_scene(5, 4, kFloats)},
      {"generated square", generated_scene(8, 8, kCodes)},
  };
}

FragmentDetail& detail_of(Rendering& rendering, const Fragment& fragment) {
  return rendering.details.at(static_cast<std::size_t>(fragment.detail));
}

void round_numbers(std::span<double> numbers) {
  for (double& number : numbers) number = to_float(number);
}

}  // namespace

const std::vector<TexturedScene>& judged_textures() {
  static const std::vector<TexturedScene> scenes = all_scenes();
  return scenes;
}

const Scene& textures_named(const std::string& name) {
  for (const TexturedScene& one : judged_textures())
    if (one.name == name) return one.scene;
  throw std::invalid_argument("no scene is named " + name);
}

Scene floor_scene(const Sampler& sampler, const Lookup& lookup) {
  const Placement place{{0.5, 0.25}, {23, 23.25}, {0.01f, 0.03f}, {2.6f, 3.7f}};
  Scene scene = textured_scene(24, 24, random_chain(32, 16, kFloats), place, sampler);
  const float w[] = {1, 1.5f, 3.5f, 6};
  for (std::size_t v = 0; v < 4; ++v) scene.draws[0].vertices[v].w = w[v];
  scene.draws[0].texture->lookup = lookup;
  return scene;
}

Scene flat_scene(double texels_per_pixel, TextureFormat format, const Sampler& sampler,
                 const Lookup& lookup) {
  const auto span = static_cast<float>(texels_per_pixel * 16 / 32);
  const Placement place{{0, 0}, {16, 16}, {0.25f, 0.5f}, {0.25f + span, 0.5f + span}};
  Scene scene = textured_scene(16, 16, random_chain(32, 32, format), place, sampler);
  scene.draws[0].texture->lookup = lookup;
  return scene;
}

Scene rotated_scene(const Sampler& sampler) {
  const Placement place{{0, 0}, {16, 16}, {0, 0}, {1, 1}};
  Scene scene = textured_scene(16, 16, random_chain(64, 32, kFloats), place, sampler);
  for (Vertex& vertex : scene.draws[0].vertices) {
    const auto [s, t] = vertex.texture_coordinates;
    vertex.texture_coordinates = {s * 0.6875f - t * 0.3125f, s * 0.5f + t * 1.4375f};
  }
  return scene;
}

Scene generated_scene(int width, int height, TextureFormat format) {
  RandomNumbers numbers(7);
  Texture texture = single_of(width, height, format, random_texels(numbers, format));
  texture.generated = true;
  const Placement place{{0, 0}, {16, 16}, {0.1f, 0.2f}, {3.3f, 2.9f}};
  return textured_scene(16, 16, texture, place, sampler_of(Filter::linear, MipFilter::linear));
}

Policy policy_from(const std::vector<std::string>& choices) {
  Policy policy;
  for (const std::string& choice : choices) {
    const std::size_t equals = choice.find('=');
    policy.rules[choice.substr(0, equals)] = choice.substr(equals + 1);
  }
  return policy;
}

Result judge_textures(const Scene& scene, const Rendering& rendered, const Policy& policy,
                      const Policy* profile) {
  return judged(scene, rendered, policy, 8, profile);
}

Result judge_follower(const Scene& scene, const std::vector<std::string>& choices,
                      const Policy* profile) {
  return judge_textures(scene, rasterize(scene, policy_from(choices)), {}, profile);
}

std::string describe_textures(const Result& result) {
  std::string text = name_of(result.verdict);
  std::set<std::string> seen;
  for (const Disagreement& d : result.disagreements)
    if (seen.insert(name_of(d.rule) + text_of(d.cause)).second)
      text += std::string("\n") + name_of(d.rule) + (is_legal(d) ? " legal '" : " illegal '") +
              text_of(d.cause) + "' " + std::to_string(d.x) + "," + std::to_string(d.y) + ": " +
              d.explanation;
  for (const ValueAggregate& values : result.values)
    text += "\n" + values.attribute + " differs at " + std::to_string(values.differing.size()) +
            " '" + text_of(values.cause) + "'";
  return text;
}

Rendering changed_textures(const Scene& scene, const TextureChange& change) {
  Rendering rendering = rasterize(scene, {});
  for (Fragment& fragment : rendering.fragments) change(fragment, detail_of(rendering, fragment));
  return stored(scene, std::move(rendering));
}

Rendering changed_texture(const Scene& scene, std::size_t number, const TextureChange& change) {
  Rendering rendering = rasterize(scene, {});
  Fragment& fragment = rendering.fragments.at(number);
  change(fragment, detail_of(rendering, fragment));
  return stored(scene, std::move(rendering));
}

Rendering in_float32(const Scene& scene, Rendering rendering) {
  for (Fragment& fragment : rendering.fragments) {
    fragment.depth = to_float(fragment.depth);
    round_numbers(fragment.color);
    FragmentDetail& detail = detail_of(rendering, fragment);
    if (detail.texture_coordinates) round_numbers(*detail.texture_coordinates);
    if (detail.level_of_detail) round_numbers(*detail.level_of_detail);
  }
  return stored(scene, std::move(rendering));
}

TextureChange level_moved(double by) {
  return [by](Fragment&, FragmentDetail& detail) {
    for (double& level : detail.level_of_detail.value()) level += by;
  };
}

}  // namespace edgecase
