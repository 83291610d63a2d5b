// SPDX-License-Identifier: MIT
#include "reports/difference_svg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string_view>
#include <tuple>

#include "reports/nodes.h"
#include "reports/picture_crop.h"
#include "reports/text.h"
#include "reports/verdict_looks.h"

namespace edgecase {
namespace {

// Layout, in SVG units.
constexpr double kPanel = 208;      // wanted size of a pane's longer side
constexpr double kLeastPane = 122;  // of the width of a pane with its title
constexpr double kLeastCell = 3;    // of a pixel's side
constexpr double kMostCell = 42;
constexpr double kGap = 14;           // around panes
constexpr double kMargin = 6;         // around the target, in which outlines still show
constexpr double kHeading = 22;       // height of a pane's title
constexpr double kNumbers = 16;       // of the columns' numbers below, the rows' at the left
constexpr double kNumbered = 14;      // least side of a pixel that has room for its number
constexpr double kLine = 16;          // from one base line to the next
constexpr double kBoldWidth = 7.4;    // of the title's letters, on average
constexpr double kLetterWidth = 6.3;  // of the caption, on average; lines are broken by it

constexpr const char* kStyle =
    "text{font:12px sans-serif;fill:#1b1f24}.title{font-weight:bold}"
    ".paper{fill:#fff}.none{fill:#fff}.once{fill:#b9d3f5}.more{fill:#5f93dc}.pale{fill:#e9eef5}"
    ".grid{fill:none;stroke:#9aa4b0;stroke-opacity:.55}"
    ".column{font-size:10px;fill:#5b6270;text-anchor:middle}"
    ".line{fill:none;stroke:#1b1f24;stroke-width:1.5;stroke-linejoin:round}.end{fill:#1b1f24}"
    ".region{fill:none;stroke:#8a4b00;stroke-width:1.2}"
    ".owned{fill:none;stroke:#8a4b00;stroke-width:2.4}"
    ".sample{fill:none;stroke:#8a4b00;stroke-width:1.4}"
    ".forbidden{fill:none;stroke:#c0182b;stroke-width:2.4}"
    ".allowed{fill:none;stroke:#6a5400;stroke-width:2.4;stroke-dasharray:4 2.5}"
    ".badge{fill:#c0182b}.badge.allowed-badge{fill:#6a5400}"
    ".sign{fill:none;stroke:#fff;stroke-width:1.8}"
    ".digit{font-weight:bold;font-size:11px;fill:#fff;text-anchor:middle}";

// Added if something is contested, in the colour of that verdict on light pages.
std::string contested_style() {
  return fmt::format(
      ".contested{{fill:none;stroke:{0};stroke-width:2.4;stroke-dasharray:1.5 2}}"
      ".badge.contested-badge{{fill:{0}}}",
      look_of(Verdict::contested).ink.light);
}

struct Panel {
  pugi::xml_node node;
  double cell = 0;
  Crop crop;
  double heading = 0;  // from the pane's upper edge to its first row of pixels
  double column(double x) const { return (x - crop.left) * cell; }
  pugi::xml_node add(const char* name) const {
    pugi::xml_node parent = node;
    return parent.append_child(name);
  }
  double row(double y) const { return heading + (crop.top - y) * cell; }
};

// The pixels with their CSS classes and a grid. `width`: pixels in a row of the target.
void add_pixels(const Panel& panel, int width, const std::vector<const char*>& kinds) {
  for (int y = panel.crop.bottom; y < panel.crop.top; ++y)
    for (int x = panel.crop.left; x < panel.crop.right; ++x)
      add_rectangle(panel.node, kinds[static_cast<std::size_t>(y * width + x)], panel.column(x),
                    panel.row(y + 1), panel.cell, panel.cell);
  std::string path;
  for (int x = panel.crop.left; x <= panel.crop.right; ++x)
    path += fmt::format("M{} {}V{}", panel.column(x), panel.row(panel.crop.bottom),
                        panel.row(panel.crop.top));
  for (int y = panel.crop.bottom; y <= panel.crop.top; ++y)
    path += fmt::format("M0 {}H{}", panel.row(y), panel.column(panel.crop.right));
  pugi::xml_node grid = panel.add("path");
  set(grid, "class", std::string("grid"));
  set(grid, "d", path);
}

// The numbers of columns and rows, if pixels are large enough.
void add_numbers(const Panel& panel) {
  if (panel.cell < kNumbered) return;
  for (int x = panel.crop.left; x < panel.crop.right; ++x)
    add_text(panel.node, "column", panel.column(x + .5),
             panel.row(panel.crop.bottom) + kNumbers - 2, std::to_string(x));
  for (int y = panel.crop.bottom; y < panel.crop.top; ++y)
    add_text(panel.node, "column", -kNumbers / 2 - 2, panel.row(y + .5) + 4, std::to_string(y));
}

void add_dot(const Panel& panel, const char* kind, std::pair<double, double> at, double radius) {
  pugi::xml_node dot = panel.add("circle");
  set(dot, "class", std::string(kind));
  set(dot, "cx", panel.column(at.first));
  set(dot, "cy", panel.row(at.second));
  set(dot, "r", radius);
}

void add_cross(const Panel& panel, std::pair<double, double> at) {
  const double x = panel.column(at.first);
  const double y = panel.row(at.second);
  const double arm = std::min(4.0, panel.cell / 4);
  pugi::xml_node cross = panel.add("path");
  set(cross, "class", std::string("sample"));
  set(cross, "d", fmt::format("M{} {}h{}m{} {}v{}", x - arm, y, 2 * arm, -arm, -arm, 2 * arm));
}

void add_outline(const Panel& panel, const char* kind, const Mark& mark) {
  std::string points;
  for (const auto& [x, y] : mark.points)
    points += fmt::format("{}{},{}", points.empty() ? "" : " ", panel.column(x), panel.row(y));
  pugi::xml_node outline = panel.add(mark.closed ? "polygon" : "polyline");
  set(outline, "class", std::string(kind));
  set(outline, "points", points);
}

// The outlines of the scene's primitives; the first position of each open one is marked.
void add_scene(const Panel& panel, const Figure& figure) {
  for (const Mark& mark : figure.marks) {
    if (mark.role != MarkRole::primitive || mark.points.empty()) continue;
    add_outline(panel, "line", mark);
    if (!mark.closed) add_dot(panel, "end", mark.points.front(), 3);
  }
}

// The geometry that the rule of a disagreement tests; add_scene has drawn the outlines.
void add_evidence(const Panel& panel, const Figure& figure) {
  for (const Mark& mark : figure.marks) {
    if (mark.points.empty()) continue;
    if (mark.role == MarkRole::region) add_outline(panel, "region", mark);
    if (mark.role == MarkRole::owned && mark.points.size() > 1) add_outline(panel, "owned", mark);
    if (mark.role == MarkRole::sample)
      for (const auto& at : mark.points) add_cross(panel, at);
  }
}

// The meaning of a pixel's sign. A pixel that is drawn more often than allowed is a duplicate, even
// if each primitive draws it once.
struct Sign {
  DisagreementKind kind = DisagreementKind::missing;
  int hits = 0;  // of a duplicate
  Legality legality = Legality::illegal;
  auto key() const { return std::tuple(kind, hits, legality); }
};

Sign sign_of(const DifferencePicture& picture, const Disagreement& d) {
  Sign sign{d.kind, 0, d.legality};
  const auto index = static_cast<std::size_t>(d.y * picture.width + d.x);
  const int hits = picture.rendered_hits[index];
  const bool is_more = hits > std::max(1, picture.exact_hits[index]);
  if (d.kind == DisagreementKind::duplicate || (d.kind == DisagreementKind::extra && is_more))
    sign = {DisagreementKind::duplicate, hits, d.legality};
  return sign;
}

// Classes of kStyle by legality, which differ in colour and dashes.
const char* frame_of(Legality legality) {
  constexpr const char* kFrames[] = {"allowed", "contested", "forbidden"};
  return kFrames[static_cast<int>(legality)];
}

const char* badge_of(Legality legality) {
  constexpr const char* kBadges[] = {"badge allowed-badge", "badge contested-badge", "badge"};
  return kBadges[static_cast<int>(legality)];
}

// A sign in a box with its upper left corner at x, y.
void add_badge(pugi::xml_node node, const Sign& sign, double x, double y, double size) {
  add_rectangle(node, badge_of(sign.legality), x, y, size, size);
  const double half = size / 2;
  const double arm = size * .32;
  if (sign.kind == DisagreementKind::duplicate) {
    add_text(node, "digit", x + half, y + half + 4, std::to_string(sign.hits));
    return;
  }
  const auto bar = [&](double below) {
    return fmt::format("M{} {}h{}", x + half - arm, y + half + below, 2 * arm);
  };
  std::string path = bar(0);
  if (sign.kind == DisagreementKind::extra)
    path += fmt::format("M{} {}v{}", x + half, y + half - arm, 2 * arm);
  if (sign.kind == DisagreementKind::value)
    path = bar(-arm / 2) + bar(arm / 2) +
           fmt::format("M{} {}L{} {}", x + half - arm / 2, y + half + arm, x + half + arm / 2,
                       y + half - arm);
  pugi::xml_node shape = node.append_child("path");
  set(shape, "class", std::string("sign"));
  set(shape, "d", path);
}

double badge_size(double cell) {
  return std::min(11.0, cell * .8);
}

void add_frames(const Panel& panel, const std::vector<Disagreement>& all) {
  const double inset = std::min(1.2, panel.cell / 8);
  for (const Disagreement& d : all)
    if (panel.crop.contains(d))
      add_rectangle(panel.node, frame_of(d.legality), panel.column(d.x) + inset,
                    panel.row(d.y + 1) + inset, panel.cell - 2 * inset, panel.cell - 2 * inset);
}

// A node in the pane's coordinates, clipped to the shown part of the target and a margin.
pugi::xml_node add_window(const Panel& panel) {
  const double left = -kMargin;
  const double top = panel.row(panel.crop.top) - kMargin;
  const double wide = panel.crop.width() * panel.cell + 2 * kMargin;
  const double high = panel.crop.height() * panel.cell + 2 * kMargin;
  pugi::xml_node window = panel.add("svg");
  set(window, "x", left);
  set(window, "y", top);
  set(window, "width", wide);
  set(window, "height", high);
  set(window, "viewBox", fmt::format("{} {} {} {}", left, top, wide, high));
  return window;
}

// The CSS class of each pixel of the target in a pane.
std::vector<const char*> pixel_kinds(const DifferencePicture& picture, Pane pane) {
  std::vector<const char*> kinds;
  kinds.reserve(picture.exact_hits.size());
  for (std::size_t i = 0; i < picture.exact_hits.size(); ++i) {
    const int exact = picture.exact_hits[i];
    const int rendered = picture.rendered_hits[i];
    const int hits = pane == Pane::exact ? exact : rendered;
    if (pane == Pane::difference)
      kinds.push_back(exact > 0 || rendered > 0 ? "pale" : "none");
    else
      kinds.push_back(hits == 0 ? "none" : hits == 1 ? "once" : "more");
  }
  return kinds;
}

void add_drawing(const Panel& panel, const DifferencePicture& picture, Pane pane) {
  add_pixels(panel, picture.width, pixel_kinds(picture, pane));
  add_frames(panel, picture.disagreements);
  Panel inside = panel;
  inside.node = add_window(panel);
  add_scene(inside, picture.figure);
  if (pane != Pane::difference) return;
  for (const Disagreement& d : picture.disagreements) add_evidence(inside, d.figure);
  for (const Disagreement& d : picture.disagreements)
    if (panel.crop.contains(d))
      add_badge(panel.node, sign_of(picture, d), panel.column(d.x), panel.row(d.y + 1),
                badge_size(panel.cell));
}

std::string title_of(const DifferencePicture& picture, Pane pane) {
  return pane == Pane::exact        ? "exact"
         : pane == Pane::difference ? "difference"
                                    : one_line(picture.renderer);
}

double cell_of(const Crop& crop) {
  const double longer = std::max(crop.width(), crop.height());
  return std::clamp(std::floor(kPanel / longer), kLeastCell, kMostCell);
}

// An SVG document of this size, and its background.
pugi::xml_node add_paper(pugi::xml_document& document, const DifferencePicture& picture,
                         double width, double height) {
  pugi::xml_node svg = add_svg(document, width, height);
  const bool is_contested =
      std::ranges::find(picture.disagreements, Legality::contested, &Disagreement::legality) !=
      picture.disagreements.end();
  const std::string style = kStyle + (is_contested ? contested_style() : "");
  svg.append_child("style").text().set(style.c_str());
  add_rectangle(svg, "paper", 0, 0, width, height);
  return svg;
}

// Breaks text at spaces into lines of at most so many bytes; a longer word has a line of its own.
std::vector<std::string> broken(const std::string& text, std::size_t most) {
  std::vector<std::string> lines(1);
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > most)
      lines.emplace_back();
    else if (!lines.back().empty())
      lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

// The disagreement in a caption: the first of the worst.
const Disagreement* first_of(const std::vector<Disagreement>& all) {
  const auto worst = std::ranges::max_element(all, {}, &Disagreement::legality);
  return worst == all.end() ? nullptr : &*worst;
}

std::string caption_of(const DifferencePicture& picture) {
  const Disagreement* d = first_of(picture.disagreements);
  if (d == nullptr) return fmt::format("{}: nothing differs.", name_of(picture.verdict));
  const std::string ruling = d->ruling > 0 ? fmt::format(", ruling {}", d->ruling) : "";
  return fmt::format("{}: pixel ({}, {}) {}, {}{}", name_of(picture.verdict), d->x, d->y,
                     name_of(d->kind), name_of(d->rule), ruling);
}

std::string describe(const Sign& sign, int count) {
  const std::string what = sign.kind == DisagreementKind::duplicate
                               ? fmt::format("drawn {} times", sign.hits)
                               : name_of(sign.kind);
  const bool is_illegal = sign.legality == Legality::illegal;
  return fmt::format("{} {}{}{}", count, what, is_illegal ? "" : ", ",
                     is_illegal ? "" : describe(sign.legality));
}

// The picture's signs, each with its meaning and count.
void add_legend(pugi::xml_node svg, const DifferencePicture& picture, double y) {
  std::map<decltype(Sign().key()), int> counts;
  for (const Disagreement& d : picture.disagreements) ++counts[sign_of(picture, d).key()];
  double x = kGap;
  for (const auto& [key, count] : counts) {
    const auto [kind, hits, legality] = key;
    const Sign sign{kind, hits, legality};
    const std::string words = describe(sign, count);
    add_badge(svg, sign, x, y - 10, 11);
    add_text(svg, "name", x + 16, y, words);
    x += 16 + kLetterWidth * static_cast<double>(words.size()) + kGap;
  }
}

}  // namespace

std::optional<Pane> pane_named(const std::string& name) {
  if (name == "exact") return Pane::exact;
  if (name == "difference") return Pane::difference;
  if (name == "renderer") return Pane::renderer;
  return std::nullopt;
}

std::vector<int> rendered_hits(const std::vector<int>& exact_hits, int width,
                               const std::vector<Disagreement>& disagreements) {
  std::vector<int> hits = exact_hits;
  for (const Disagreement& d : disagreements)
    if (d.kind != DisagreementKind::value && !d.exact.empty() && !d.rendered.empty())
      hits[static_cast<std::size_t>(d.y * width + d.x)] +=
          static_cast<int>(d.rendered.front() - d.exact.front());
  return hits;
}

void write_difference_svg(const DifferencePicture& picture, std::ostream& out) {
  const Crop crop = crop_of(picture);
  const double cell = cell_of(crop);
  const double step = kNumbers + std::max(crop.width() * cell, kLeastPane) + kGap;
  const double width = kGap + 3 * step;
  const auto letters = [&](double each) {
    return static_cast<std::size_t>((width - 2 * kGap) / each);
  };
  const std::vector<std::string> title = broken(one_line(picture.title), letters(kBoldWidth));
  const std::vector<std::string> caption = broken(caption_of(picture), letters(kLetterWidth));
  const double title_height = kLine * static_cast<double>(title.size() - 1);
  const double below = title_height + kGap + kLine + kHeading + crop.height() * cell + kNumbers;
  const double height = below + kLine * (1.5 + static_cast<double>(caption.size())) + kGap / 2;

  pugi::xml_document document;
  pugi::xml_node svg = add_paper(document, picture, width, height);
  for (std::size_t i = 0; i < title.size(); ++i)
    add_text(svg, "title", kGap, kGap + 6 + kLine * static_cast<double>(i), title[i]);
  pugi::xml_node panes = svg.append_child("g");
  set(panes, "transform",
      fmt::format("translate({} {})", kGap + kNumbers, title_height + kGap + kLine));
  double x = 0;
  for (const Pane pane : {Pane::exact, Pane::difference, Pane::renderer}) {
    pugi::xml_node node = panes.append_child("g");
    set(node, "transform", fmt::format("translate({} 0)", x));
    x += step;
    add_text(node, "name", 0, kHeading - 8, title_of(picture, pane));
    const Panel panel{node, cell, crop, kHeading};
    add_drawing(panel, picture, pane);
    add_numbers(panel);
  }
  add_legend(svg, picture, below + kLine * 1.25);
  for (std::size_t i = 0; i < caption.size(); ++i)
    add_text(svg, "name", kGap, below + kLine * (2.35 + static_cast<double>(i)), caption[i]);
  document.save(out, " ", pugi::format_indent | pugi::format_no_declaration);
}

void write_pane_svg(const DifferencePicture& picture, Pane pane, std::ostream& out) {
  const Crop crop = crop_of(picture);
  const double cell = cell_of(crop);
  pugi::xml_document document;
  pugi::xml_node svg = add_paper(document, picture, crop.width() * cell + 2 * kMargin,
                                 crop.height() * cell + 2 * kMargin);
  pugi::xml_node node = svg.append_child("g");
  set(node, "transform", fmt::format("translate({} 0)", kMargin));
  add_drawing({node, cell, crop, kMargin}, picture, pane);
  document.save(out, " ", pugi::format_indent | pugi::format_no_declaration);
}

}  // namespace edgecase
