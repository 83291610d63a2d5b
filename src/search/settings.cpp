// SPDX-License-Identifier: MIT
#include "search/settings.h"

#include <memory>
#include <utility>

#include "casefile/scene/forms.h"
#include "casefile/scene/viewport.h"
#include "search/scene_size.h"

namespace edgecase {
namespace {

// Sets a value; returns whether it differed.
template <class T>
bool put(T& value, const T& standard) {
  if (value == standard) return false;
  value = standard;
  return true;
}

// Keeps only textures in use, renumbered, and requests their details only if any remain.
void drop_unused_textures(Scene& scene) {
  std::vector<std::shared_ptr<const Texture>> kept;
  std::vector<std::size_t> places(scene.textures.size(), scene.textures.size());
  for (Draw& draw : scene.draws) {
    if (!draw.texture) continue;
    std::size_t& place = places[draw.texture->texture];
    if (place == scene.textures.size()) {
      place = kept.size();
      kept.push_back(scene.textures[draw.texture->texture]);
    }
    draw.texture->texture = place;
  }
  scene.textures = std::move(kept);
  scene.details.texture = !scene.textures.empty();
}

bool reset_texture(Scene& scene, std::size_t d) {
  Draw& draw = scene.draws[d];
  if (!draw.texture) return false;
  draw.texture.reset();
  draw.interpolation = Interpolation::flat;
  for (Vertex& vertex : draw.vertices) vertex.texture_coordinates = {0, 0};
  drop_unused_textures(scene);
  return true;
}

bool reset_colors(Scene& scene, std::size_t d) {
  bool changed = false;
  for (Vertex& vertex : scene.draws[d].vertices)
    changed = put(vertex.color, Vertex().color) || changed;
  return changed;
}

bool reset_depths(Scene& scene, std::size_t d) {
  bool changed = false;
  for (Vertex& vertex : scene.draws[d].vertices)
    if (!vertex.clip) changed = put(vertex.z, Fixed()) || changed;
  return changed;
}

bool reset_w(Scene& scene, std::size_t d) {
  bool changed = false;
  for (Vertex& vertex : scene.draws[d].vertices)
    if (!vertex.clip) changed = put(vertex.w, 1.0F) || changed;
  return changed;
}

// Replaces clip coordinates by the nearest expressible window coordinates.
bool reset_clip(Scene& scene, std::size_t d) {
  bool changed = false;
  for (Vertex& vertex : scene.draws[d].vertices) {
    if (!vertex.clip) continue;
    vertex.clip.reset();
    vertex.w = 1;
    changed = true;
  }
  return changed;
}

bool reset_samples(Scene& scene, std::size_t) {
  if (scene.target.samples == 1) return false;
  scene.target.samples = 1;
  scene.target.sample_positions.clear();
  for (Draw& draw : scene.draws) draw.multisampling = {};
  return true;
}

// A test needs its buffer, and so does the buffer's clear value.
bool reset_depth_buffer(Scene& scene, std::size_t) {
  if (scene.target.depth == DepthFormat::none) return false;
  scene.target.depth = DepthFormat::none;
  scene.target.clear_depth = Target().clear_depth;
  for (Draw& draw : scene.draws) {
    draw.operations.depth = {};
    draw.polygon_offset.reset();
  }
  return true;
}

bool reset_stencil_buffer(Scene& scene, std::size_t) {
  if (scene.target.stencil == StencilFormat::none) return false;
  scene.target.stencil = StencilFormat::none;
  scene.target.clear_stencil = Target().clear_stencil;
  for (Draw& draw : scene.draws) draw.operations.stencil.reset();
  return true;
}

bool reset_viewport(Scene& scene, std::size_t) {
  const auto chosen = choose_viewport(scene.target, scene.draws, scene.supersampling);
  const Viewport& own = scene.viewport;
  if (!chosen || (chosen->x == own.x && chosen->y == own.y && chosen->width == own.width &&
                  chosen->height == own.height))
    return false;
  scene.viewport = *chosen;
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices)
      if (vertex.clip) place_clip_vertex(scene.viewport, vertex);
  return true;
}

bool reset_details(Scene& scene, std::size_t) {
  Details standard;
  standard.texture = scene.details.texture;
  return put(scene.details, standard);
}

bool reset_supersampling(Scene& scene, std::size_t) {
  const bool changed = !scene.supersampling.empty();
  scene.supersampling.clear();
  return changed;
}

template <auto Member>
bool reset_target(Scene& scene, std::size_t) {
  return put(scene.target.*Member, Target().*Member);
}

// Textured draws interpolate by default.
Draw default_draw(const Draw& draw) {
  Draw standard;
  if (draw.texture) standard.interpolation = Interpolation::smooth;
  return standard;
}

// Of each row with a form: state that a draw has for itself.
void add_rows_of_draws(std::vector<Setting>& settings) {
  for_each_form<Draw>([&](const auto& field, const auto& part) {
    settings.push_back({field.case_key,
                        [field, part](Scene& scene, std::size_t d) {
                          Draw& draw = scene.draws[d];
                          const Draw standard = default_draw(draw);
                          return put(part(draw).*field.member, part(standard).*field.member);
                        },
                        true});
  });
}

// Of each row of a part of draws; `part` is null where a draw has none.
template <HasFields Part, class Find>
void add_rows_of_part(std::vector<Setting>& settings, Find find) {
  for_each_field<Part>([&](const auto& field) {
    settings.push_back({field.case_key,
                        [field, find](Scene& scene, std::size_t d) {
                          Part* const part = find(scene.draws[d]);
                          return part != nullptr && put(part->*field.member, Part().*field.member);
                        },
                        true});
  });
}

// Settings that remove most come first.
std::vector<Setting> make_settings() {
  std::vector<Setting> settings{
      {"supersampling", reset_supersampling, false},
      {"samples", reset_samples, false},
      {"depth buffer", reset_depth_buffer, false},
      {"stencil buffer", reset_stencil_buffer, false},
      {"texture", reset_texture, true},
      {"clip coordinates", reset_clip, true},
      {"details", reset_details, false},
      {"viewport", reset_viewport, false},
      {"depth_range",
       [](Scene& scene, std::size_t) { return put(scene.depth_range, DepthRange()); }, false},
      {"sample_positions", reset_target<&Target::sample_positions>, false},
      {"clear", reset_target<&Target::clear>, false},
      {"clear_depth", reset_target<&Target::clear_depth>, false},
      {"clear_stencil", reset_target<&Target::clear_stencil>, false}};
  add_rows_of_draws(settings);
  add_rows_of_part<Sampler>(
      settings, [](Draw& draw) { return draw.texture ? &draw.texture->sampler : nullptr; });
  add_rows_of_part<Multisampling>(settings, [](Draw& draw) { return &draw.multisampling; });
  settings.insert(
      settings.end(),
      {{"w", reset_w, true}, {"z", reset_depths, true}, {"colours", reset_colors, true}});
  return settings;
}

const std::vector<Setting>& settings() {
  static const std::vector<Setting> kSettings = make_settings();
  return kSettings;
}

// Resets a setting everywhere; returns how often it was not at its default.
std::int64_t reset_everywhere(const Setting& setting, Scene& scene) {
  if (!setting.of_draws) return setting.reset(scene, 0) ? 1 : 0;
  std::int64_t count = 0;
  for (std::size_t d = 0; d < scene.draws.size(); ++d) count += setting.reset(scene, d) ? 1 : 0;
  return count;
}

// Smaller and rounder widths and sizes, smallest first.
void add_smaller_sizes(const Scene& scene, std::size_t d, Fixed Draw::*size,
                       std::vector<Scene>& simpler) {
  const Fixed own = scene.draws[d].*size;
  if (own == Fixed::from_integer(1)) return;
  for (const std::int64_t half_steps : {1, 3, 4, 6, 8}) {
    const Fixed smaller = Fixed::from_raw(half_steps * Fixed::kOne / 2);
    if (smaller == Fixed::from_integer(1) || smaller >= own) continue;
    simpler.push_back(scene);
    simpler.back().draws[d].*size = smaller;
  }
  if (fraction_bits_of(own) == 0) return;
  for (const std::int64_t whole : {own.floor(), own.ceil()}) {
    if (whole < 1) continue;
    simpler.push_back(scene);
    simpler.back().draws[d].*size = Fixed::from_integer(whole);
  }
}

// One colour for all vertices of one draw.
void add_one_color(const Scene& scene, std::size_t d, std::vector<Scene>& simpler) {
  Scene one = scene;
  for (Vertex& vertex : one.draws[d].vertices) vertex.color = one.draws[d].vertices[0].color;
  if (!same_scene(one, scene)) simpler.push_back(std::move(one));
}

void add_fewer_passes(const Scene& scene, std::vector<Scene>& simpler) {
  if (scene.supersampling.size() < 2) return;
  for (const ShadingPass& pass : scene.supersampling) {
    simpler.push_back(scene);
    simpler.back().supersampling = {{pass.at, 1}};
  }
}

}  // namespace

