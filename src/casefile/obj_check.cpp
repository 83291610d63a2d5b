// SPDX-License-Identifier: MIT
#include "casefile/obj_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "casefile/numbers.h"
#include "casefile/scene_reader.h"
#include "casefile/text.h"

namespace edgecase {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostCorners = 255;
constexpr std::size_t kMostCharacters = 40;  // of a number
constexpr std::string_view kLeftOut[] = {"vt", "vn", "vp", "o", "g", "s", "usemtl", "mtllib"};

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

Words words_of(std::string_view line) {
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
  void check_face(const Words& words);
  // The index of a vertex, from 1; none, and a fault, where the word is no corner.
  std::optional<std::int64_t> corner_of(std::string_view word);
  void refuse(std::string message, std::string remedy) {
    result_.line = line_;
    result_.message = std::move(message);
    result_.remedy = std::move(remedy);
  }

  std::vector<std::string_view> lines_;
  std::size_t line_ = 0;
  std::int64_t all_vertices_ = 0;  // of the file
  std::int64_t vertices_ = 0;      // read so far
  ObjCheck result_;
};

ObjCheck Checker::run() {
  for (const std::string_view line : lines_) {
    const Words words = words_of(line);
    if (!words.empty() && words[0] == "v") ++all_vertices_;
  }
  for (const std::string_view line : lines_) {
    ++line_;
    check_line(words_of(line));
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

std::optional<std::int64_t> Checker::corner_of(std::string_view word) {
  const std::string_view first = word.substr(0, word.find('/'));
  std::size_t parts = 1;
  for (std::size_t at = word.find('/'); at != std::string_view::npos; at = word.find('/', at + 1)) {
    const std::size_t end = std::min(word.find('/', at + 1), word.size());
    const std::string_view part = word.substr(at + 1, end - at - 1);
    ++parts;
    const bool may_be_empty = parts == 2 && end < word.size();  // 1//3
    if (parts > 3 || !(integer_of(part) || (part.empty() && may_be_empty))) parts = 4;
  }
  const std::optional<std::int64_t> index = integer_of(first);
  if (!index || parts > 3) {
    refuse(fmt::format("{} is no corner of a face", quote(word)),
           "write the number of a vertex: 1, 1/2, 1//3 or 1/2/3");
    return std::nullopt;
  }
  // Negative ones count back from the vertices read so far.
  const std::int64_t absolute = *index < 0 ? vertices_ + 1 + *index : *index;
  const std::int64_t most = *index < 0 ? vertices_ : all_vertices_;
  if (absolute >= 1 && absolute <= most) return absolute;
  refuse(fmt::format("a face names vertex {}, and there are {}", *index, most),
         fmt::format("write 1 to {}, or count back from -1", all_vertices_));
  return std::nullopt;
}

void Checker::check_face(const Words& words) {
  const std::size_t corners = words.size() - 1;
  if (corners < 3 || corners > kMostCorners)
    return refuse(fmt::format("a face has {} corners", corners),
                  fmt::format("write 3 to {}", kMostCorners));
  result_.cleaned += 'f';
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<std::int64_t> corner = corner_of(words[i]);
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
