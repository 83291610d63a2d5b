// SPDX-License-Identifier: MIT
#include "reports/difference_svg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string_view>
#include <tuple>

#include "reports/svg_nodes.h"
#include "reports/text.h"

namespace edgecase {
namespace {

// Layout, in SVG units.
constexpr double kPanel = 208;    // wanted size of a panel's longer side
constexpr double kLeastCell = 3;  // of a pixel's side
constexpr double kMostCell = 52;
constexpr double kGap = 14;           // around panels
constexpr double kMargin = 6;         // around the target, in which outlines still show
constexpr double kHeading = 22;       // height of a panel's title
constexpr double kLine = 16;          // from one base line to the next
constexpr double kBoldWidth = 7.4;    // of the title's letters, on average
constexpr double kLetterWidth = 6.3;  // of the caption, on average; lines are broken by it

constexpr const char* kStyle =
    "text{font:12px sans-serif;fill:#1b1f24}.title{font-weight:bold}"
    ".paper{fill:#fff}.none{fill:#fff}.once{fill:#b9d3f5}.more{fill:#5f93dc}"
    ".grid{fill:none;stroke:#9aa4b0;stroke-opacity:.55}"
    ".line{fill:none;stroke:#1b1f24;stroke-width:1.5;stroke-linejoin:round}.end{fill:#1b1f24}"
    ".region{fill:none;stroke:#8a4b00;stroke-width:1.2}"
    ".owned{fill:none;stroke:#8a4b00;stroke-width:2.4}"
    ".sample{fill:none;stroke:#8a4b00;stroke-width:1.4}"
    ".forbidden{fill:none;stroke:#c0182b;stroke-width:2.4}"
    ".allowed{fill:none;stroke:#6a5400;stroke-width:2.4;stroke-dasharray:4 2.5}"
    ".contested{fill:none;stroke:#7a2fa0;stroke-width:2.4;stroke-dasharray:1.5 2}"
    ".badge{fill:#c0182b}.badge.contested-badge{fill:#7a2fa0}.badge.allowed-badge{fill:#6a5400}"
    ".sign{fill:none;stroke:#fff;stroke-width:1.8}"
    ".digit{font-weight:bold;font-size:11px;fill:#fff;text-anchor:middle}";

struct Panel {
  pugi::xml_node node;
  double cell = 0;
  int height = 0;  // pixels
  double column(double x) const { return x * cell; }
  pugi::xml_node add(const char* name) const {
    pugi::xml_node parent = node;
    return parent.append_child(name);
  }
  double row(double y) const { return kHeading + (height - y) * cell; }
};

void add_pixels(const Panel& panel, int width, const std::vector<int>& hits) {
  for (int y = 0; y < panel.height; ++y)
    for (int x = 0; x < width; ++x) {
      const int count = hits[static_cast<std::size_t>(y * width + x)];
      const char* kind = count == 0 ? "none" : count == 1 ? "once" : "more";
      add_rectangle(panel.node, kind, panel.column(x), panel.row(y + 1), panel.cell, panel.cell);
    }
  std::string path;
  for (int x = 0; x <= width; ++x)
    path += fmt::format("M{} {}V{}", panel.column(x), panel.row(0), panel.row(panel.height));
  for (int y = 0; y <= panel.height; ++y)
    path += fmt::format("M0 {}H{}", panel.row(y), panel.column(width));
  pugi::xml_node grid = panel.add("path");
  set(grid, "class", std::string("grid"));
  set(grid, "d", path);
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

// What the rule of a disagreement looks at. The scene has its outlines already.
void add_evidence(const Panel& panel, const Figure& figure) {
  for (const Mark& mark : figure.marks) {
    if (mark.points.empty()) continue;
    if (mark.role == MarkRole::region) add_outline(panel, "region", mark);
    if (mark.role == MarkRole::owned && mark.points.size() > 1) add_outline(panel, "owned", mark);
    if (mark.role == MarkRole::sample)
      for (const auto& at : mark.points) add_cross(panel, at);
  }
}

// What a pixel's sign says. A pixel that is drawn more often than it may is a duplicate, also where
// each single primitive draws it once.
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

// Classes of kStyle, by legality: colour and dashes tell them apart.
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
    add_rectangle(panel.node, frame_of(d.legality), panel.column(d.x) + inset,
                  panel.row(d.y + 1) + inset, panel.cell - 2 * inset, panel.cell - 2 * inset);
}

// A node in the panel's coordinates that shows nothing far outside the target.
pugi::xml_node add_window(const Panel& panel, int width) {
  const double left = -kMargin;
  const double top = panel.row(panel.height) - kMargin;
  const double wide = panel.column(width) + 2 * kMargin;
  const double high = panel.height * panel.cell + 2 * kMargin;
  pugi::xml_node window = panel.add("svg");
  set(window, "x", left);
  set(window, "y", top);
  set(window, "width", wide);
  set(window, "height", high);
  set(window, "viewBox", fmt::format("{} {} {} {}", left, top, wide, high));
  return window;
}

void add_panel(pugi::xml_node svg, const DifferencePicture& picture, double cell, bool is_exact) {
  pugi::xml_node node = svg.append_child("g");
  set(node, "transform",
      fmt::format("translate({} {})", is_exact ? kGap : 2 * kGap + picture.width * cell,
                  kGap + kLine));
  const Panel panel{node, cell, picture.height};
  add_text(node, "name", 0, kHeading - 8, is_exact ? "exact" : one_line(picture.renderer));
  add_pixels(panel, picture.width, is_exact ? picture.exact_hits : picture.rendered_hits);
  add_frames(panel, picture.disagreements);
  Panel inside = panel;
  inside.node = add_window(panel, picture.width);
  add_scene(inside, picture.figure);
  for (const Disagreement& d : picture.disagreements) add_evidence(inside, d.figure);
  if (is_exact) return;
  for (const Disagreement& d : picture.disagreements)
    add_badge(node, sign_of(picture, d), panel.column(d.x), panel.row(d.y + 1), badge_size(cell));
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

// The disagreement that a caption names: the first of the worst.
const Disagreement* first_of(const std::vector<Disagreement>& all) {
  const auto worst = std::ranges::max_element(all, {}, &Disagreement::legality);
  return worst == all.end() ? nullptr : &*worst;
}

std::string caption_of(const DifferencePicture& picture) {
  const Disagreement* d = first_of(picture.disagreements);
  if (d == nullptr) return fmt::format("{}: nothing differs.", name_of(picture.verdict));
  const std::string ruling = d->ruling > 0 ? fmt::format(", ruling {}", d->ruling) : "";
  return fmt::format("{}: pixel ({}, {}) {}, {}{}", name_of(picture.verdict), d->x, d->y,
                     name_of(d->kind), d->rule, ruling);
}

std::string words_of(const Sign& sign, int count) {
  const std::string what = sign.kind == DisagreementKind::duplicate
                               ? fmt::format("drawn {} times", sign.hits)
                               : name_of(sign.kind);
  const bool is_illegal = sign.legality == Legality::illegal;
  return fmt::format("{} {}{}{}", count, what, is_illegal ? "" : ", ",
                     is_illegal ? "" : describe(sign.legality));
}

// The signs that the picture has, each with its meaning and how often it occurs.
void add_legend(pugi::xml_node svg, const DifferencePicture& picture, double y) {
  std::map<decltype(Sign().key()), int> counts;
  for (const Disagreement& d : picture.disagreements) ++counts[sign_of(picture, d).key()];
  double x = kGap;
  for (const auto& [key, count] : counts) {
    const auto [kind, hits, legality] = key;
    const Sign sign{kind, hits, legality};
    const std::string words = words_of(sign, count);
    add_badge(svg, sign, x, y - 10, 11);
    add_text(svg, "name", x + 16, y, words);
    x += 16 + kLetterWidth * static_cast<double>(words.size()) + kGap;
  }
}

}  // namespace

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
  const double longer = std::max(picture.width, picture.height);
  const double cell = std::clamp(std::floor(kPanel / longer), kLeastCell, kMostCell);
  const double width = std::max(3 * kGap + 2 * picture.width * cell, 2 * kPanel + 3 * kGap);
  const auto letters = [&](double each) {
    return static_cast<std::size_t>((width - 2 * kGap) / each);
  };
  const std::vector<std::string> title = broken(one_line(picture.title), letters(kBoldWidth));
  const std::vector<std::string> caption = broken(caption_of(picture), letters(kLetterWidth));
  const double title_height = kLine * static_cast<double>(title.size() - 1);
  const double below = title_height + kGap + kLine + kHeading + picture.height * cell;
  const double height = below + kLine * (1.5 + static_cast<double>(caption.size())) + kGap / 2;

  pugi::xml_document document;
  pugi::xml_node svg = document.append_child("svg");
  set(svg, "xmlns", std::string("http://www.w3.org/2000/svg"));
  set(svg, "width", width);
  set(svg, "height", height);
  set(svg, "viewBox", fmt::format("0 0 {} {}", width, height));
  svg.append_child("style").text().set(kStyle);
  add_rectangle(svg, "paper", 0, 0, width, height);
  for (std::size_t i = 0; i < title.size(); ++i)
    add_text(svg, "title", kGap, kGap + 6 + kLine * static_cast<double>(i), title[i]);
  pugi::xml_node panels = svg.append_child("g");
  set(panels, "transform", fmt::format("translate(0 {})", title_height));
  add_panel(panels, picture, cell, true);
  add_panel(panels, picture, cell, false);
  add_legend(svg, picture, below + kLine * 1.25);
  for (std::size_t i = 0; i < caption.size(); ++i)
    add_text(svg, "name", kGap, below + kLine * (2.35 + static_cast<double>(i)), caption[i]);
  document.save(out, " ", pugi::format_indent | pugi::format_no_declaration);
}

}  // namespace edgecase
