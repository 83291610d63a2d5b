// SPDX-License-Identifier: MIT
//
// Reads what a case draws: `target` and `draws` to a Scene, defaults filled in.
//
// Defaults that depend on the whole scene are filled last: colours that the file leaves open,
// the viewport (casefile/scene/viewport.h), and where clip coordinates land in it. Only a scene
// without any other fault is then checked for vertices that would not reach OpenGL as written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/mesh/mesh.h"
#include "casefile/mesh/transform.h"
#include "casefile/scene/textures.h"
#include "model/scene.h"

namespace edgecase {

constexpr std::size_t kMaxDraws = 64;  // of a case

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

// Reads the vertices of a draw in the three ways to give one: where it lands in the window, as clip
// coordinates, or in object space; and makes the last ones clip coordinates.

// What a draw says of its vertices.
struct VertexDefaults {
  std::optional<Color> color;  // of those that have none of their own
  bool textured = false;       // all have texture coordinates, and none a colour
  int dimensions = 0;          // of the texture: how many coordinates; 0: not known
};

// [x, y], [x, y, z], [x, y, z, w], or an object with "at", "clip" or "object", and "color" or "uv".
VertexFields read_vertex(const Place& place, const VertexDefaults& defaults, Findings& findings);

// The vertices of a mesh, in object space; `place` is the mesh's in the file. Of a textured draw,
// colours are left out, and a mesh without texture coordinates is refused.
std::vector<VertexFields> mesh_vertices(const Mesh& mesh, const Place& place,
                                        const VertexDefaults& defaults, Findings& findings);

// Which parts of a transform had vertices to act on.
struct TransformUse {
  bool affine = false;
  bool matrix = false;
};

// Moves vertices in window coordinates and takes those in object space to clip coordinates. A null
// `transform` is one that changes nothing. Findings name vertices that cannot be drawn, of a mesh
// only the first. Call only where no vertex was found wrong.
TransformUse transform_vertices(const Transform* transform, std::vector<VertexFields>& vertices,
                                Findings& findings);

// Colours that a case file leaves open, salted by the case's id.
//
// If every case drew white on black, a renderer that answers a constant, or another case's image,
// would be right by accident. So each case gets colours of its own: a 64-bit hash (FNV-1a and a
// final mixing, so that every bit of the id reaches every bit of the hash) of its id yields
//  - the clear colour: red, green and blue k/255 with k from 0 to 63, alpha 1: dark;
//  - the colour of primitive p: alpha 1, brightest channel at least 192/255, dimmest at most 71.
//    The hue turns by the golden ratio from one primitive to the next, about 138 degrees, so that
//    neighbours in drawing order never look alike; the three lowest bits of each channel are salt.
// The result depends on the id and on p alone, on every machine.
std::uint64_t hash_of_id(std::string_view id);

Color salted_clear(std::uint64_t hash);

// `primitive`: index in drawing order over all draws of the case.
Color salted_primitive(std::uint64_t hash, std::uint64_t primitive);

// Which of those colours each vertex of a draw has, counted from the draw's first: separate
// primitives have one each. The vertices of strips, loops and fans are shared, so that each vertex
// has one of its own, and hues of primitives that follow each other are a sixth of a turn apart at
// least, whichever vertex provokes; a loop's last segment and its first follow each other, too.
std::vector<std::uint64_t> salted_indices(Primitive primitive, std::size_t vertices);

// What drawing a scene may cost, told before anything is drawn: a case file of a few lines can ask
// for more fragments than any machine holds.

// Samples that the primitives of a case may cover, counted as often as they are: two screens of
// 2048 by 2048 pixels. Exact takes some 200 bytes and 2 microseconds for each.
constexpr std::uint64_t kMaxDrawnSamples = std::uint64_t{1} << 23;

// An upper bound of that number: what lies in the target and the scissor box, of each triangle half
// the box around it and its border, of each line a band, of each point a square; over all passes of
// a supersampled scene. Vertices must have been placed. A triangle that is clipped counts as the
// box round it, and as all that can be drawn to where it reaches behind the eye, as a clipped line
// does.
std::uint64_t most_drawn_samples(const Scene& scene);

// Refuses a scene of which that is more than kMaxDrawnSamples. `draws`: where the file has them.
void check_draw_work(const Scene& scene, const Place& draws, Findings& findings);

// The definitions of all this in the schema: target, rectangle, draw, vertex, and what they are
// made of but for textures, samples and fragment operations.
Pieces target_schemas();
Pieces draw_schemas();
Pieces vertex_schemas();

}  // namespace edgecase
