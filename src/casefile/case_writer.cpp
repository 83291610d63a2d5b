// SPDX-License-Identifier: MIT
#include "casefile/case_writer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "casefile/json/json_layout.h"
#include "casefile/json/text.h"
#include "casefile/loader.h"
#include "casefile/scene/forms.h"
#include "casefile/scene/textures.h"
#include "casefile/scene/viewport.h"
#include "model/scene.h"

namespace edgecase {

namespace {

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
    items.push_back(json_array({plain_piece(within.x), plain_piece(within.y)}));
  return json_array(std::move(items));
}

// The passes one by one, whatever pattern and kernel made them.
JsonPiece passes_piece(const Supersampling& passes) {
  Pieces samples;
  Pieces weights;
  for (const ShadingPass& pass : passes) {
    samples.push_back(json_array({plain_piece(pass.at.x), plain_piece(pass.at.y)}));
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
  if (target.depth != standard.depth) members.push_back(named("depth", plain_piece(target.depth)));
  if (target.stencil != standard.stencil)
    members.push_back(named("stencil", plain_piece(target.stencil)));
  // Width and height are always written, and come first.
  Target others = standard;
  others.width = target.width;
  others.height = target.height;
  add_fields(target, members, others);
  if (scene.depth_range != DepthRange())
    members.push_back(named("depth_range",
                            exact_list(std::array{scene.depth_range.near, scene.depth_range.far})));
  members.push_back(named("clear", color_piece(target.clear)));
  if (!chosen_by_loader(scene))
    members.push_back(named("viewport", rectangle_piece(scene.viewport)));
  return json_object(std::move(members));
}

JsonPiece position(const Vertex& vertex) {
  Pieces coordinates{plain_piece(vertex.position.x), plain_piece(vertex.position.y)};
  if (vertex.z != Fixed() || vertex.w != 1) coordinates.push_back(plain_piece(vertex.z));
  if (vertex.w != 1) coordinates.push_back(exact_piece(vertex.w));
  return json_array(std::move(coordinates));
}

JsonPiece clip_piece(const ClipPosition& clip) {
  return exact_list(std::array{clip.x, clip.y, clip.z, clip.w});
}

// What a draw's vertices have besides their positions.
struct VertexParts {
  bool color = false;
  int texture_coordinates = 0;  // 1 or 2 if the draw is textured
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

// The dimensions of the texture that a draw looks up; 0 if there is none.
int dimensions_of(const Draw& draw, const Scene& scene) {
  return draw.texture ? scene.textures[draw.texture->texture]->dimensions : 0;
}

void add_multisampling(const Multisampling& own, Pieces& members) {
  add_fields(own, members);
  if (own.mask != Multisampling().mask)
    members.push_back(named("sample_mask", json_scalar(std::to_string(own.mask))));
}

std::optional<JsonPiece> state_piece(const Draw& draw, int dimensions) {
  Draw standard;
  if (draw.texture) standard.interpolation = Interpolation::smooth;
  Pieces members;
  add_fields(draw, members, standard);
  add_multisampling(draw.multisampling, members);
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

Pieces detail_names(Details details) {
  Pieces names;
  for_each_form<Details>([&](const auto& field, const auto&) {
    if (details.*field.member) names.push_back(json_string(field.case_key));
  });
  return names;
}

JsonPiece textures_piece(const Scene& scene) {
  Pieces items;
  for (const auto& texture : scene.textures) items.push_back(texture_piece(*texture));
  return json_array(std::move(items));
}

JsonPiece case_piece(const Scene& scene, const CaseWords& words) {
  Pieces members = word_pieces(words);
  members.push_back(named("target", target_piece(scene)));
  if (Pieces names = detail_names(scene.details); !names.empty())
    members.push_back(named("details", json_array(std::move(names))));
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

// JSON must be well-formed UTF-8, and the printer throws on anything else.
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
  // The loader decides what a case file can express. The id only matters for unspecified colours.
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

void add_word(const char* name, const std::string& word, Pieces& members) {
  if (!word.empty()) members.push_back(named(name, json_string(word)));
}

Pieces word_pieces(const CaseWords& words) {
  Pieces members;
  add_word("$schema", words.schema, members);
  members.push_back(named("title", json_string(words.title)));
  add_word("why", words.why, members);
  members.push_back(named("rules", json_strings(words.rules)));
  add_word("spec", words.spec, members);
  add_word("origin", words.origin, members);
  if (!words.tags.empty()) members.push_back(named("tags", json_strings(words.tags)));
  if (words.invariant) members.push_back(named("invariant", json_scalar("true")));
  return members;
}

}  // namespace edgecase
