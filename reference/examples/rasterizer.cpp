// SPDX-License-Identifier: MIT
//
// An exact rasterizer in C++, to read and to start from: points, lines of width 1 and triangles of
// flat colours. It refuses everything else in a scene. To build and try it:
//
//   g++ -std=c++20 -O2 -o rasterizer reference/examples/rasterizer.cpp
//   edgecase run --against exec:./rasterizer
//
// All decisions use integers. Vertices lie on multiples of 1/65536 pixel within 8192 pixels of the
// origin: in those units they are below 2^30, and all products below 2^63. Where the rules move
// something by an infinitesimal e, a Number a + b e + c e^2 is the array {a, b, c}, and arrays
// compare by their first difference, which is exactly the order of such numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

using nlohmann::json;
using Int = std::int64_t;
using Number = std::array<Int, 3>;
constexpr Number kZero = {0, 0, 0};
constexpr Int kPixel = 65536;

struct Point {
  Int x, y;
};
using Corners = std::vector<Point>;  // of a primitive: one, two or three

// GL 4.6 core, 14.4.1: the centre lies in the square, which owns its right and top sides. The
// specification leaves open which sides.
bool point_covers(Point p, Int size, Point centre) {
  const Int x = 2 * (centre.x - p.x), y = 2 * (centre.y - p.y);
  return -size < x && x <= size && -size < y && y <= size;
}

