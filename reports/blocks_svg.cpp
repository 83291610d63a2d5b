// SPDX-License-Identifier: MIT
#include "reports/blocks_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <pugixml.hpp>
#include <tuple>

#include "reports/nodes.h"
#include "reports/text.h"

namespace edgecase {
namespace {

// Layout, in SVG units.
constexpr double kPanel = 544;    // wanted width of the first panel
constexpr double kLeastCell = 4;  // of a pixel's side
constexpr double kMostCell = 28;
constexpr double kLeastWide = 350;  // of a panel with its caption
constexpr double kMostWide = 1130;  // of the picture
constexpr double kGap = 16;         // around panels
constexpr double kHeading = 22;     // height of a panel's title
constexpr double kLine = 17;        // from one base line to the next
constexpr double kLegend = 500;     // width of the legend
constexpr double kSwatch = 14;

constexpr const char* kStyle =
    "text{font:12px sans-serif;fill:#1b1f24}.title{font-weight:bold}"
    ".paper{fill:#fff}.target{fill:#fff;stroke:#6b7480}"
    ".accepted{fill:url(#accepted)}.rejected{fill:url(#rejected)}.tested{fill:#fff6d9}"
    ".divided{fill:none;stroke-width:2.4;stroke-dasharray:6 3}"
    ".accepted,.rejected,.tested,.divided{stroke:#1b1f24;stroke-opacity:.6}"
    ".covered{fill:#8a4b00}.uncovered{fill:#fff;stroke:#8a4b00;stroke-width:.9}"
    ".outline{fill:none;stroke:#c0182b;stroke-width:1.8;stroke-linejoin:round}"
    ".number{font-weight:bold;text-anchor:middle;paint-order:stroke;stroke:#fff;stroke-width:3px}"
    ".edge{fill:#c0182b}.digit{font-weight:bold;font-size:11px;text-anchor:middle;fill:#fff}";

struct Panel {
  pugi::xml_node node;
  double cell = 0;
  int width = 0;  // pixels
  int height = 0;
  double column(double x) const { return x * cell; }
  double row(double y) const { return kHeading + (height - y) * cell; }
};

const char* class_of(DrawnBlock::Kind kind) {
  switch (kind) {
    case DrawnBlock::Kind::accepted:
      return "accepted";
    case DrawnBlock::Kind::rejected:
      return "rejected";
    case DrawnBlock::Kind::tested:
      return "tested";
    case DrawnBlock::Kind::divided:
      return "divided";
  }
  return "?";
}

// A hatching: coloured lines on a ground, turned by an angle in degrees.
void add_pattern(pugi::xml_node parent, const char* id, const char* ground, const char* line,
                 double turn) {
  constexpr double kStep = 6;
  pugi::xml_node pattern = parent.append_child("pattern");
  set(pattern, "id", std::string(id));
  set(pattern, "width", kStep);
  set(pattern, "height", kStep);
  set(pattern, "patternUnits", std::string("userSpaceOnUse"));
  set(pattern, "patternTransform", fmt::format("rotate({})", turn));
  const auto band = [&](const char* color, double height) {
    pugi::xml_node rectangle = pattern.append_child("rect");
    set(rectangle, "width", kStep);
    set(rectangle, "height", height);
    set(rectangle, "fill", std::string(color));
  };
  band(ground, kStep);
  band(line, 1.4);
}

void add_block(const Panel& panel, const DrawnBlock& block) {
  const double x = panel.column(block.x);
  const double y = panel.row(block.y + block.height);
  add_rectangle(panel.node, class_of(block.kind), x, y, block.width * panel.cell,
                block.height * panel.cell);
  const double side = std::min(block.width, block.height) * panel.cell;
  if (block.edge >= 0 && side >= kSwatch)
    add_text(panel.node, "number", x + block.width * panel.cell / 2,
             y + block.height * panel.cell / 2 + 4, std::to_string(block.edge));
}

pugi::xml_node add_dot(pugi::xml_node parent, const char* kind, double x, double y, double radius) {
  pugi::xml_node dot = parent.append_child("circle");
  set(dot, "class", std::string(kind));
  set(dot, "cx", x);
  set(dot, "cy", y);
  set(dot, "r", radius);
  return dot;
}

void add_sample(const Panel& panel, const DrawnSample& sample) {
  add_dot(panel.node, sample.covered ? "covered" : "uncovered", panel.column(sample.place.first),
          panel.row(sample.place.second), std::min(3.0, panel.cell / 6));
}

// The number of the edge from a to b, beside its middle: on the side away from the third vertex,
// unless that lies beyond the target.
void add_edge_number(const Panel& panel, std::pair<double, double> a, std::pair<double, double> b,
                     std::pair<double, double> third, std::size_t number) {
  constexpr double kRadius = 8;
  const double x = (a.first + b.first) / 2, y = (a.second + b.second) / 2;
  const double nx = b.second - a.second, ny = a.first - b.first;
  const double length = std::max(1.0, std::hypot(nx, ny));
  const bool is_inward = nx * (third.first - x) + ny * (third.second - y) > 0;
  const auto beside = [&](double distance) {
    return std::pair(std::round(x + distance * nx / length),
                     std::round(y + distance * ny / length));
  };
  const double outward = is_inward ? -kRadius * 1.5 : kRadius * 1.5;
  auto place = beside(outward);
  if (place.first < kRadius || place.first > panel.column(panel.width) - kRadius ||
      place.second < panel.row(panel.height) + kRadius || place.second > panel.row(0) - kRadius)
    place = beside(-outward);
  add_dot(panel.node, "edge", place.first, place.second, kRadius);
  add_text(panel.node, "digit", place.first, place.second + 4, std::to_string(number));
}

void add_outline(const Panel& panel, const Mark& outline) {
  std::string points;
  std::vector<std::pair<double, double>> drawn;
  for (const auto& [x, y] : outline.points) {
    drawn.emplace_back(panel.column(x), panel.row(y));
    points +=
        fmt::format("{}{},{}", points.empty() ? "" : " ", drawn.back().first, drawn.back().second);
  }
  pugi::xml_node parent = panel.node;
  pugi::xml_node polygon = parent.append_child("polygon");
  set(polygon, "class", std::string("outline"));
  set(polygon, "points", points);
  for (std::size_t i = 0; i < 3; ++i)
    add_edge_number(panel, drawn[i], drawn[(i + 1) % 3], drawn[(i + 2) % 3], i);
}

void add_panel(Panel panel, const BlocksPicture& picture, const BlocksPanel& content) {
  add_text(panel.node, "name", 0, kHeading - 8, content.name);
  add_rectangle(panel.node, "target", 0, panel.row(panel.height), panel.column(picture.width),
                panel.height * panel.cell);
  for (const DrawnBlock& block : content.blocks)
    if (block.kind != DrawnBlock::Kind::divided) add_block(panel, block);
  for (const DrawnBlock& block : content.blocks)
    if (block.kind == DrawnBlock::Kind::divided) add_block(panel, block);
  for (const DrawnSample& sample : content.samples) add_sample(panel, sample);
  Panel inside = panel;
  inside.node = panel.node.append_child("g");
  set(inside.node, "clip-path", std::string("url(#window)"));
  add_outline(inside, content.outline);
  for (std::size_t i = 0; i < content.caption.size(); ++i)
    add_text(panel.node, "name", 0, panel.row(0) + kLine * (static_cast<double>(i) + 1.1),
             content.caption[i]);
}

void add_legend(pugi::xml_node svg, double y) {
  const std::tuple<DrawnBlock::Kind, const char*, double> entries[] = {
      {DrawnBlock::Kind::accepted, "accepted whole", 128},
      {DrawnBlock::Kind::rejected, "rejected, by that edge", 168},
      {DrawnBlock::Kind::tested, "tested: full dots are covered", 0}};
  double x = kGap;
  for (const auto& [kind, words, width] : entries) {
    add_rectangle(svg, class_of(kind), x, y, kSwatch, kSwatch);
    if (kind == DrawnBlock::Kind::tested)
      add_dot(svg, "covered", x + kSwatch / 2, y + kSwatch / 2, 3);
    add_text(svg, "name", x + kSwatch + 6, y + kSwatch - 3, words);
    x += width;
  }
}

// Clips outlines to the target and a margin around it.
void add_window(pugi::xml_node definitions, double width, double height) {
  constexpr double kMargin = 12;
  pugi::xml_node window = definitions.append_child("clipPath");
  set(window, "id", std::string("window"));
  add_rectangle(window, "window", -kMargin, kHeading - kMargin, width + 2 * kMargin,
                height + 2 * kMargin);
}

}  // namespace

void write_blocks_svg(const BlocksPicture& picture, std::ostream& out) {
  const double cell = std::clamp(std::floor(kPanel / std::max(picture.width, picture.height)),
                                 kLeastCell, kMostCell);
  std::size_t lines = 0;
  for (const BlocksPanel& panel : picture.panels) lines = std::max(lines, panel.caption.size());
  const double panel_width = std::max(kLeastWide, picture.width * cell);
  const double panel_height =
      kHeading + picture.height * cell + kLine * (static_cast<double>(lines) + .5);
  const int count = static_cast<int>(picture.panels.size());
  const int columns = std::clamp(static_cast<int>((kMostWide - kGap) / (panel_width + kGap)), 1,
                                 std::max(1, count));
  const int rows = (count + columns - 1) / columns;
  const double width = std::max(kGap + columns * (panel_width + kGap), kLegend + 2 * kGap);
  const double top = kGap + kLine;
  const double legend = top + rows * (panel_height + kGap);

  pugi::xml_document document;
  pugi::xml_node svg = add_svg(document, width, legend + kSwatch + kGap);
  svg.append_child("style").text().set(kStyle);
  pugi::xml_node definitions = svg.append_child("defs");
  add_pattern(definitions, "accepted", "#cfe0f8", "#4f86d6", -45);
  add_pattern(definitions, "rejected", "#f3f1ee", "#b3aca2", 45);
  add_window(definitions, picture.width * cell, picture.height * cell);
  add_rectangle(svg, "paper", 0, 0, width, legend + kSwatch + kGap);
  add_text(svg, "title", kGap, kGap + 6, one_line(picture.title));
  for (int i = 0; i < count; ++i) {
    pugi::xml_node node = svg.append_child("g");
    set(node, "transform",
        fmt::format("translate({} {})", kGap + i % columns * (panel_width + kGap),
                    top + i / columns * (panel_height + kGap)));
    add_panel({node, cell, picture.width, picture.height}, picture,
              picture.panels[static_cast<std::size_t>(i)]);
  }
  add_legend(svg, legend);
  document.save(out, " ", pugi::format_indent | pugi::format_no_declaration);
}

}  // namespace edgecase
