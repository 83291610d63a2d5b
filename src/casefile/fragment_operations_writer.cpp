// SPDX-License-Identifier: MIT
#include "casefile/fragment_operations_writer.h"

#include <string>
#include <utility>

#include "casefile/blend_presets.h"
#include "casefile/number_pieces.h"

namespace edgecase {
namespace {

template <class Enum>
void add_name(const char* key, Enum value, Enum standard, Pieces& members) {
  if (value != standard) members.push_back(named(key, json_string(name_of(value))));
}

void add_byte(const char* key, int value, int standard, Pieces& members) {
  if (value != standard) members.push_back(named(key, integer_piece(value)));
}

void add_float(const char* key, float value, float standard, Pieces& members) {
  if (value != standard) members.push_back(named(key, exact_piece(value)));
}

JsonPiece depth_piece(const DepthTest& test) {
  if (test.write) return json_string(name_of(test.function));
  if (test.function == CompareFunction::always) return json_string("off");
  return json_object(
      {named("test", json_string(name_of(test.function))), named("write", json_scalar("false"))});
}

JsonPiece face_piece(const StencilFace& face) {
  const StencilFace standard;
  Pieces members;
  add_name("test", face.function, standard.function, members);
  add_byte("reference", face.reference, standard.reference, members);
  add_byte("read_mask", face.read_mask, standard.read_mask, members);
  add_byte("write_mask", face.write_mask, standard.write_mask, members);
  add_name("fail", face.fail, standard.fail, members);
  add_name("depth_fail", face.depth_fail, standard.depth_fail, members);
  add_name("pass", face.pass, standard.pass, members);
  return json_object(std::move(members));
}

JsonPiece stencil_piece(const StencilTest& test) {
  if (test.front == test.back) return face_piece(test.front);
  Pieces members;
  const StencilFace standard;
  if (test.front != standard) members.push_back(named("front", face_piece(test.front)));
  if (test.back != standard) members.push_back(named("back", face_piece(test.back)));
  return json_object(std::move(members));
}

Pieces term_pieces(const BlendTerm& term) {
  Pieces members;
  add_name("equation", term.equation, BlendEquation::add, members);
  if (!takes_factors(term.equation)) return members;
  members.push_back(named("source", json_string(name_of(term.source))));
  members.push_back(named("destination", json_string(name_of(term.destination))));
  return members;
}

JsonPiece blend_piece(const Blending& blending) {
  const Blending standard;
  const bool constant = blending.constant != standard.constant;
  for (const BlendPreset& preset : kBlendPresets)
    if (!constant && blending.color == preset.color && blending.alpha == preset.alpha)
      return json_string(preset.name);
  Pieces members;
  if (blending.color == blending.alpha)
    members = term_pieces(blending.color);
  else
    members = {named("color", json_object(term_pieces(blending.color))),
               named("alpha", json_object(term_pieces(blending.alpha)))};
  if (constant) members.push_back(named("constant", color_piece(blending.constant)));
  return json_object(std::move(members));
}

JsonPiece color_mask_piece(const std::array<bool, 4>& mask) {
  constexpr std::array<char, 4> kLetters{'r', 'g', 'b', 'a'};
  std::string text;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) text += kLetters[i];
  return json_string(text);
}

JsonPiece offset_piece(const PolygonOffset& offset) {
  Pieces members;
  add_float("factor", offset.factor, 0, members);
  add_float("units", offset.units, 0, members);
  add_float("clamp", offset.clamp, 0, members);
  return json_object(std::move(members));
}

}  // namespace

std::vector<JsonPiece> target_operation_pieces(const Scene& scene) {
  const Target& target = scene.target;
  const Target standard;
  Pieces members;
  add_name("stencil", target.stencil, standard.stencil, members);
  add_float("clear_depth", target.clear_depth, standard.clear_depth, members);
  add_byte("clear_stencil", target.clear_stencil, standard.clear_stencil, members);
  if (scene.depth_range != DepthRange())
    members.push_back(named("depth_range",
                            exact_list(std::array{scene.depth_range.near, scene.depth_range.far})));
  return members;
}

std::vector<JsonPiece> fragment_operation_pieces(const Draw& draw) {
  const Draw standard;
  const FragmentOperations& operations = draw.operations;
  Pieces members;
  add_name("front_face", draw.front_face, standard.front_face, members);
  add_name("cull", draw.cull, standard.cull, members);
  if (draw.polygon_offset)
    members.push_back(named("polygon_offset", offset_piece(*draw.polygon_offset)));
  if (operations.stencil) members.push_back(named("stencil", stencil_piece(*operations.stencil)));
  if (operations.depth != standard.operations.depth)
    members.push_back(named("depth", depth_piece(operations.depth)));
  if (operations.blending) members.push_back(named("blend", blend_piece(*operations.blending)));
  if (operations.color_mask != standard.operations.color_mask)
    members.push_back(named("color_mask", color_mask_piece(operations.color_mask)));
  return members;
}

}  // namespace edgecase
