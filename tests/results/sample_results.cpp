// SPDX-License-Identifier: MIT
#include "tests/results/sample_results.h"
#include "tests/support/causes.h"

#include <limits>

namespace edgecase {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Quotes, controls, markup, separators and letters beyond ASCII.
const char* const kHostile = "\"\\/\b\f\n\r\t\x01 </script> \u2028 ]]> é 漢 \U0001F600";

Figure figure() {
  return {{{MarkRole::primitive, true, {{0.5, -3}, {1.0 / 3, 1e-300}, {-kInfinity, -0.0}}, "0"},
           {MarkRole::edge, false, {}, kHostile},
           {MarkRole::snapped_vertex, false, {{8192, -8192}}, ""}}};
}

// Of a picture of two pixels.
SampleImage samples() {
  SampleImage image;
  image.samples = 2;
  image.positions = {centre_of_pixel(), {Fixed::from_raw(1), Fixed::from_raw(Fixed::kOne - 1)}};
  std::vector<std::uint8_t> pixels;
  for (std::uint8_t i = 0; i < 16; ++i) pixels.push_back(static_cast<std::uint8_t>(16 * i));
  image.pixels = pixels;
  image.hits = std::vector<std::uint32_t>{0, 1, 7, 4294967295U};
  image.coverage = std::vector<std::uint32_t>{0, 3};
  return image;
}

Disagreement disagreement() {
  Disagreement d;
  d.x = 3;
  d.y = 1;
  d.sample = 2;
  d.primitive = 4;
  d.kind = DisagreementKind::value;
  d.rule = rule_named("attribute.smooth");
  d.legality = Legality::legal;
  d.cause = cause_named("triangle.fill-rule=left-bottom + triangle.snap=8-half-up");
  d.situation = kHostile;
  d.ruling = 9;
  d.upright = Disagreement::Upright{RuleId::triangle_fill_rule, 4, Legality::contested,
                                    cause_named("triangle.fill-rule=open")};
  d.exact = {0.1, 1.0 / 3, -0.0, 5e-324};
  d.rendered = {kNaN, kInfinity, -kInfinity, 1.7976931348623157e308};
  d.explanation = kHostile;
  d.figure = figure();
  return d;
}

ValueAggregate aggregate() {
  ValueAggregate values;
  values.attribute = "color";
  values.rule = rule_named("attribute.smooth");
  values.ruling = 9;
  values.cause = cause_named("texture.log2=mantissa-8");
  values.compared = 123456789012345;
  values.differing = {{1, 2, 0}, {3, 1, -1}};
  values.worst = {3, 1, -1};
  values.worst_component = 2;
  values.worst_exact = 0.1;
  values.worst_rendered = kNaN;
  values.components = 4 * values.compared;
  values.worst_ulp = kInfinity;
  values.mean_ulp = 0.25;
  values.worst_relative = 1e-7;
  values.ulp_histogram = {{-1074, 1}, {-1, 7}, {0, 9000000000}, {12, 3}};
  return values;
}

// With and without what a renderer need not tell.
std::vector<Result::ReportedFragment> fragments() {
  std::vector<Result::ReportedFragment> told(3);
  told[0].fragment = {1, 0, 4, 0xffffffffU, 1.0 / 3, {0.1, -0.0, kInfinity, 5e-324}};
  told[1].fragment = {1, 0, 5, 1, kNaN, {}, true, false};
  told[2].fragment = {0, 0, 4, 3, 0, {kNaN, 1, 1, 1}, false};
  told[2].pass = 7;
  return told;
}

Result full_result() {
  Result result;
  result.verdict = Verdict::permitted;
  result.fingerprint = "0123456789abcdef";
  result.answer_digest = 0xfedcba9876543210;
  result.images = {5, 1};
  PlaceCells cells;
  cells.add(0.375, 0.125);
  result.shown = {{{SingleThing::Kind::offset_unit, 16, 0}, 1.0 / 65536, 1.0 / 3},
                  {{SingleThing::Kind::sample_cells, 4, 2}, 0, 0, cells}};
  result.disagreements = {disagreement(), Disagreement{}};
  result.values = {aggregate()};
  result.evidence = {{4,
                      causes_named({"line.snap=none", "line.snap=none + line.algorithm=bresenham"}),
                      {"none", "8-half-even"},
                      "column 3 holds two",
                      7},
                     {},
                     {-1, causes_named({"window.origin"}), {}, "", -1}};
  result.illegal_line_snaps = {"none", "8-truncate"};
  result.refuted.add(cause_named("line.snap=none").parts[0]);
  result.refuted.add({RuleId::window_origin});
  result.pixel_counts = {{1, 2, 3, 4, 5}};
  result.ramp = {{0, 0, 0.1, -0.0, 1.0 / 3, 5e-324},
                 {1, 0, -kInfinity, -kInfinity, kInfinity, kNaN},
                 {1, 3, kNaN, kNaN, kNaN, 1.7976931348623157e308}};
  result.exact_fragments = fragments();
  result.rendered_fragments = {fragments()[1]};
  result.pixels = std::vector<std::uint8_t>{9, 8, 7, 6, 5, 4, 3, 255};
  result.samples = samples();
  result.samples.coverage = {};
  result.exact_samples = samples();
  result.exact_samples.positions.clear();
  result.exact_pixels = std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8};
  result.standing = Standing::flake;
  result.standing_reason = kHostile;
  result.faults = {"fill", kHostile};
  result.again = {Verdict::agree, ""};
  return result;
}

