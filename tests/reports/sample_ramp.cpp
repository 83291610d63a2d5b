// SPDX-License-Identifier: MIT
//
// Cases with ramps: renderers that tell levels of detail along a row of pixels.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "tests/reports/sample.h"
#include "tests/support/causes.h"

namespace edgecase::sample {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Ramp = std::vector<Result::LevelPoint>;

CaseResults strip_case(const std::string& id, const std::string& title, int width) {
  CaseResults one;
  one.id = id;
  one.title = title;
  one.why = "Level of detail is the logarithm of a scale factor, of which little is laid down.";
  one.rules = {"texture.scale-factor"};
  one.spec = "GL 4.6 core, 8.14.1";
  one.file = "cases/" + id + ".json";
  one.surface = "fbo";
  one.width = width;
  one.height = 1;
  one.fragments = static_cast<std::size_t>(width);
  std::vector<std::uint8_t> pixels;
  for (int x = 0; x < width; ++x) {
    const auto grey = static_cast<std::uint8_t>(255 * x / width);
    for (int c = 0; c < 4; ++c) pixels.push_back(c < 3 ? grey : 255);
  }
  one.pixels = pixels;
  return one;
}

Result told(const CaseResults& one, Verdict verdict, Ramp ramp) {
  Result result;
  result.verdict = verdict;
  result.pixels = one.pixels;
  result.ramp = std::move(ramp);
  return result;
}

// A disagreement for each point that is beyond the band.
Result convicted(const CaseResults& one, Ramp ramp) {
  Result result = told(one, Verdict::violation, std::move(ramp));
  for (const Result::LevelPoint& p : result.ramp) {
    if (p.low <= p.rendered && p.rendered <= p.high) continue;
    Disagreement d = disagreement(p.x, p.y, DisagreementKind::value, false);
    d.rule = rule_named("texture.scale-factor");
    d.exact = {std::floor(p.exact), p.exact};
    d.rendered = {std::floor(p.rendered), p.rendered};
    d.explanation =
        fmt::format("The level of detail at pixel ({}, {}) is exactly {}.", p.x, p.y, p.exact);
    result.disagreements.push_back(d);
  }
  result.fingerprint = "9e37";
  return result;
}

// A straight line between powers of two, up to 0.0861 of a level too low.
double coarse_log2(double value) {
  const double whole = std::floor(std::log2(value));
  return whole + value / std::exp2(whole) - 1;
}

// Along an axis of the texture: a thin band.
CaseResults axis_case() {
  CaseResults one = strip_case("textures/ramp-along-s", "Scale factors of 1/2 to 64 along s", 256);
  Ramp exact, coarse, stepped;
  for (int x = 0; x < one.width; ++x) {
    const double scale = std::exp2(-1 + 7 * (x + 0.5) / one.width);
    const double level = std::log2(scale);
    exact.push_back({x, 0, level, level - 1e-5, level + 1e-5, level});
    coarse.push_back({x, 0, level, level - 0.125, level + 0.125, coarse_log2(scale)});
    stepped.push_back({x, 0, level, level - 0.125, level + 0.125, std::round(4 * level) / 4});
  }
  one.results = {told(one, Verdict::permitted, coarse), told(one, Verdict::agree, exact),
                 told(one, Verdict::permitted, coarse), told(one, Verdict::permitted, stepped)};
  return one;
}

// At an angle: a broad band, one renderer that leaves it, one that tells nothing.
CaseResults angle_case() {
  CaseResults one =
      strip_case("textures/ramp-at-an-angle", "Scale factors of both axes, at an angle", 64);
  Ramp sum, largest, wild;
  for (int x = 0; x < one.width; ++x) {
    const double level = 3 * std::sin(0.08 * x);
    const Result::LevelPoint point{x, 0, level, level - 0.5, level + 0.5, level};
    for (Ramp* ramp : {&sum, &largest, &wild}) ramp->push_back(point);
    sum.back().rendered += 0.4 * std::sin(0.3 * x);
    largest.back().rendered -= x % 2 == 0 ? 0.25 : 0.2;
    wild.back().rendered += 0.9 * std::sin(0.2 * x);
  }
  wild[20].rendered = kNaN;
  wild[40].rendered = kInfinity;
  wild[41].rendered = -127;
  Result failed;
  failed.verdict = Verdict::not_run;
  failed.failure = Failure{FailureKind::unsupported, "textures are not drawn here"};
  one.results = {told(one, Verdict::permitted, sum), convicted(one, wild),
                 told(one, Verdict::permitted, largest), failed};
  return one;
}

// Where the texture stands still its level is infinitely low; two columns have no fragment.
CaseResults still_case() {
  CaseResults one = strip_case("textures/ramp-standing-still", "A texture that stands still", 16);
  Ramp right, least;
  for (int x = 0; x < one.width; ++x) {
    if (x == 11 || x == 12) continue;
    const bool still = x >= 4 && x < 8;
    const double level = still ? -kInfinity : std::log2(0.25 * (x + 1));
    right.push_back({x, 0, level, still ? level : level - 0.1, level + 0.1, level});
    least.push_back(right.back());
    if (still) least.back().rendered = -126;
  }
  one.results = {told(one, Verdict::agree, right), convicted(one, least),
                 told(one, Verdict::agree, right), told(one, Verdict::agree, right)};
  return one;
}

}  // namespace

std::vector<CaseResults> ramp_cases() {
  return {axis_case(), angle_case(), still_case()};
}

}  // namespace edgecase::sample
