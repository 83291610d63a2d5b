// SPDX-License-Identifier: MIT
#include "casefile/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"
#include "casefile/mesh/triangulation.h"

namespace edgecase {

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostCorners = 255;
constexpr std::size_t kMostCharacters = 40;  // of a number
constexpr std::string_view kLeftOut[] = {"vn", "vp", "o", "g", "s", "usemtl", "mtllib"};

// Adds the words of a line up to a comment.
void add_words(std::string_view line, Words& words) {
  line = line.substr(0, line.find('#'));
  for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = std::min(line.find_first_not_of(" \t", end), line.size());
  }
}

struct Line {
  std::size_t number = 0;  // from 1, of the first of those that go on
  Words words;
};

// Lines end in LF, CR LF or CR, and go on behind a backslash. Those without words are left out.
std::vector<Line> lines_of(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Line> lines;
  bool goes_on = false;
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    std::string_view line = text.substr(start, end - start);
    start = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    ++number;
    if (!goes_on) lines.push_back({number, {}});
    goes_on = line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    add_words(line, lines.back().words);
  }
  std::erase_if(lines, [](const Line& line) { return line.words.empty(); });
  return lines;
}

// The nearest float32 of a decimal.
std::optional<float> number_of(std::string_view word) {
  if (word.size() > kMostCharacters) return std::nullopt;
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (!(std::fabs(value) <= static_cast<double>(kMaxColor))) return std::nullopt;
  float nearest = 0;  // of what is too small, which is out of range
  std::from_chars(word.data(), word.data() + word.size(), nearest);
  return nearest;
}

std::optional<std::int64_t> integer_of(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

struct ObjCorner {
  std::size_t vertex = 0;
  std::optional<std::size_t> uv;
};

struct ObjFace {
  std::size_t line = 0;
  std::vector<ObjCorner> corners;
};

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : lines_(lines_of(text)) {}

  LoadedMesh read() {
    for (const Line& line : lines_) {
      if (line.words[0] == "v") ++all_vertices_;
      if (line.words[0] == "vt") ++all_coordinates_;
    }
    for (const Line& line : lines_) {
      line_ = line.number;
      read_line(line.words);
      if (!result_.message.empty()) return std::move(result_);
    }
    line_ = 0;
    if (triangles_ == 0)
      refuse("the file has no faces", "add faces: \"f 1 2 3\"");
    else if (3 * triangles_ > kMaxVertices)
      refuse(fmt::format("the file's faces make {} triangles", triangles_),
             fmt::format("use a mesh of {} at most", kMaxVertices / 3));
    else
      cut_faces();
    return std::move(result_);
  }

 private:
  void refuse(std::string message, std::string remedy) {
    result_.message = (line_ > 0 ? fmt::format("line {}: ", line_) : "") + std::move(message);
    result_.remedy = std::move(remedy);
  }

  void read_line(const Words& words);
  void read_vertex(const Words& words);
  void read_texture_coordinates(const Words& words);
  void read_face(const Words& words);
  // Nothing, and a fault, if the word is not a corner.
  std::optional<ObjCorner> corner_of(std::string_view word);
  // An index from 0; nothing, and a fault, if it is out of range. `what` names the indexed items:
  // `read` of them have been read, and the file has `all`.
  std::optional<std::size_t> index_of(std::int64_t index, const char* what, std::size_t read,
                                      std::size_t all);
  void cut_faces();

  std::vector<Line> lines_;
  std::size_t line_ = 0;  // of the fault; 0: the whole file
  std::size_t all_vertices_ = 0;
  std::size_t all_coordinates_ = 0;
  std::vector<MeshVertex> vertices_;  // without texture coordinates
  std::vector<std::array<float, 2>> coordinates_;
  std::vector<ObjFace> faces_;
  std::size_t triangles_ = 0;
  LoadedMesh result_;
};

void ObjReader::read_line(const Words& words) {
  if (words[0] == "v") return read_vertex(words);
  if (words[0] == "vt") return read_texture_coordinates(words);
  if (words[0] == "f") return read_face(words);
  if (std::find(std::begin(kLeftOut), std::end(kLeftOut), words[0]) != std::end(kLeftOut)) return;
  if (words[0] == "l" || words[0] == "p")
    return refuse("lines and points of a mesh are not supported yet", "keep only its faces");
  refuse(fmt::format("{} is not supported", quote(words[0])),
         "keep only vertices (v, vt, vn), faces (f) and names (o, g, s, usemtl, mtllib)");
}