// 14.5.1, diamond exit: the segment from a to b, both moved by -(e, e^2), meets the pixel's open
// diamond and does not end in it. The diamond is where sx dx + sy dy - 1/2 < 0 for all four signs.
bool line_covers(Point a, Point b, Point centre) {
  struct Part {
    Number n;
    Int of;
  };  // of the way from a to b
  const auto less = [](const Part& p, const Part& q) {
    const auto times = [](const Number& n, Int k) { return Number{n[0] * k, n[1] * k, n[2] * k}; };
    return times(p.n, q.of) < times(q.n, p.of);
  };
  Part enter = {{0, -1, 0}, 1}, leave = {{1, 1, 0}, 1};  // from just before a to just after b
  bool ends_inside = true;
  for (const auto& [sx, sy] : {std::array<Int, 2>{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    const Int at_a = sx * (a.x - centre.x) + sy * (a.y - centre.y) - kPixel / 2;
    const Int at_b = sx * (b.x - centre.x) + sy * (b.y - centre.y) - kPixel / 2;
    const Int slope = at_b - at_a, sign = slope < 0 ? -1 : 1;
    const Part crossing = {{-at_a * sign, sx * sign, sy * sign}, slope * sign};
    if (Number{at_b, -sx, -sy} >= kZero) ends_inside = false;
    if (slope == 0 && Number{at_a, -sx, -sy} >= kZero) return false;
    if (slope > 0 && less(crossing, leave)) leave = crossing;
    if (slope < 0 && less(enter, crossing)) enter = crossing;
  }
  const Part start = {kZero, 1}, end = {{1, 0, 0}, 1};
  return !ends_inside && less(enter, leave) && less(enter, end) && less(start, leave);
}

// Twice the triangle's area, positive if c lies to the left of a -> b.
Int side(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// 14.6.1: the centre lies inside. One on an edge is moved by (e, -e^2), so that left edges own it,
// and then top ones; the specification leaves that open.
bool triangle_covers(const Corners& t, Point centre) {
  const Int area = side(t[0], t[1], t[2]), turn = area < 0 ? -1 : 1;
  const auto inside = [&](Point q, Point r) {
    return Number{turn * side(q, r, centre), turn * (q.y - r.y), turn * (q.x - r.x)} > kZero;
  };
  return area != 0 && inside(t[0], t[1]) && inside(t[1], t[2]) && inside(t[2], t[0]);
}

bool covers(const Corners& c, Int point_size, Point centre) {
  if (c.size() == 1) return point_covers(c[0], point_size, centre);
  return c.size() == 2 ? line_covers(c[0], c[1], centre) : triangle_covers(c, centre);
}

// 10.1: the vertices of primitive i of n vertices, or none. They are rotated so that the first one
// provokes under the convention `first`, and the last one under `last`.
std::vector<int> primitive(const std::string& kind, int i, int n) {
  if (kind == "points" && i < n) return {i};
  if (kind == "lines" && 2 * i + 1 < n) return {2 * i, 2 * i + 1};
  if (kind == "line_strip" && i + 1 < n) return {i, i + 1};
  if (kind == "line_loop" && i < n) return {i, (i + 1) % n};
  if (kind == "triangles" && 3 * i + 2 < n) return {3 * i, 3 * i + 1, 3 * i + 2};
  if (kind == "triangle_strip" && i + 2 < n) return {i, i + 1, i + 2};
  if (kind == "triangle_fan" && i + 2 < n) return {i + 1, 0, i + 2};
  return {};
}

// Why a scene is not drawn, or "". An unknown key may change anything.
std::string refusal(const json& scene) {
  std::string reason;
  const auto unless = [&](bool good, const std::string& why) {
    if (!good) reason = why;
  };
  const auto check_keys = [&](const json& object, const std::set<std::string>& known) {
    for (const auto& [key, value] : object.items())
      unless(known.contains(key), "this example does not know \"" + key + "\"");
  };
  check_keys(scene, {"target", "viewport", "draws", "details"});  // details need not be told
  check_keys(scene["target"], {"width", "height", "samples", "color", "surface", "clear"});
  unless(scene["target"]["samples"] == 1, "this example has one sample per pixel");
  unless(scene["target"]["color"] == "rgba8", "this example draws rgba8");
  for (const json& draw : scene["draws"]) {
    check_keys(draw, {"primitive", "interpolation", "provoking_vertex", "line_width", "point_size",
                      "scissor", "vertices"});
    for (const json& vertex : draw["vertices"]) check_keys(vertex, {"position", "color"});
    const std::string kind = draw["primitive"];
    unless(!primitive(kind, 0, 3).empty(), "this example draws no " + kind);
    unless(draw["interpolation"] == "flat" || kind == "points", "this example's colours are flat");
    unless(!kind.starts_with("line") || draw["line_width"] < 1.5,
           "this example draws lines of width 1");
  }
  return reason;
}

// Lines and triangles are cut at the viewport, but only vertices with "clip" lie beyond it.
json render(const json& scene) {
  const int width = scene["target"]["width"], height = scene["target"]["height"];
  std::vector<int> pixels, hits(static_cast<std::size_t>(width) * height);
  const auto code = [](double n) { return std::lrint(255 * std::clamp(n, 0.0, 1.0)); };
  for (std::size_t i = 0; i < 4 * hits.size(); ++i)
    pixels.push_back(code(scene["target"]["clear"][i % 4]));
  json fragments = json::array();
  int number = 0;  // of the primitive, over all draws
  for (const json& draw : scene["draws"]) {
    const json& vertices = draw["vertices"];
    const std::array<int, 4> box = draw.value("scissor", std::array<int, 4>{0, 0, width, height});
    const Int size = std::llrint(draw["point_size"].get<double>() * kPixel);
    for (int i = 0;; ++i, ++number) {
      const std::vector<int> numbers = primitive(draw["primitive"], i, vertices.size());
      if (numbers.empty()) break;
      Corners corners;
      for (const int n : numbers) {
        const json& at = vertices[n]["position"];
        corners.push_back(
            {std::llrint(at[0].get<double>() * kPixel), std::llrint(at[1].get<double>() * kPixel)});
      }
      const bool first = draw["provoking_vertex"] == "first";
      const json& color = vertices[first ? numbers.front() : numbers.back()]["color"];
      const int top = std::min(box[1] + box[3], height), right = std::min(box[0] + box[2], width);
      for (int y = std::max(box[1], 0); y < top; ++y) {
        for (int x = std::max(box[0], 0); x < right; ++x) {
          if (!covers(corners, size, {x * kPixel + kPixel / 2, y * kPixel + kPixel / 2})) continue;
          const std::size_t at = static_cast<std::size_t>(y) * width + x;
          for (int c = 0; c < 4; ++c) pixels[4 * at + c] = code(color[c]);
          ++hits[at];
          fragments.push_back({{"x", x}, {"y", y}, {"primitive", number}, {"color", color}});
        }
      }
    }
  }
  return {{"pixels", pixels}, {"fragments", fragments}, {"hits", hits}};
}

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const json request = json::parse(line), &scene = request["scene"];
    const std::string reason =
        request["edgecase"] == 1 ? refusal(scene) : "this example speaks version 1";
    json answer = reason.empty() ? render(scene) : json{{"not_run", reason}};
    answer["digest"] = request["digest"];
    answer["renderer"] = {
        {"vendor", "Edgecase"}, {"device", "rasterizer.cpp"}, {"subpixel_bits", 16}};
    std::cout << answer << std::endl;  // which also flushes
  }
}
