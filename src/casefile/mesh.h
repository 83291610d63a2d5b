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
#include <vector>

#include "casefile/fields.h"
#include "casefile/matrices.h"
#include "model/scene.h"

namespace edgecase {

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
  // `case_file` is what the paths of meshes are relative to (casefile/suite_path.h).
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

}  // namespace edgecase
