// SPDX-License-Identifier: MIT
//
// Triangle meshes from OBJ files.
//
// Triangles are in the order of the faces; casefile/mesh/triangulation.h cuts faces with more
// corners. Normals, groups and materials are ignored.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/mesh/transform.h"
#include "model/scene.h"

namespace edgecase {

constexpr std::size_t kMaxVertices = std::size_t{1} << 18;  // of a case, over all draws

struct MeshVertex {
  Vector position{};  // object space
  std::optional<Color> color;
  std::optional<std::array<float, 2>> uv;  // texture coordinates s and t
};

// Three vertices for each triangle.
using Mesh = std::vector<MeshVertex>;

struct LoadedMesh {
  Mesh mesh;            // empty exactly if there is a message
  std::string message;  // "LINE: fault", without the file's name
  std::string remedy;
};

// Reads the text of an OBJ file. Vertices: "v x y z", "v x y z 1" or "v x y z r g b", magnitudes up
// to 2^64, as the nearest float32. Texture coordinates: "vt u", "vt u v" or "vt u v w", of which w
// is ignored. Faces: 3 to 255 corners. Comments may follow a line, which may go on in the next one.
// Refuses lines and points, curves and surfaces, files without faces or with more triangles than a
// case may have.
LoadedMesh parse_mesh(std::string_view obj_text);

// The meshes that the cases of one file use, each read once.
class MeshShelf {
 public:
  // Paths of meshes are relative to `case_file` (casefile/json/fields.h).
  explicit MeshShelf(std::filesystem::path case_file) : case_file_(std::move(case_file)) {}

  // The mesh that a string names. Null, and a finding, if there is none, or if the cases of the
  // file use more than kMost vertices of meshes.
  const Mesh* find(const Place& place, Findings& findings);

 private:
  static constexpr std::size_t kMost = std::size_t{2} << 20;

  std::filesystem::path case_file_;
  std::map<std::filesystem::path, LoadedMesh> meshes_;
  std::size_t used_ = 0;  // vertices handed out
};

}  // namespace edgecase
