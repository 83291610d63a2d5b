// SPDX-License-Identifier: MIT
#include "tests/reports/sample.h"
#include "tests/support/causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgecase::sample {

const std::string kHostile =
    "</script><script>alert('1')</script><!-- \"quoted\" & <b>bold</b> \xE2\x80\xAEsdrawkcab"
    " \x01 \xFF end";

namespace {

constexpr const char* kLineRule = "line.diamond-exit";
constexpr const char* kFillRule = "triangle.fill-rule";
constexpr const char* kColorRule = "attribute.smooth";

// An image with y up, black at first.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width), pixels_(static_cast<std::size_t>(4 * width * height)) {
    for (std::size_t i = 3; i < pixels_.size(); i += 4) pixels_[i] = 255;
  }
  void set(int x, int y, int red, int green, int blue) {
    const auto at = static_cast<std::size_t>(4 * (y * width_ + x));
    if (x < 0 || y < 0 || x >= width_ || at + 4 > pixels_.size()) return;
    pixels_[at] = static_cast<std::uint8_t>(red);
    pixels_[at + 1] = static_cast<std::uint8_t>(green);
    pixels_[at + 2] = static_cast<std::uint8_t>(blue);
  }
  const std::vector<std::uint8_t>& pixels() const { return pixels_; }

 private:
  int width_;
  std::vector<std::uint8_t> pixels_;
};

using Positions = std::vector<std::pair<double, double>>;

void add_outline(Figure& figure, const Positions& points, bool closed) {
  figure.marks.push_back({MarkRole::primitive, closed, points, ""});
  for (std::size_t i = 0; i < points.size(); ++i)
    figure.marks.push_back({MarkRole::vertex, false, {points[i]}, fmt::format("v{}", i)});
}

// What a line's rule looks at in one pixel.
Figure diamond_figure(int x, int y, const Positions& line) {
  const double cx = x + 0.5;
  const double cy = y + 0.5;
  Figure figure;
  figure.marks = {{MarkRole::region,
                   true,
                   {{cx - 0.5, cy}, {cx, cy - 0.5}, {cx + 0.5, cy}, {cx, cy + 0.5}},
                   ""},
                  {MarkRole::owned, false, {{cx - 0.5, cy}, {cx, cy - 0.5}, {cx + 0.5, cy}}, ""},
                  {MarkRole::owned, false, {{cx, cy - 0.5}}, "owns its lower corner"},
                  {MarkRole::edge, false, line, ""},
                  {MarkRole::sample, false, {{cx, cy}}, ""}};
  return figure;
}

Figure edge_figure(int x, int y, const Positions& edge) {
  const double cx = x + 0.5;
  const double cy = y + 0.5;
  Figure figure;
  figure.marks = {{MarkRole::edge, false, edge, "distance 0"},
                  {MarkRole::sample, false, {{cx, cy}}, ""}};
  return figure;
}

Disagreement with_figure(Disagreement d, Figure figure, const std::string& explanation) {
  d.figure = std::move(figure);
  d.explanation = explanation;
  return d;
}

CaseResults blank_case(const std::string& id, const std::string& title, int width, int height) {
  CaseResults one;
  one.id = id;
  one.title = title;
  one.why = "Each sample that lies exactly on the boundary must be decided once, by one rule.";
  one.spec = "GL 4.6 core, 14.5.1";
  one.file = "cases/" + id + ".json";
  one.surface = "fbo";
  one.width = width;
  one.height = height;
  return one;
}

Result plain(const CaseResults& one, Verdict verdict, Standing standing) {
  Result result;
  result.verdict = verdict;
  result.standing = standing;
  result.pixels = one.pixels;
  if (standing == Standing::known)
    result.standing_reason = "Mesa ends lines by its own rule (known since 22.0)";
  if (standing == Standing::unexpected) result.standing_reason = "no known fault accounts for this";
  return result;
}

Result not_run(FailureKind kind, const std::string& reason, Standing standing) {
  Result result;
  result.verdict = Verdict::not_run;
  result.failure = Failure{kind, reason};
  result.standing = standing;
  return result;
}

struct Line {
  Positions ends;
  double slope() const {
    return (ends[1].second - ends[0].second) / (ends[1].first - ends[0].first);
  }
  int row(int column) const {
    return static_cast<int>(std::floor(ends[0].second + (column + 0.5 - ends[0].first) * slope()));
  }
};

void draw_line(Canvas& canvas, const Line& line) {
  const int end = static_cast<int>(line.ends[1].first - 0.5);
  for (int x = static_cast<int>(line.ends[0].first); x <= end; ++x)
    canvas.set(x, line.row(x), 250, 250, 250);
}

