// SPDX-License-Identifier: MIT
//
// Triangle meshes from OBJ files. The only user of the OBJ library, tinyobjloader.
//
// Triangles are in the order of the faces; the library splits faces with more corners in its own
// way. Normals, groups and materials are ignored.
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

constexpr std::size_t kMaxVertices = 65536;  // of a case, over all draws

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

LoadedMesh parse_mesh(const std::string& obj_text);

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

// Checks the text of an OBJ file before a library reads it.
//
// The library reads a malformed number as 0, skips faces that it does not understand, and trusts
// indices. So every line is checked here first, and only vertices, texture coordinates and faces
// are passed on. The rest of the format (normals, names, groups, materials) is ignored.
struct ObjCheck {
  // The first fault: its line, from 1 (0: the whole file), and an empty message if there is none.
  std::size_t line = 0;
  std::string message;
  std::string remedy;

  std::string cleaned;        // OBJ text: "v", "vt" and "f" lines, indices from 1
  std::size_t triangles = 0;  // made by its faces
  bool has_colors = false;    // every vertex has one; otherwise none has
};

// Vertices: "v x y z", "v x y z 1" or "v x y z r g b", magnitudes up to 2^64. Texture coordinates:
// "vt u", "vt u v" or "vt u v w", of which w is ignored. Faces: 3 to 255 corners. Refuses lines and
// points, curves and surfaces, files without faces or with more triangles than a case may have.
ObjCheck check_obj(std::string_view text);

}  // namespace edgecase
