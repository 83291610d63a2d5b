// SPDX-License-Identifier: MIT
#include "casefile/case_writer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "casefile/fragment_operations_writer.h"
#include "casefile/json_layout.h"
#include "casefile/loader.h"
#include "casefile/number_pieces.h"
#include "casefile/text.h"
#include "casefile/texture_writer.h"
#include "casefile/viewport.h"
#include "casefile/word_pieces.h"
#include "exact/numeral.h"
#include "model/scene_words.h"

namespace edgecase {
namespace {

// A decimal where it is short; a fraction says what 10.01171875 hides.
JsonPiece coordinate(Fixed value) {
  constexpr std::int64_t kReadable = Fixed::kOne / 16;
  if (value.raw() % kReadable == 0) return json_scalar(to_decimal(value));
  return json_string(to_fraction(value));
}

JsonPiece rectangle(const Viewport& value) {
  return json_object({named("x", integer_piece(value.x)), named("y", integer_piece(value.y)),
                      named("width", integer_piece(value.width)),
                      named("height", integer_piece(value.height))});
}

bool chosen_by_loader(const Scene& scene) {
  const std::optional<Viewport> chosen =
      choose_viewport(scene.target, scene.draws, scene.supersampling);
  const Viewport& own = scene.viewport;
  return chosen && chosen->x == own.x && chosen->y == own.y && chosen->width == own.width &&
         chosen->height == own.height;
}

JsonPiece positions_piece(const SamplePositions& positions) {
  Pieces items;
  for (const Point within : positions)
    items.push_back(json_array({coordinate(within.x), coordinate(within.y)}));
  return json_array(std::move(items));
}

// The passes one by one, whichever pattern and kernel they came from.
JsonPiece passes_piece(const Supersampling& passes) {
  Pieces samples;
  Pieces weights;
  for (const ShadingPass& pass : passes) {
    samples.push_back(json_array({coordinate(pass.at.x), coordinate(pass.at.y)}));
    weights.push_back(json_scalar(std::to_string(pass.weight)));
  }
  Pieces members{named("samples", json_array(std::move(samples)))};
  const auto counts_one = [](const ShadingPass& pass) { return pass.weight == 1; };
  if (!std::ranges::all_of(passes, counts_one))
    members.push_back(named("weights", json_array(std::move(weights))));
  return json_object(std::move(members));
}

JsonPiece target_piece(const Scene& scene) {
  const Target& target = scene.target;
  Pieces members{named("width", integer_piece(target.width)),
                 named("height", integer_piece(target.height))};
  const Target standard;
  if (target.samples != standard.samples)
    members.push_back(named("samples", integer_piece(target.samples)));
  if (!target.sample_positions.empty())
    members.push_back(named("sample_positions", positions_piece(target.sample_positions)));
  if (!scene.supersampling.empty())
    members.push_back(named("supersample", passes_piece(scene.supersampling)));
  if (target.color != standard.color)
    members.push_back(named("color", json_string(name_of(target.color))));
  if (target.depth != standard.depth)
    members.push_back(named("depth", json_string(name_of(target.depth))));
  for (JsonPiece& member : target_operation_pieces(scene)) members.push_back(std::move(member));
  if (target.surface != standard.surface)
    members.push_back(named("surface", json_string(name_of(target.surface))));
  members.push_back(named("clear", color_piece(target.clear)));
  if (!chosen_by_loader(scene)) members.push_back(named("viewport", rectangle(scene.viewport)));
  return json_object(std::move(members));
}

JsonPiece position(const Vertex& vertex) {
  Pieces coordinates{coordinate(vertex.position.x), coordinate(vertex.position.y)};
  if (vertex.z != Fixed() || vertex.w != 1) coordinates.push_back(coordinate(vertex.z));
  if (vertex.w != 1) coordinates.push_back(exact_piece(vertex.w));
  return json_array(std::move(coordinates));
}

JsonPiece clip_piece(const ClipPosition& clip) {
  return exact_list(std::array{clip.x, clip.y, clip.z, clip.w});
}

// What a draw's vertices are given beside their places.
struct VertexParts {
  bool color = false;
  int texture_coordinates = 0;  // 1 or 2 where the draw is textured
};

JsonPiece vertex_piece(const Vertex& vertex, VertexParts parts) {
  if (!parts.color && parts.texture_coordinates == 0 && !vertex.clip) return position(vertex);
  Pieces members;
  members.push_back(vertex.clip ? named("clip", clip_piece(*vertex.clip))
                                : named("at", position(vertex)));
  if (parts.color) members.push_back(named("color", color_piece(vertex.color)));
  if (parts.texture_coordinates > 0)
    members.push_back(named("uv", uv_piece(vertex.texture_coordinates, parts.texture_coordinates)));
  return json_object(std::move(members));
}

// Of the texture that a draw looks up; 0: it looks up none.
int dimensions_of(const Draw& draw, const Scene& scene) {
  return draw.texture ? scene.textures[draw.texture->texture]->dimensions : 0;
}

JsonPiece flag_piece(bool value) {
  return json_scalar(value ? "true" : "false");
}

void add_multisampling(const Multisampling& own, Pieces& members) {
  const Multisampling standard;
  if (own.enabled != standard.enabled)
    members.push_back(named("multisample", flag_piece(own.enabled)));
  if (own.location != standard.location)
    members.push_back(named("attribute_location", json_string(name_of(own.location))));
  if (own.min_sample_shading)
    members.push_back(named("min_sample_shading", exact_piece(*own.min_sample_shading)));
  if (own.mask != standard.mask)
    members.push_back(named("sample_mask", json_scalar(std::to_string(own.mask))));
  if (own.alpha_to_coverage != standard.alpha_to_coverage)
    members.push_back(named("alpha_to_coverage", flag_piece(own.alpha_to_coverage)));
}

std::optional<JsonPiece> state_piece(const Draw& draw, int dimensions) {
  const Draw standard;
  Pieces members;
  if (draw.interpolation != (draw.texture ? Interpolation::smooth : standard.interpolation))
    members.push_back(named("interpolation", json_string(name_of(draw.interpolation))));
  if (draw.provoking_vertex != standard.provoking_vertex)
    members.push_back(named("provoking_vertex", json_string(name_of(draw.provoking_vertex))));
  if (draw.line_width != standard.line_width)
    members.push_back(named("line_width", coordinate(draw.line_width)));
  if (draw.point_size != standard.point_size)
    members.push_back(named("point_size", coordinate(draw.point_size)));
  if (draw.scissor) members.push_back(named("scissor", rectangle(*draw.scissor)));
  add_multisampling(draw.multisampling, members);
  for (JsonPiece& member : fragment_operation_pieces(draw)) members.push_back(std::move(member));
  if (draw.texture)
    for (JsonPiece& member : texture_use_pieces(*draw.texture, dimensions))
      members.push_back(std::move(member));
  if (members.empty()) return std::nullopt;
  return json_object(std::move(members));
}

JsonPiece draw_piece(const Draw& draw, const Scene& scene) {
  const int dimensions = dimensions_of(draw, scene);
  const bool textured = dimensions > 0;
  const bool one_color = std::ranges::all_of(draw.vertices, [&](const Vertex& vertex) {
    return vertex.color == draw.vertices.front().color;
  });
  Pieces vertices;
  for (const Vertex& vertex : draw.vertices)
    vertices.push_back(vertex_piece(vertex, {!one_color && !textured, dimensions}));
  JsonPiece list = json_array(std::move(vertices));
  if (one_color && !textured)
    list.together = static_cast<std::size_t>(vertices_of(kind_of(draw.primitive)));
  Pieces members{named("primitive", json_string(name_of(draw.primitive))),
                 named("vertices", std::move(list))};
  if (one_color && !textured && !draw.vertices.empty())
    members.push_back(named("color", color_piece(draw.vertices.front().color)));
  if (auto state = state_piece(draw, dimensions))
    members.push_back(named("state", std::move(*state)));
  return json_object(std::move(members));
}

JsonPiece details_piece(Details details) {
  Pieces items;
  if (details.coordinates) items.push_back(json_string("coordinates"));
  if (details.derivatives) items.push_back(json_string("derivatives"));
  return json_array(std::move(items));
}

JsonPiece textures_piece(const Scene& scene) {
  Pieces items;
  for (const auto& texture : scene.textures) items.push_back(texture_piece(*texture));
  return json_array(std::move(items));
}

JsonPiece case_piece(const Scene& scene, const CaseWords& words) {
  Pieces members = word_pieces(words);
  members.push_back(named("target", target_piece(scene)));
  if (scene.details.coordinates || scene.details.derivatives)
    members.push_back(named("details", details_piece(scene.details)));
  if (!scene.textures.empty()) members.push_back(named("textures", textures_piece(scene)));
  Pieces draws;
  for (const Draw& draw : scene.draws) draws.push_back(draw_piece(draw, scene));
  JsonPiece list = json_array(std::move(draws));
  list.broken = true;
  members.push_back(named("draws", std::move(list)));
  JsonPiece piece = json_object(std::move(members));
  piece.broken = true;
  return piece;
}

// JSON holds well-formed UTF-8 alone, and the printer throws on anything else.
std::optional<Diagnostic> find_malformed(const CaseWords& words) {
  std::vector<std::pair<const char*, const std::string*>> all{{"/$schema", &words.schema},
                                                              {"/title", &words.title},
                                                              {"/why", &words.why},
                                                              {"/spec", &words.spec},
                                                              {"/origin", &words.origin}};
  for (const std::string& rule : words.rules) all.emplace_back("/rules", &rule);
  for (const std::string& tag : words.tags) all.emplace_back("/tags", &tag);
  for (const auto& [pointer, text] : all)
    if (find_invalid_utf8(*text))
      return Diagnostic{"", 0, pointer, "the text is not well-formed UTF-8", "write UTF-8"};
  return std::nullopt;
}

}  // namespace

CaseText case_text(const Scene& scene, const CaseWords& words) {
  CaseText result;
  if (auto malformed = find_malformed(words)) {
    result.diagnostics.push_back(std::move(*malformed));
    return result;
  }
  std::string text = lay_out(case_piece(scene, words));
  // The loader decides what a case file can say. Its id matters only for colours left open.
  LoadedCases read = load_cases_text(text, "", "written");
  result.diagnostics = std::move(read.diagnostics);
  if (!result.diagnostics.empty()) return result;
  if (read.cases.size() != 1 || !same_scene(read.cases.front().scene, scene))
    result.diagnostics.push_back({"", 0, "", "a case file cannot say this scene exactly",
                                  "this is a fault of the writer; report the scene"});
  else
    result.text = std::move(text);
  return result;
}

}  // namespace edgecase
