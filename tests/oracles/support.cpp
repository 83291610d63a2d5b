// SPDX-License-Identifier: MIT
#include "tests/oracles/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/numeral.h"
#include "rules/rule.h"

namespace edgecase {
namespace {

LineChoice choice_of(const LineScene& scene) {
  return {scene.algorithm, find_diamond_boundary(scene.boundary), scene.wide};
}

std::string list(const std::vector<PixelPosition>& pixels) {
  std::string text;
  for (PixelPosition p : pixels) text += fmt::format(" ({}, {})", p.x, p.y);
  return text;
}

bool is_area(const LineScene& scene) {
  if (scene.width != Fixed::from_integer(1) && scene.wide != WideLine::replicate) return true;
  return scene.algorithm == LineAlgorithm::rectangle ||
         scene.algorithm == LineAlgorithm::parallelogram;
}

// Whether the ownership of a diamond's boundary matters to the algorithm.
bool tests_diamonds(LineAlgorithm algorithm) {
  return algorithm == LineAlgorithm::diamond_exit || algorithm == LineAlgorithm::walk_ends_tested;
}

}  // namespace

void Tally::add(const Tally& other) {
  scenes += other.scenes;
  decisions += other.decisions;
  tied += other.tied;
}

void Tally::print(const char* what) const {
  fmt::print("{}: compared {} scenes, {} decisions, {} tied scenes ({:.1f} %)\n", what, scenes,
             decisions, tied, 100.0 * static_cast<double>(tied) / static_cast<double>(scenes));
}

std::string describe(const Segment& segment) {
  return format_point(segment.a) + " to " + format_point(segment.b);
}

std::string describe(const LineScene& scene) {
  return fmt::format("{} from {}, width {} ({}), diamonds {}, areas {}", name_of(scene.algorithm),
                     describe(scene.segment), to_decimal(scene.width), name_of(scene.wide),
                     scene.boundary, scene.ties);
}

oracle::Line oracle_line(const Segment& segment) {
  return {oracle::spot(segment.a), oracle::spot(segment.b)};
}

std::vector<PixelPosition> our_pixels(const LineScene& scene, const PixelBounds& window) {
  auto pixels =
      line_pixels(scene.segment, scene.width, window, choice_of(scene), *find_tie_rule(scene.ties));
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

std::vector<PixelPosition> oracle_pixels(const LineScene& scene, const PixelBounds& window) {
  oracle::LineQuestion question;
  question.line = oracle_line(scene.segment);
  question.width = oracle::Rational(scene.width);
  question.algorithm = scene.algorithm;
  question.wide = scene.wide;
  question.boundary = oracle::boundary_named(scene.boundary);
  question.ties = oracle::ties_named(scene.ties);
  return oracle::line_pixels(question, window);
}

bool is_tied(const LineScene& scene, const PixelBounds& window) {
  if (is_area(scene) || scene.algorithm == LineAlgorithm::diamond_exit) {
    LineScene open = scene;
    LineScene closed = scene;
    open.boundary = open.ties = "open";
    closed.boundary = closed.ties = "closed";
    return our_pixels(open, window) != our_pixels(closed, window);
  }
  oracle::LineQuestion question;
  question.line = oracle_line(lowest_segment(scene.segment, rounded_width(scene.width)));
  question.algorithm = scene.algorithm;
  return oracle::hangs_on_convention(question, window);
}

bool agrees(const LineScene& scene, const PixelBounds& window, Tally& tally) {
  const auto ours = our_pixels(scene, window);
  const auto theirs = oracle_pixels(scene, window);
  ++tally.scenes;
  tally.decisions += long{window.x_max - window.x_min + 1} * (window.y_max - window.y_min + 1);
  tally.tied += is_tied(scene, window) ? 1 : 0;
  EXPECT_EQ(ours, theirs) << describe(scene) << "\nours:  " << list(ours)
                          << "\noracle:" << list(theirs);
  return ours == theirs;
}

std::vector<Point> grid(std::int64_t low, std::int64_t high, std::int64_t step) {
  std::vector<Point> points;
  for (std::int64_t y = low; y <= high; y += step)
    for (std::int64_t x = low; x <= high; x += step)
      points.push_back({Fixed::from_raw(x), Fixed::from_raw(y)});
  return points;
}

std::vector<LineScene> thin_line_kinds() {
  std::vector<LineScene> kinds;
  for (LineAlgorithm algorithm : values_of<LineAlgorithm>()) {
    // Decided in single precision: tests/rules/coverage/line_tested_ends_test.cpp.
    if (algorithm == LineAlgorithm::parallelogram_ends_tested) continue;
    LineScene kind;
    kind.algorithm = algorithm;
    if (tests_diamonds(algorithm)) {
      for (const DiamondBoundary& boundary : all_diamond_boundaries()) {
        kind.boundary = boundary.name;
        kinds.push_back(kind);
      }
    } else if (is_area(kind)) {
      for (const TieRule& ties : all_tie_rules()) {
        kind.ties = ties.name;
        kinds.push_back(kind);
      }
    } else {
      kinds.push_back(kind);
    }
  }
  return kinds;
}

}  // namespace edgecase
