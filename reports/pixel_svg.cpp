// SPDX-License-Identifier: MIT
#include "reports/pixel_svg.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <ostream>
#include <pugixml.hpp>
#include <utility>

#include "reports/nodes.h"
#include "reports/text.h"

namespace edgecase {
namespace {

using Node = pugi::xml_node;
using Place = std::pair<double, double>;
using Style = std::initializer_list<std::pair<const char*, const char*>>;

// Layout, in SVG units.
constexpr double kPanel = 336;  // wanted size of the target's longer side
constexpr double kLeastCell = 3;
constexpr double kMostCell = 84;
constexpr double kLeft = 26;      // for the rows' numbers
constexpr double kBelow = 22;     // for the columns'
constexpr double kMargin = 10;    // in which outlines still show
constexpr double kLabelled = 13;  // least side of a pixel that has room for its number

struct Plot {
  double cell = 0;
  int width = 0;  // pixels
  int height = 0;
  double column(double x) const { return kLeft + x * cell; }
  double row(double y) const { return kMargin + (height - y) * cell; }
};

Node add_layer(Node parent, Style style) {
  Node layer = parent.append_child("g");
  for (const auto& [name, value] : style) set(layer, name, std::string(value));
  return layer;
}

Node add_square(Node parent, const Plot& plot, int x, int y, double inset) {
  Node node = parent.append_child("rect");
  set(node, "x", plot.column(x) + inset);
  set(node, "y", plot.row(y + 1) + inset);
  set(node, "width", plot.cell - 2 * inset);
  set(node, "height", plot.cell - 2 * inset);
  return node;
}

void add_dot(Node parent, const Plot& plot, Place at, double radius) {
  Node dot = parent.append_child("circle");
  set(dot, "cx", plot.column(at.first));
  set(dot, "cy", plot.row(at.second));
  set(dot, "r", radius);
}

void add_outline(Node parent, const Plot& plot, const Mark& mark) {
  std::string points;
  for (const auto& [x, y] : mark.points)
    points += fmt::format("{}{},{}", points.empty() ? "" : " ", plot.column(x), plot.row(y));
  set(parent.append_child(mark.closed ? "polygon" : "polyline"), "points", points);
}

void add_pixels(Node svg, const Plot& plot, const std::vector<int>& hits) {
  Node once = add_layer(svg, {{"fill", "#b9d3f5"}});
  Node more = add_layer(svg, {{"fill", "#5f93dc"}});
  for (int y = 0; y < plot.height; ++y)
    for (int x = 0; x < plot.width; ++x)
      if (const int count = hits[static_cast<std::size_t>(y * plot.width + x)]; count > 0)
        add_square(count == 1 ? once : more, plot, x, y, 0);
  std::string path;
  for (int x = 0; x <= plot.width; ++x)
    path += fmt::format("M{} {}V{}", plot.column(x), plot.row(0), plot.row(plot.height));
  for (int y = 0; y <= plot.height; ++y)
    path += fmt::format("M{} {}H{}", plot.column(0), plot.row(y), plot.column(plot.width));
  set(add_layer(svg, {{"fill", "none"}, {"stroke", "#9aa4b0"}, {"stroke-opacity", ".55"}})
          .append_child("path"),
      "d", path);
}

// The numbers of columns and rows, at their pixels' centres.
void add_numbers(Node svg, const Plot& plot) {
  if (plot.cell < kLabelled) return;
  Node layer = add_layer(svg, {{"fill", "#5b6270"},
                               {"font-family", "sans-serif"},
                               {"font-size", "11"},
                               {"text-anchor", "middle"}});
  const auto add_number = [&](double x, double y, int number) {
    Node node = layer.append_child("text");
    set(node, "x", x);
    set(node, "y", y);
    node.text().set(number);
  };
  for (int x = 0; x < plot.width; ++x)
    add_number(plot.column(x + .5), plot.row(0) + kMargin + 10, x);
  for (int y = 0; y < plot.height; ++y) add_number(kLeft / 2 - 2, plot.row(y + .5) + 4, y);
}

// A node in the same coordinates, clipped to the target and a margin.
Node add_window(Node svg, const Plot& plot) {
  const double left = plot.column(0) - kMargin;
  const double wide = plot.width * plot.cell + 2 * kMargin;
  const double high = plot.height * plot.cell + 2 * kMargin;
  Node window = svg.append_child("svg");
  set(window, "x", left);
  set(window, "y", 0.0);
  set(window, "width", wide);
  set(window, "height", high);
  set(window, "viewBox", fmt::format("{} 0 {} {}", left, wide, high));
  return window;
}

// Outlines of primitives. The start of a line is marked; a point consists only of that mark.
void add_scene(Node window, const Plot& plot, const Figure& figure) {
  Node lines = add_layer(window, {{"fill", "none"},
                                  {"stroke", "#1b1f24"},
                                  {"stroke-width", "1.5"},
                                  {"stroke-linejoin", "round"}});
  Node starts = add_layer(window, {{"fill", "#1b1f24"}});
  for (const Mark& mark : figure.marks) {
    if (mark.role != MarkRole::primitive || mark.points.empty()) continue;
    if (mark.points.size() > 1) add_outline(lines, plot, mark);
    if (!mark.closed) add_dot(starts, plot, mark.points.front(), 3.5);
  }
}

// The geometry that the rules test: regions, and the edges that own samples on them.
void add_evidence(Node window, const Plot& plot, const std::vector<PixelDecision>& decisions) {
  Node regions = add_layer(window, {{"fill", "#f2a93b"},
                                    {"fill-opacity", ".18"},
                                    {"stroke", "#8a4b00"},
                                    {"stroke-width", "1.4"}});
  Node edges = add_layer(window, {{"fill", "none"}, {"stroke", "#8a4b00"}, {"stroke-width", "2"}});
  Node owned = add_layer(window, {{"fill", "none"}, {"stroke", "#8a4b00"}, {"stroke-width", "4"}});
  for (const PixelDecision& decision : decisions)
    for (const Mark& mark : decision.figure.marks) {
      if (mark.points.size() < 2) continue;
      if (mark.role == MarkRole::region) add_outline(regions, plot, mark);
      if (mark.role == MarkRole::edge) add_outline(edges, plot, mark);
      if (mark.role == MarkRole::owned) add_outline(owned, plot, mark);
    }
}

void add_samples(Node window, const Plot& plot, const std::vector<PixelDecision>& decisions) {
  std::map<Place, bool> covered;
  for (const PixelDecision& decision : decisions)
    for (const Mark& mark : decision.figure.marks)
      if (mark.role == MarkRole::sample)
        for (const Place& at : mark.points) {
          bool& is_covered = covered[at];
          is_covered = is_covered || decision.is_covered;
        }
  const Style style = {{"stroke", "#8a1c5a"}, {"stroke-width", "1.8"}};
  Node dots = add_layer(window, style);
  set(dots, "fill", std::string("#8a1c5a"));
  Node rings = add_layer(window, style);
  set(rings, "fill", std::string("#fff"));
  const double radius = std::min(4.0, plot.cell / 5);
  for (const auto& [at, is_covered] : covered) add_dot(is_covered ? dots : rings, plot, at, radius);
}

void add_frame(Node svg, const Plot& plot, const PixelPicture& picture) {
  Node frame = add_layer(svg, {{"fill", "none"}, {"stroke", "#8a1c5a"}, {"stroke-width", "2.6"}});
  const bool is_drawn = std::any_of(picture.decisions.begin(), picture.decisions.end(),
                                    [](const PixelDecision& d) { return d.is_covered; });
  if (!is_drawn) set(frame, "stroke-dasharray", std::string("5 3"));
  add_square(frame, plot, picture.x, picture.y, 0);
}

}  // namespace

void add_pixel_svg(pugi::xml_node parent, const PixelPicture& picture) {
  const double longer = std::max(picture.width, picture.height);
  const Plot plot{std::clamp(std::floor(kPanel / longer), kLeastCell, kMostCell), picture.width,
                  picture.height};
  const double width = kLeft + picture.width * plot.cell + kMargin;
  const double height = kMargin + picture.height * plot.cell + kBelow;
  Node svg = add_svg(parent, width, height);
  set(svg, "role", std::string("img"));
  set(svg, "aria-label", one_line(picture.title));
  Node paper = svg.append_child("rect");
  set(paper, "width", width);
  set(paper, "height", height);
  set(paper, "fill", std::string("#fff"));
  add_pixels(svg, plot, picture.hits);
  add_numbers(svg, plot);
  add_frame(svg, plot, picture);
  Node window = add_window(svg, plot);
  add_evidence(window, plot, picture.decisions);
  add_scene(window, plot, picture.figure);
  add_samples(window, plot, picture.decisions);
}

void write_pixel_svg(const PixelPicture& picture, std::ostream& out) {
  pugi::xml_document document;
  add_pixel_svg(document, picture);
  document.save(
      out, "", pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags);
}

}  // namespace edgecase