void ObjReader::read_vertex(const Words& words) {
  std::vector<float> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<float> number = number_of(words[i]);
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
  MeshVertex vertex;
  std::copy_n(numbers.begin(), 3, vertex.position.begin());
  if (count == 6)
    vertex.color = {numbers[3] + 0.0F, numbers[4] + 0.0F, numbers[5] + 0.0F, 1};  // -0 becomes 0
  if (!vertices_.empty() && vertex.color.has_value() != vertices_[0].color.has_value())
    return refuse("some vertices have colours, and some have none",
                  "give all of them one, or none");
  vertices_.push_back(vertex);
}

void ObjReader::read_texture_coordinates(const Words& words) {
  const std::size_t count = words.size() - 1;
  if (count < 1 || count > 3)
    return refuse(fmt::format("texture coordinates have {} numbers", count), "write u and v");
  std::array<float, 3> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<float> number = number_of(words[i + 1]);
    if (!number)
      return refuse(fmt::format("{} is no texture coordinate", quote(words[i + 1])),
                    "write a decimal like 0.5, of magnitude 2^64 at most");
    numbers[i] = *number + 0.0F;
  }
  coordinates_.push_back({numbers[0], numbers[1]});
}

std::optional<std::size_t> ObjReader::index_of(std::int64_t index, const char* what,
                                               std::size_t read, std::size_t all) {
  // Negative indices count back from the last item read.
  const std::int64_t absolute = index < 0 ? static_cast<std::int64_t>(read) + 1 + index : index;
  const std::size_t most = index < 0 ? read : all;
  if (absolute >= 1 && static_cast<std::size_t>(absolute) <= most)
    return static_cast<std::size_t>(absolute) - 1;
  refuse(fmt::format("a face names {} {}, and there are {}", what, index, most),
         fmt::format("write 1 to {}, or count back from -1", all));
  return std::nullopt;
}

std::optional<ObjCorner> ObjReader::corner_of(std::string_view word) {
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
  const auto first = index_of(*vertex, "vertex", vertices_.size(), all_vertices_);
  if (!first) return std::nullopt;
  if (!coordinates) return ObjCorner{*first, std::nullopt};
  const auto second =
      index_of(*coordinates, "texture coordinates", coordinates_.size(), all_coordinates_);
  if (!second) return std::nullopt;
  return ObjCorner{*first, second};
}

void ObjReader::read_face(const Words& words) {
  const std::size_t corners = words.size() - 1;
  if (corners < 3 || corners > kMostCorners)
    return refuse(fmt::format("a face has {} corners", corners),
                  fmt::format("write 3 to {}", kMostCorners));
  ObjFace face{line_, {}};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<ObjCorner> corner = corner_of(words[i]);
    if (!corner) return;
    face.corners.push_back(*corner);
  }
  faces_.push_back(std::move(face));
  triangles_ += corners - 2;
}

void ObjReader::cut_faces() {
  result_.mesh.reserve(3 * triangles_);
  for (const ObjFace& face : faces_) {
    std::vector<Vector> places;
    for (const ObjCorner& corner : face.corners)
      places.push_back(vertices_[corner.vertex].position);
    const auto triangles = triangles_of(places);
    if (triangles.empty()) {
      line_ = face.line;
      result_.mesh.clear();
      return refuse("the face crosses itself", "write it as triangles");
    }
    for (const auto& triangle : triangles)
      for (const std::size_t i : triangle) {
        const ObjCorner& corner = face.corners[i];
        MeshVertex vertex = vertices_[corner.vertex];
        if (corner.uv) vertex.uv = coordinates_[*corner.uv];
        result_.mesh.push_back(vertex);
      }
  }
}

}  // namespace

LoadedMesh parse_mesh(std::string_view obj_text) {
  return ObjReader(obj_text).read();
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
                       : LoadedMesh{{}, std::move(text.message), std::move(text.remedy)};
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
