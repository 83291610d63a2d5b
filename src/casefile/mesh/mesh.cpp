// SPDX-License-Identifier: MIT
#include "casefile/mesh/mesh.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"

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
  config.vertex_color = false;  // otherwise missing colours become white
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
  if (!read_text(place, "a mesh", kPathLimits, findings)) return nullptr;
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

namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostCorners = 255;
constexpr std::size_t kMostCharacters = 40;  // of a number
constexpr std::string_view kLeftOut[] = {"vn", "vp", "o", "g", "s", "usemtl", "mtllib"};

// Lines end in LF, CR LF or CR.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return lines;
}

Words split_words(std::string_view line) {
  Words words;
  for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = std::min(line.find_first_not_of(" \t", end), line.size());
  }
  return words;
}

std::optional<double> number_of(std::string_view word) {
  if (word.size() > kMostCharacters) return std::nullopt;
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (!(std::fabs(value) <= static_cast<double>(kMaxColor))) return std::nullopt;
  return value;
}

std::optional<std::int64_t> integer_of(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class Checker {
 public:
  explicit Checker(std::string_view text) : lines_(lines_of(text)) {}
  ObjCheck run();

 private:
  void check_line(const Words& words);
  void check_vertex(const Words& words);
  void check_texture_coordinates(const Words& words);
  void check_face(const Words& words);
  // A corner of a face, with indices from 1; nothing, and a fault, if the word is not a corner.
  std::optional<std::string> corner_of(std::string_view word);
  // An index from 1; nothing, and a fault, if it is out of range. `what` names the indexed items:
  // `read` of them have been read, and the file has `all`.
  std::optional<std::int64_t> index_from_one(std::int64_t index, const char* what,
                                             std::int64_t read, std::int64_t all);
  void refuse(std::string message, std::string remedy) {
    result_.line = line_;
    result_.message = std::move(message);
    result_.remedy = std::move(remedy);
  }

  std::vector<std::string_view> lines_;
  std::size_t line_ = 0;
  std::int64_t all_vertices_ = 0;  // of the file
  std::int64_t vertices_ = 0;      // read so far
  std::int64_t all_coordinates_ = 0;
  std::int64_t coordinates_ = 0;
  ObjCheck result_;
};

ObjCheck Checker::run() {
  for (const std::string_view line : lines_) {
    const Words words = split_words(line);
    if (!words.empty() && words[0] == "v") ++all_vertices_;
    if (!words.empty() && words[0] == "vt") ++all_coordinates_;
  }
  for (const std::string_view line : lines_) {
    ++line_;
    check_line(split_words(line));
    if (!result_.message.empty()) return std::move(result_);
  }
  line_ = 0;
  if (result_.triangles == 0)
    refuse("the file has no faces", "add faces: \"f 1 2 3\"");
  else if (3 * result_.triangles > kMaxVertices)
    refuse(fmt::format("the file's faces make {} triangles", result_.triangles),
           fmt::format("use a mesh of {} at most", kMaxVertices / 3));
  return std::move(result_);
}

void Checker::check_line(const Words& words) {
  if (words.empty() || words[0].starts_with('#')) return;
  if (words.back().ends_with('\\'))
    return refuse("the line goes on in the next one", "write it as one line");
  if (words[0] == "v") return check_vertex(words);
  if (words[0] == "vt") return check_texture_coordinates(words);
  if (words[0] == "f") return check_face(words);
  if (std::find(std::begin(kLeftOut), std::end(kLeftOut), words[0]) != std::end(kLeftOut)) return;
  if (words[0] == "l" || words[0] == "p")
    return refuse("lines and points of a mesh are not supported yet", "keep only its faces");
  refuse(fmt::format("{} is not supported", quote(words[0])),
         "keep only vertices (v, vt, vn), faces (f) and names (o, g, s, usemtl, mtllib)");
}

void Checker::check_vertex(const Words& words) {
  std::vector<double> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<double> number = number_of(words[i]);
    if (!number)
      return refuse(fmt::format("{} is no number of a vertex", quote(words[i])),
                    "write a decimal like 0.5, of magnitude 2^64 at most");
    numbers.push_back(*number);
  }
  const std::size_t count = numbers.size();
  if (count == 4 && numbers[3] != 1)
    return refuse("a vertex's w is not 1", "divide x, y and z by it, and write 1");
  if (count != 3 && count != 4 && count != 6)
    return refuse(fmt::format("a vertex has {} numbers", count),
                  "write x y z, or x y z and red green blue");
  const bool colored = count == 6;
  if (vertices_ > 0 && colored != result_.has_colors)
    return refuse("some vertices have colours, and some have none",
                  "give all of them one, or none");
  result_.has_colors = colored;
  ++vertices_;
  result_.cleaned += 'v';
  for (std::size_t i = 1; i < words.size(); ++i)
    if (count != 4 || i < 4) result_.cleaned += fmt::format(" {}", words[i]);
  result_.cleaned += '\n';
}

