// SPDX-License-Identifier: MIT
#include "casefile/mesh.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "casefile/obj_check.h"
#include "casefile/suite_path.h"
#include "casefile/text.h"
#include "casefile/text_file.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

MeshVertex vertex_of(const tinyobj::attrib_t& attributes, const tinyobj::index_t& corner,
                     bool has_colors) {
  MeshVertex vertex;
  const auto index = static_cast<std::size_t>(corner.vertex_index);
  for (std::size_t i = 0; i < 3; ++i) vertex.position[i] = attributes.vertices[3 * index + i];
  if (corner.texcoord_index >= 0) {
    const float* uv = &attributes.texcoords[2 * static_cast<std::size_t>(corner.texcoord_index)];
    vertex.uv = {uv[0] + 0.0F, uv[1] + 0.0F};
  }
  if (!has_colors) return vertex;
  Color color{0, 0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) color[i] = attributes.colors[3 * index + i] + 0.0F;
  vertex.color = color;
  return vertex;
}

LoadedMesh refused(std::string message, std::string remedy) {
  return {{}, std::move(message), std::move(remedy)};
}

}  // namespace

LoadedMesh parse_mesh(const std::string& obj_text) {
  const ObjCheck check = check_obj(obj_text);
  if (!check.message.empty())
    return refused(fmt::format("{}{}", check.line > 0 ? fmt::format("line {}: ", check.line) : "",
                               check.message),
                   check.remedy);
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;  // no white where the file has no colours
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(check.cleaned, "", config))
    return refused("the library cannot read it: " + reader.Error(), "write it anew");
  const tinyobj::attrib_t& attributes = reader.GetAttrib();
  const auto is_finite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(attributes.vertices.begin(), attributes.vertices.end(), is_finite) ||
      !std::all_of(attributes.texcoords.begin(), attributes.texcoords.end(), is_finite) ||
      !std::all_of(attributes.colors.begin(), attributes.colors.end(), is_finite))
    return refused("a vertex has a number with an exponent that the library cannot read",
                   "write it without an exponent");
  LoadedMesh loaded;
  for (const tinyobj::shape_t& shape : reader.GetShapes())
    for (const tinyobj::index_t& index : shape.mesh.indices)
      loaded.mesh.push_back(vertex_of(attributes, index, check.has_colors));
  if (loaded.mesh.size() != 3 * check.triangles)
    return refused(fmt::format("the faces make {} triangles, where their corners make {}",
                               loaded.mesh.size() / 3, check.triangles),
                   "write triangles: a face with more corners has no area, or crosses itself");
  return loaded;
}

const Mesh* MeshShelf::find(const Place& place, Findings& findings) {
  if (!read_text(place, "a mesh", {1, 1000}, findings)) return nullptr;
  const auto file = find_in_suite(case_file_, place, "an OBJ file", findings);
  if (!file) return nullptr;
  const auto [entry, fresh] = meshes_.try_emplace(*file);
  LoadedMesh& loaded = entry->second;
  if (fresh) {
    TextFile text = read_text_file(*file, kMaxFileBytes);
    loaded = text.text ? parse_mesh(*text.text)
                       : refused(std::move(text.message), std::move(text.remedy));
  }
  if (!loaded.message.empty()) {
    findings.add(place, fmt::format("{}: {}", quote(place.node->text), loaded.message),
                 loaded.remedy);
    return nullptr;
  }
  used_ += loaded.mesh.size();
  if (used_ <= kMost) return &loaded.mesh;
  findings.add(place,
               fmt::format("the cases of the file use {} vertices of meshes and more", used_),
               "use a smaller mesh, or fewer values");
  return nullptr;
}

}  // namespace edgecase
