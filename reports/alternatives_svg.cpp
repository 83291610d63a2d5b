// SPDX-License-Identifier: MIT
#include "reports/alternatives_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <pugixml.hpp>

#include "reports/nodes.h"

namespace edgecase {
namespace {

// Layout, in SVG units.
constexpr int kCell = 20;   // one pixel
constexpr int kTitle = 22;  // height of a panel's title
constexpr int kGap = 16;    // around panels
constexpr int kMostWide = 760;

constexpr const char* kStyle =
    "text{font:13px sans-serif;fill:#1b1f24}"
    ".paper{fill:#fff}.pixel{fill:#fff;stroke:#c8ccd2;stroke-width:1}"
    ".drawn{fill:#7aa7e9;stroke:#c8ccd2;stroke-width:1}"
    ".line{fill:none;stroke:#b3541e;stroke-width:2}.end{fill:#b3541e}";

void add_pixels(pugi::xml_node panel, const AlternativesPicture& picture,
                const DrawnAlternative& alternative) {
  auto hits = alternative.hits.begin();
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      add_rectangle(panel, *hits++ > 0 ? "drawn" : "pixel", x * kCell,
                    kTitle + (picture.height - 1 - y) * kCell, kCell, kCell);
}

// The outlines of the figure's primitives; the first position of each is marked as the start.
void add_outlines(pugi::xml_node panel, const AlternativesPicture& picture) {
  const auto column = [](double x) { return x * kCell; };
  const auto row = [&](double y) { return kTitle + (picture.height - y) * kCell; };
  for (const Mark& mark : picture.figure.marks) {
    if (mark.role != MarkRole::primitive || mark.points.empty()) continue;
    std::string points;
    for (const auto& [x, y] : mark.points) points += fmt::format("{},{} ", column(x), row(y));
    pugi::xml_node outline = panel.append_child(mark.closed ? "polygon" : "polyline");
    set(outline, "class", std::string("line"));
    set(outline, "points", points);
    pugi::xml_node start = panel.append_child("circle");
    set(start, "class", std::string("end"));
    set(start, "cx", column(mark.points.front().first));
    set(start, "cy", row(mark.points.front().second));
    set(start, "r", 4);
  }
}

}  // namespace

void write_alternatives_svg(const AlternativesPicture& picture, std::ostream& out) {
  const int panel_width = picture.width * kCell;
  const int panel_height = kTitle + picture.height * kCell;
  const int columns = std::max(1, (kMostWide - kGap) / (panel_width + kGap));
  const int count = static_cast<int>(picture.alternatives.size());
  const int rows = (count + columns - 1) / columns;

  pugi::xml_document document;
  const double width = kGap + std::min(columns, count) * (panel_width + kGap);
  const double height = kGap + rows * (panel_height + kGap);
  pugi::xml_node svg = add_svg(document, width, height);
  svg.append_child("style").text().set(kStyle);
  add_rectangle(svg, "paper", 0, 0, width, height);
  for (int i = 0; i < count; ++i) {
    const DrawnAlternative& alternative = picture.alternatives[static_cast<std::size_t>(i)];
    pugi::xml_node panel = svg.append_child("g");
    set(panel, "transform",
        fmt::format("translate({} {})", kGap + i % columns * (panel_width + kGap),
                    kGap + i / columns * (panel_height + kGap)));
    pugi::xml_node title = panel.append_child("text");
    set(title, "x", 0);
    set(title, "y", kTitle - 8);
    title.text().set(alternative.name.c_str());
    add_pixels(panel, picture, alternative);
    add_outlines(panel, picture);
  }
  document.save(out, " ", pugi::format_indent | pugi::format_no_declaration);
}

}  // namespace edgecase
