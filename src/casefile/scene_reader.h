// SPDX-License-Identifier: MIT
//
// Reads what a case draws: `target` and `draws` to a Scene, defaults filled in.
//
// Defaults that depend on the whole scene are filled last: colours that the file leaves open
// (casefile/salted_colors.h), the viewport (casefile/viewport.h), and where clip coordinates land
// in it. Only a scene without any other fault is then checked for vertices that would not reach
// OpenGL as written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/fields.h"
#include "casefile/matrices.h"
#include "casefile/texture_reader.h"
#include "model/scene.h"

namespace edgecase {

constexpr std::size_t kMaxDraws = 64;        // of a case
constexpr std::size_t kMaxVertices = 65536;  // of a case, all draws together

// A target as written; what it leaves open is absent. A size or a number of samples that is faulty
// is 0.
struct TargetFields {
  Target target;
  bool depth_known = false;  // whether there is a depth buffer; false: what the file says is faulty
  bool stencil_known = false;
  DepthRange depth_range;
  std::optional<Color> clear;
  std::optional<Viewport> viewport;
  std::optional<Place> positions_place;  // of "sample_positions"
  Supersampling supersampling;
  std::optional<Place> supersample_place;
  bool y_down = false;  // the file counts y from the target's upper edge downwards
};

TargetFields read_target(const Place& place, Findings& findings);

// {"x", "y", "width", "height"} in whole pixels: corners from -16384 to 16384, sizes from
// `least_size` to 16384. `what` names it in messages: "a viewport".
std::optional<Viewport> read_rectangle(const Place& place, std::string_view what, int least_size,
                                       Findings& findings);

// A draw as written, with the places that later checks speak of.
struct VertexFields {
  Vertex vertex;
  bool has_color = false;
  std::optional<Vector> object;  // in object space, before `vertex.clip` was made of it
  bool of_mesh = false;
  Place place;             // of the vertex, or of its coordinates, or of its mesh
  std::optional<Place> x;  // places of window coordinates
  std::optional<Place> y;
  std::optional<Place> z;
};
struct DrawFields {
  Draw draw;  // without its vertices
  std::vector<VertexFields> vertices;
};

class MeshShelf;
struct Transform;

// What the draws of a case share.
struct DrawContext {
  const TargetFields& target;
  const Transform* transform = nullptr;  // of draws without one; null: there is none
  // None: the list is faulty, so that no texture's number can be judged.
  const std::optional<TextureList>& textures;
  MeshShelf& meshes;
};

// Reads vertices to where they are drawn, but for what depends on the viewport.
std::vector<DrawFields> read_draws(const Place& place, const DrawContext& context,
                                   Findings& findings);

// Joins both to a scene, with every default filled in. `id` salts the colours. Adds findings for
// vertices that OpenGL could not be given exactly; `draws_place` is the place of the draws.
Scene complete_scene(const TargetFields& target, const std::vector<DrawFields>& draws,
                     const std::string& id, const Place& draws_place, Findings& findings);

}  // namespace edgecase