std::span<const Setting> all_settings() {
  return settings();
}

std::int64_t count_settings(const Scene& scene) {
  // In reverse, so that settings that depend on a buffer are counted before the buffer.
  Scene copy = scene;
  std::int64_t count = 0;
  for (auto setting = settings().rbegin(); setting != settings().rend(); ++setting)
    count += reset_everywhere(*setting, copy);
  return count;
}

std::vector<Scene> simpler_settings(const Scene& scene) {
  std::vector<Scene> simpler;
  Scene plain = scene;
  std::int64_t changes = 0;
  for (const Setting& setting : settings()) changes += reset_everywhere(setting, plain);
  if (changes > 0) simpler.push_back(std::move(plain));
  for (const Setting& setting : settings()) {
    Scene one = scene;
    if (reset_everywhere(setting, one) > 0) simpler.push_back(std::move(one));
  }
  for (const Setting& setting : settings()) {
    if (!setting.of_draws || scene.draws.size() < 2) continue;
    for (std::size_t d = 0; d < scene.draws.size(); ++d) {
      Scene one = scene;
      if (setting.reset(one, d)) simpler.push_back(std::move(one));
    }
  }
  add_fewer_passes(scene, simpler);
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    add_smaller_sizes(scene, d, &Draw::line_width, simpler);
    add_smaller_sizes(scene, d, &Draw::point_size, simpler);
    add_one_color(scene, d, simpler);
  }
  return simpler;
}

}  // namespace edgecase