Result failed() {
  Result result;
  result.failure = Failure{FailureKind::timed_out, kHostile};
  result.fingerprint = "timed-out";
  result.standing = Standing::unexpected;
  result.standing_reason = "none";
  return result;
}

CaseResults full_case(const std::string& id) {
  CaseResults one;
  one.id = id;
  one.title = kHostile;
  one.why = "why";
  one.rules = {"line.diamond-exit", "attribute.flat"};
  one.spec = "GL 4.6 core, 14.5.1";
  one.origin = "https://example.org/?a=1&b=<2>";
  one.tags = {"smoke", "long"};
  one.file = "cases/a b.json";
  one.file_digest = "00000000000000ff";
  one.surface = "fbo";
  one.width = 2;
  one.height = 1;
  one.viewport = Viewport{-3, 0, 8, 16};
  one.pixels = std::vector<std::uint8_t>{0, 1, 2, 255, 16, 32, 64, 128};
  one.samples = samples();
  one.fragments = 17;
  one.figure = figure();
  one.expect_failures = {"a:7: /expect/0", kHostile};
  return one;
}

}  // namespace

Results full_results() {
  Results results;
  results.tool = "edgecase 0.1.0";
  results.policy = "opengl";
  results.latitude = Latitude::none;
  results.policy_digest = "0011223344556677";
  results.interrupted = true;
  results.left_out = 12;
  results.whole_suite = true;
  results.shard = {2, 4, 123, "8899aabbccddeeff"};
  results.faults = {
      {"osmesa:llvmpipe", "fill", kHostile, "https://example.org", 7, 6, FaultState::grown},
      {"exec:./a \"b\"", kHostile, "why", "", 0, std::nullopt, FaultState::fixed}};
  results.renderers = {
      {"osmesa:llvmpipe", "Mesa", "4.5", "llvmpipe", 8, {{"a", "b"}, {"c d", kHostile}}},
      {"exec:./a \"b\"", "", "", "", 4, {}}};
  const RuleId fill = rule_named("triangle.fill-rule");
  RuleAnswers answers{fill, 9, std::vector<std::size_t>(rule_of(fill).alternatives.size(), 9)};
  answers.against.front() = 2;
  results.rules["osmesa:llvmpipe"]["fbo"] = {answers};
  results.refuted["osmesa:llvmpipe"]["fbo"].add(cause_named("line.snap=none").parts[0]);
  CaseResults one = full_case("lines/a");
  one.results = {full_result(), failed()};
  results.cases.push_back(one);
  one = full_case("lines/b");
  one.results = {failed(), full_result()};
  one.results[1].pixels = one.pixels;
  one.results[1].verdict = Verdict::violation;
  results.cases.push_back(one);
  results.diagnostics = {{"cases/bad.json", 7, "/target/width", "too wide", "use 4096 or less"},
                         {"cases/gone.json", 0, "", kHostile, ""}};
  return results;
}

Results gross_results() {
  Results results = results_with({Verdict::violation});
  CaseResults one = results.cases[0];
  one.width = 8;
  one.height = 6;
  one.pixels = std::vector<std::uint8_t>(4 * 8 * 6);
  Result& result = one.results[0];
  result.pixels = one.pixels;
  result.disagreements = {disagreement()};
  result.counted.resize(2);
  static_cast<DisagreementClass&>(result.counted[0]) = disagreement();
  result.counted[0].policy_agrees = true;
  result.counted[0].runs = {{0, 7, 8}, {2, 0, 8}, {2, 3, 4}, {5, 1, 3}};
  result.counted[1].rule = RuleId::triangle_fill_rule;
  result.counted[1].legality = Legality::illegal;
  result.counted[1].ruling = 4;
  result.counted[1].runs = {{4, 0, 1}};
  results.cases.replace(0, one);
  return results;
}

Results results_with(const std::vector<Verdict>& verdicts) {
  Results results;
  results.renderers.resize(1);
  results.renderers[0].name = "fake";
  for (Verdict verdict : verdicts) {
    CaseResults one;
    one.id = std::string(1, static_cast<char>('a' + results.cases.size()));
    Result result;
    result.verdict = verdict;
    if (verdict != Verdict::agree) result.fingerprint = "print-" + one.id;
    if (verdict == Verdict::not_run)
      result.failure = Failure{FailureKind::crashed, "signal 11"};
    else if (verdict != Verdict::agree)
      result.disagreements.resize(2);
    for (Disagreement& d : result.disagreements) d.rule = rule_named("triangle.fill-rule");
    one.surface = "fbo";
    one.results = {result};
    results.cases.push_back(one);
  }
  return results;
}

}  // namespace edgecase