void Checker::check_texture_coordinates(const Words& words) {
  const std::size_t count = words.size() - 1;
  if (count < 1 || count > 3)
    return refuse(fmt::format("texture coordinates have {} numbers", count), "write u and v");
  for (std::size_t i = 1; i < words.size(); ++i)
    if (!number_of(words[i]))
      return refuse(fmt::format("{} is no texture coordinate", quote(words[i])),
                    "write a decimal like 0.5, of magnitude 2^64 at most");
  ++coordinates_;
  result_.cleaned += fmt::format("vt {} {}\n", words[1], count > 1 ? words[2] : "0");
}

std::optional<std::int64_t> Checker::index_from_one(std::int64_t index, const char* what,
                                                    std::int64_t read, std::int64_t all) {
  // Negative indices count back from the last item read.
  const std::int64_t absolute = index < 0 ? read + 1 + index : index;
  const std::int64_t most = index < 0 ? read : all;
  if (absolute >= 1 && absolute <= most) return absolute;
  refuse(fmt::format("a face names {} {}, and there are {}", what, index, most),
         fmt::format("write 1 to {}, or count back from -1", all));
  return std::nullopt;
}

std::optional<std::string> Checker::corner_of(std::string_view word) {
  const std::optional<std::int64_t> vertex = integer_of(word.substr(0, word.find('/')));
  std::optional<std::int64_t> coordinates;
  std::size_t parts = 1;
  for (std::size_t at = word.find('/'); at != std::string_view::npos; at = word.find('/', at + 1)) {
    const std::size_t end = std::min(word.find('/', at + 1), word.size());
    const std::string_view part = word.substr(at + 1, end - at - 1);
    const std::optional<std::int64_t> index = integer_of(part);
    ++parts;
    const bool may_be_empty = parts == 2 && end < word.size();  // 1//3
    if (parts > 3 || !(index || (part.empty() && may_be_empty))) parts = 4;
    if (parts == 2) coordinates = index;
  }
  if (!vertex || parts > 3) {
    refuse(fmt::format("{} is no corner of a face", quote(word)),
           "write the number of a vertex: 1, 1/2, 1//3 or 1/2/3");
    return std::nullopt;
  }
  const auto first = index_from_one(*vertex, "vertex", vertices_, all_vertices_);
  if (!first) return std::nullopt;
  if (!coordinates) return std::to_string(*first);
  const auto second =
      index_from_one(*coordinates, "texture coordinates", coordinates_, all_coordinates_);
  if (!second) return std::nullopt;
  return fmt::format("{}/{}", *first, *second);
}

void Checker::check_face(const Words& words) {
  const std::size_t corners = words.size() - 1;
  if (corners < 3 || corners > kMostCorners)
    return refuse(fmt::format("a face has {} corners", corners),
                  fmt::format("write 3 to {}", kMostCorners));
  result_.cleaned += 'f';
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<std::string> corner = corner_of(words[i]);
    if (!corner) return;
    result_.cleaned += fmt::format(" {}", *corner);
  }
  result_.cleaned += '\n';
  result_.triangles += corners - 2;
}

}  // namespace

ObjCheck check_obj(std::string_view text) {
  return Checker(text).run();
}

}  // namespace edgecase