// A case with one line of `width` - 3 columns; `bend` moves its far end.
CaseResults line_case(const std::string& id, const std::string& title, int width, double bend) {
  CaseResults one = blank_case(id, title, width, 16);
  one.rules = {kLineRule, "line.snap"};
  const Line line{{{1.5, 2}, {width - 2.5, 11.25 + bend}}};
  Canvas canvas(width, 16);
  draw_line(canvas, line);
  one.pixels = canvas.pixels();
  one.fragments = static_cast<std::size_t>(width - 3);
  add_outline(one.figure, line.ends, false);

  const int end = width - 3;
  Disagreement last = disagreement(end, line.row(end), DisagreementKind::extra, true);
  last = with_figure(
      last, diamond_figure(last.x, last.y, line.ends),
      fmt::format("The segment ends inside the diamond of pixel ({}, {}), 1/256 short of its "
                  "border, so it does not leave it and exact draws no fragment there; the renderer "
                  "draws one, as it does when the last pixel of a segment counts.",
                  last.x, last.y));
  last.cause = cause_named("line.diamond-exit=closed");
  Disagreement gap =
      disagreement(width / 2, line.row(width / 2), DisagreementKind::missing, bend > 2);
  gap =
      with_figure(gap, diamond_figure(gap.x, gap.y, line.ends),
                  fmt::format("The segment leaves the diamond of pixel ({}, {}) 0.0625 above its "
                              "centre, so exact draws it; the renderer leaves a gap in column {}.",
                              gap.x, gap.y, gap.x));

  Result llvmpipe = plain(one, Verdict::convention, Standing::expected);
  Canvas other = canvas;
  other.set(last.x, last.y, 250, 250, 250);
  llvmpipe.pixels = other.pixels();
  llvmpipe.disagreements = {last};
  llvmpipe.fingerprint = "1f0c77ab";
  llvmpipe.evidence = {
      {0,
       causes_named({"line.diamond-exit=closed", "line.snap=4-half-even + line.diamond-exit=open"}),
       {"8-half-even"},
       ""}};
  llvmpipe.illegal_line_snaps = {"8-half-even", "none"};

  Result softpipe = plain(one, bend > 2 ? Verdict::permitted : Verdict::violation,
                          bend > 2 ? Standing::expected : Standing::unexpected);
  other.set(gap.x, gap.y, 0, 0, 0);
  softpipe.pixels = other.pixels();
  softpipe.disagreements = {gap, last};
  softpipe.fingerprint = "93d001fe";
  softpipe.evidence = {{0, {}, {}, "r3: two fragments in column 9"}};
  one.results = {llvmpipe, softpipe, llvmpipe, softpipe};
  return one;
}

// Two triangles with a common vertical edge through pixel centres.
CaseResults shared_edge_case(const std::string& id, int size) {
  CaseResults one = blank_case(id, "Shared vertical edge through pixel centres", size, size);
  one.rules = {kFillRule};
  const int middle = size / 2;
  const double edge = middle + 0.5;
  Canvas canvas(size, size);
  for (int y = 1; y < size - 1; ++y)
    for (int x = 1; x < size - 1; ++x)
      if (std::abs(x - middle) <= y)
        canvas.set(x, y, x < middle ? 230 : 40, 120, x < middle ? 60 : 220);
  one.pixels = canvas.pixels();
  one.fragments = static_cast<std::size_t>(size * size / 2);
  const double top = size - 1;
  add_outline(one.figure, {{edge, 0.5}, {edge, top}, {1, top}}, true);
  add_outline(one.figure, {{edge, 0.5}, {top, top}, {edge, top}}, true);

  Result twice = plain(one, Verdict::violation, Standing::unexpected);
  Canvas other = canvas;
  for (int y = 2; y < size - 2; y += 3) {
    Disagreement d = disagreement(middle, y, DisagreementKind::duplicate, false);
    d.rule = rule_named(kFillRule);
    d.exact = {1};
    d.rendered = {2};
    twice.disagreements.push_back(with_figure(
        d, edge_figure(middle, y, {{edge, 0.5}, {edge, top}}),
        fmt::format("The sample at ({}, {}) lies on the common edge of primitives 0 and 1, away "
                    "from its ends; both triangles draw it, where exactly one may.",
                    edge, y + 0.5)));
    other.set(middle, y, 90, 160, 140);
  }
  twice.pixels = other.pixels();
  twice.fingerprint = "55aa";
  const Result agrees = plain(one, Verdict::agree, Standing::expected);
  one.results = {agrees, twice, agrees,
                 not_run(FailureKind::crashed, "the worker ended by signal 11 (SIGSEGV)",
                         Standing::unexpected)};
  return one;
}

