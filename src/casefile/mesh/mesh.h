// SPDX-License-Identifier: MIT
//
// Triangle meshes from OBJ files. The only user of the OBJ library, tinyobjloader.
//
// Triangles come in the order of the faces; faces with more corners are cut by the library, as it
// sees fit. Normals, groups and materials are left out.
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

constexpr std::size_t kMaxVertices = 65536;  // of a case, all draws together

struct MeshVertex {
  Vector position{};  // object space
  std::optional<Color> color;
  std::optional<std::array<float, 2>> uv;  // texture coordinates s and t
};

// Three vertices for each triangle.
using Mesh = std::vector<MeshVertex>;

struct LoadedMesh {
  Mesh mesh;            // empty exactly when there is a message
  std::string message;  // "LINE: what is wrong", without the file's name
  std::string remedy;
};

LoadedMesh parse_mesh(const std::string& obj_text);

// The meshes that the cases of one file use, each read once.
class MeshShelf {
 public:
  // `case_file` is what the paths of meshes are relative to (casefile/json/text_file.h).
  explicit MeshShelf(std::filesystem::path case_file) : case_file_(std::move(case_file)) {}

  // The mesh that a string names; null, and a finding, where there is none, or where the cases of
  // the file use more vertices of meshes than kMost.
  const Mesh* find(const Place& place, Findings& findings);

 private:
  static constexpr std::size_t kMost = std::size_t{2} << 20;

  std::filesystem::path case_file_;
  std::map<std::filesystem::path, LoadedMesh> meshes_;
  std::size_t used_ = 0;  // vertices handed out
};

// Checks the text of an OBJ file before a library reads it.
//
// The library takes a word that is no number for 0, leaves out faces that it does not understand,
// and trusts indices. So every line is judged here first, and what is handed on are its vertices
// texture coordinates and faces alone. What the format has beside (normals, names, groups,
// materials) is checked no further and left out.
struct ObjCheck {
  // The first fault: its line, from 1 (0: the file as a whole). No fault: an empty message.
  std::size_t line = 0;
  std::string message;
  std::string remedy;

  std::string cleaned;        // OBJ text: "v", "vt" and "f" lines, indices from 1
  std::size_t triangles = 0;  // that its faces make
  bool has_colors = false;    // every vertex has one; else none has
};

// Vertices: "v x y z", "v x y z 1" or "v x y z r g b", magnitudes up to 2^64. Texture
// coordinates: "vt u", "vt u v" or "vt u v w", of which w is left out. Faces: 3 to 255 corners.
// Refused: lines and points, curves and surfaces, files without faces or with more
// triangles than a case may have.
ObjCheck check_obj(std::string_view text);

}  // namespace edgecase
