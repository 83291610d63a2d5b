// SPDX-License-Identifier: MIT
//
// Reads what a case draws: `target` and `draws` to a Scene with defaults filled in.
//
// Defaults that depend on the whole scene come last: unspecified colours, the viewport
// (casefile/scene/viewport.h), and window positions of clip coordinates. Only a scene without any
// other fault is checked for vertices that would not reach OpenGL as written.
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

constexpr std::size_t kMaxDraws = 64;  // in a case

// A target as written; unspecified fields are absent. A faulty size or number of samples is 0.
struct TargetFields {
  Target target;
  bool depth_known = false;  // whether `target.depth` is valid; false if the file's value is faulty
  bool stencil_known = false;
  DepthRange depth_range;
  std::optional<Color> clear;
  std::optional<Viewport> viewport;
  std::optional<Place> positions_place;  // of "sample_positions"
  Supersampling supersampling;
  std::optional<Place> supersample_place;
  bool y_down = false;  // the file counts y downwards from the target's upper edge
};

TargetFields read_target(const Place& place, Findings& findings);

// A draw as written, with places for the messages of later checks.
struct VertexFields {
  Vertex vertex;
  bool has_color = false;
  std::optional<Vector> object;  // in object space; the source of `vertex.clip`
  bool of_mesh = false;
  Place place;             // of the vertex, its coordinates or its mesh
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
  const Transform* transform = nullptr;  // of draws without one; may be null
  // Nothing if the list is faulty, so that texture numbers cannot be judged.
  const std::optional<TextureList>& textures;
  MeshShelf& meshes;
};

// Reads vertices and transforms them, except for what depends on the viewport.
std::vector<DrawFields> read_draws(const Place& place, const DrawContext& context,
                                   Findings& findings);

// Combines both into a scene with every default filled in. Default colours depend on `id`. Adds
// findings for vertices that OpenGL could not receive exactly; `draws_place` is that of the draws.
Scene complete_scene(const TargetFields& target, const std::vector<DrawFields>& draws,
                     const std::string& id, const Place& draws_place, Findings& findings);

// Reads the vertices of a draw in three forms: window coordinates, clip coordinates, or object
// space, which is converted to clip coordinates.

// The properties that a draw gives its vertices.
struct VertexDefaults {
  std::optional<Color> color;  // of vertices without one of their own
  bool textured = false;       // all have texture coordinates, and none a colour
  int dimensions = 0;          // of the texture, and so the number of coordinates; 0: unknown
};

// [x, y], [x, y, z], [x, y, z, w], or an object with "at", "clip" or "object", and "color" or "uv".
VertexFields read_vertex(const Place& place, const VertexDefaults& defaults, Findings& findings);

// The vertices of a mesh, in object space; `place` is that of the mesh in the file. In a textured
// draw, colours are ignored, and a mesh without texture coordinates is refused.
std::vector<VertexFields> mesh_vertices(const Mesh& mesh, const Place& place,
                                        const VertexDefaults& defaults, Findings& findings);

// Which parts of a transform had any vertices to move.
struct TransformUse {
  bool affine = false;
  bool matrix = false;
};

// Moves vertices in window coordinates, and takes vertices in object space to clip coordinates. A
// null `transform` is the identity. Findings name vertices that cannot be drawn, only the first of
// a mesh. Call it only if all vertices are valid.
TransformUse transform_vertices(const Transform* transform, std::vector<VertexFields>& vertices,
                                Findings& findings);

// Default colours of a case file, derived from the case's id.
//
// If every case drew white on black, a renderer that answers a constant, or another case's image,
// would be right by accident. So each case gets its own colours: a 64-bit hash of its id (FNV-1a
// and a final mixing, so that every bit of the id affects every bit of the hash) yields
//  - the clear colour: red, green and blue k/255 with k from 0 to 63, alpha 1: dark;
//  - the colour of primitive p: alpha 1, brightest channel at least 192/255, dimmest at most 71.
//    The hue turns by the golden ratio from one primitive to the next, about 138 degrees, so that
//    neighbours in drawing order never look alike; the three lowest bits of each channel are salt.
// The result depends only on the id and on p, on every machine.
std::uint64_t hash_of_id(std::string_view id);

Color salted_clear(std::uint64_t hash);

// `primitive`: index in drawing order over all draws of the case.
Color salted_primitive(std::uint64_t hash, std::uint64_t primitive);

// The index of each vertex's colour, relative to the draw's first: separate primitives have one
// colour each. Vertices of strips, loops and fans are shared, so each vertex has a colour of its
// own. Hues of consecutive primitives are at least a sixth of a turn apart, whichever vertex
// provokes; a loop's last and first segment count as consecutive, too.
std::vector<std::uint64_t> salted_indices(Primitive primitive, std::size_t vertices);

// Bounds the cost of a scene before anything is drawn: a case file of a few lines could demand more
// fragments than any machine can store.

// The largest number of samples that the primitives of a case may cover, with repetition: two
// screens of 2048 by 2048 pixels. Exact takes some 200 bytes and 2 microseconds for each.
constexpr std::uint64_t kMaxDrawnSamples = std::uint64_t{1} << 23;

// An upper bound of that number, over all passes of a supersampled scene, within the target and the
// scissor box: for a triangle half of its box plus its border, for a line a band, for a point a
// square. Vertices must have their positions. A clipped triangle counts as its box or, if it
// reaches behind the eye, as everything drawable, as a clipped line does.
std::uint64_t most_drawn_samples(const Scene& scene);

// Refuses a scene with more than kMaxDrawnSamples. `draws`: their place in the file.
void check_draw_work(const Scene& scene, const Place& draws, Findings& findings);

// The schema's definitions of target, rectangle, draw and vertex and of their parts, except
// textures, samples and fragment operations.
Pieces target_schemas();
Pieces draw_schemas();
Pieces vertex_schemas();

}  // namespace edgecase