ValueAggregate color_values(int size) {
  ValueAggregate values;
  values.attribute = "color";
  values.rule = rule_named(kColorRule);
  values.ruling = 9;
  values.compared = static_cast<std::uint64_t>(size * size);
  for (int x = 2; x < size - 2; ++x) values.differing.push_back({x, x / 2, 0});
  values.worst = values.differing.back();
  values.worst_component = 1;
  values.worst_exact = 0.73828125;
  values.worst_rendered = 0.73828131;
  values.components = 4 * values.compared;
  values.worst_ulp = 5.5;
  values.mean_ulp = 0.375;
  values.worst_relative = 0x1p-20;
  values.ulp_histogram = {{-1, 17}, {0, 40}, {1, 21}, {2, 3}};
  return values;
}

CaseResults smooth_case(const std::string& id, int size, int seed) {
  CaseResults one = blank_case(id, "Smooth colours over a square, correctly rounded", size, size);
  one.rules = {kColorRule};
  one.spec = "GL 4.6 core, 14.6.1";
  Canvas canvas(size, size);
  Canvas other(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int red = 255 * x / size;
      const int green = 255 * y / size;
      const int blue = (97 * seed) % 256;
      canvas.set(x, y, red, green, blue);
      other.set(x, y, red, y == x / 2 ? green + 1 : green, blue);
    }
  one.pixels = canvas.pixels();
  one.fragments = static_cast<std::size_t>(size * size);
  const double end = size;
  add_outline(one.figure, {{0, 0}, {end, 0}, {end, end}, {0, end}}, true);
  Result rounded = plain(one, Verdict::permitted, Standing::expected);
  rounded.pixels = other.pixels();
  rounded.values = {color_values(size)};
  Result wrong = plain(one, Verdict::violation, Standing::unexpected);
  Canvas bad = other;
  bad.set(3, 4, 255, 0, 255);
  wrong.pixels = bad.pixels();
  Disagreement d = disagreement(3, 4, DisagreementKind::value, false);
  d.rule = rule_named(kColorRule);
  d.ruling = 9;
  d.exact = {0.1875, 0.25, std::nan(""), 1};
  d.rendered = {1, 0, 1, 1};
  d.explanation =
      "Red is 1 where the exact value is 0.1875; the interval that the floating-point "
      "clause allows is [0.187498, 0.187502].";
  wrong.disagreements = {d};
  wrong.values = rounded.values;
  const Result agrees = plain(one, Verdict::agree, Standing::expected);
  one.results = {rounded, seed % 5 == 0 ? wrong : agrees, rounded,
                 plain(one, Verdict::agree, seed % 7 == 0 ? Standing::flake : Standing::expected)};
  return one;
}

CaseResults agreeing_case(const std::string& id, const std::string& title, int width, int height) {
  CaseResults one = blank_case(id, title, width, height);
  one.rules = {"point.square"};
  Canvas canvas(width, height);
  canvas.set(width / 2, height / 2, 255, 214, 10);
  one.pixels = canvas.pixels();
  one.fragments = 1;
  add_outline(one.figure, {{width / 2 + 0.5, height / 2 + 0.50390625}}, false);
  const Result agrees = plain(one, Verdict::agree, Standing::expected);
  one.results = {
      agrees, agrees, agrees,
      not_run(FailureKind::unsupported, "points of size 1 are not drawn here", Standing::expected)};
  return one;
}

CaseResults tiny_case() {
  CaseResults one = agreeing_case("points/one-by-one", "A target of one pixel", 1, 1);
  Result wrong = plain(one, Verdict::violation, Standing::unexpected);
  wrong.pixels = std::vector<std::uint8_t>{0, 0, 0, 255};
  Disagreement d = disagreement(0, 0, DisagreementKind::missing, false);
  d.explanation = "The point at (0.5, 0.5) covers the only pixel; nothing is drawn.";
  wrong.disagreements = {d};
  one.results[1] = wrong;
  return one;
}

CaseResults hostile_case() {
  CaseResults one = line_case("hostile/" + kHostile, kHostile, 16, 0);
  one.why = kHostile;
  one.origin = "javascript:alert('2')";
  one.tags = {kHostile};
  one.expect_failures = {kHostile};
  one.results[1].disagreements[0].explanation = kHostile;
  one.results[1].standing_reason = kHostile;
  return one;
}

std::string source_of(const CaseResults& one) {
  if (one.title == kHostile) return kHostile;
  return fmt::format(R"({{"title": "{}", "target": {{"width": {}, "height": {}}}, "draws": []}})",
                     one.title, one.width, one.height);
}

RendererInfo renderer(const std::string& name, const std::string& device) {
  return {name, "Mesa", "4.5 (Core Profile) Mesa 22.3.6", device, 8, {{"glsl", "450"}}};
}

}  // namespace

Disagreement disagreement(int x, int y, DisagreementKind kind, bool legal) {
  Disagreement d;
  d.x = x;
  d.y = y;
  d.primitive = 0;
  d.kind = kind;
  d.rule = rule_named(kLineRule);
  d.legality = by_letter(legal);
  d.ruling = legal ? 2 : 1;
  d.exact = {kind == DisagreementKind::missing ? 1.0 : 0.0};
  d.rendered = {kind == DisagreementKind::missing ? 0.0 : 1.0};
  d.explanation = fmt::format("Pixel ({}, {}) differs.", x, y);
  return d;
}

Results results() {
  Results results;
  results.tool = "edgecase 0.1.0";
  results.policy = "opengl";
  const std::string llvmpipe = "llvmpipe (LLVM 15.0.6, 256 bits)";
  results.renderers = {renderer("osmesa:llvmpipe", llvmpipe),
                       renderer("osmesa:softpipe", "softpipe"), renderer("egl:llvmpipe", llvmpipe),
                       renderer("egl:softpipe", "softpipe")};
  results.diagnostics = {
      {"cases/lines/broken.json", 12, "/draws/0/vertices/1/0", "0.1 is not a multiple of 2^-16",
       "write \"6553/65536\" or \"6554/65536\", or \"~0.1\" for the nearest"},
      {"cases/lines/broken.json", 20, "/targte", "unknown key \"targte\"", "did you mean target?"},
      {"cases/" + kHostile + ".json", 0, "", kHostile, ""}};
  std::vector<CaseResults> cases;
  for (int i = 0; i < 16; ++i)
    cases.push_back(line_case(fmt::format("lines/octant-{:02}", i),
                              fmt::format("Line whose end moves by {}/4", i), 16, i / 4.0));
  for (int i = 0; i < 14; ++i)
    cases.push_back(smooth_case(fmt::format("values/smooth-{:02}", i), 16 + 2 * i, i));
  for (int i = 0; i < 20; ++i)
    cases.push_back(agreeing_case(fmt::format("points/tie-{:02}", i),
                                  fmt::format("Point {}/256 above a centre", i), 8, 8));
  for (int i = 0; i < 6; ++i)
    cases.push_back(shared_edge_case(fmt::format("triangles/shared-edge-{}", i), 8 + 4 * i));
  cases.push_back(line_case("lines/wide", "A line over 64 columns", 64, 0));
  cases.push_back(agreeing_case("points/four-pixels", "A target of four pixels", 2, 2));
  cases.push_back(tiny_case());
  cases.push_back(hostile_case());
  for (CaseResults& one : ramp_cases()) cases.push_back(std::move(one));
  cases.push_back(multisampled_case());
  cases[3].origin = "https://gitlab.example.org/mesa/-/issues/1";
  cases[3].expect_failures = {
      "cases/lines/octant-03.json:14: /expect/0/coverage: row 5 has one hit at column 7"};
  std::ranges::sort(cases, {}, &CaseResults::id);
  for (const CaseResults& one : cases) results.cases.push_back(one);
  return results;
}

ReportTexts texts() {
  ReportTexts texts;
  const auto rule = [](auto... words) { return RuleText{words..., {}}; };
  texts.rules = {
      rule(kLineRule, "Lines leave diamonds", "GL 4.6 core, 14.5.1",
           "An implementation may deviate by one unit, and by one fragment.", "left-bottom"),
      rule(kFillRule, "A sample on an edge", "14.6.1", "Which of the two is open.", "left-top"),
      rule(kColorRule, "Interpolated colours", "GL 4.6 core, 2.3.4", "About 1 part in 10^5.", "")};
  texts.rulings = {{1, "Each fragment has one of exact within a unit.", {{"Text", kHostile}}},
                   {2, "The number of fragments differs by at most one.", {}},
                   {9, "Values inside the interval are permitted. " + kHostile, {}}};
  texts.is_open_choice = [](const Cause& cause) { return cause == "line.diamond-exit=closed"; };
  texts.source_of = source_of;
  return texts;
}

}  // namespace edgecase::sample
