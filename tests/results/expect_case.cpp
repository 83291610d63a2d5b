// SPDX-License-Identifier: MIT
#include "tests/results/expect_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "results/packed_text.h"

namespace edgecase {
namespace {

// Equal to the bit, the sign of zero included; any NaN equals any other.
void expect_number(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return;
  EXPECT_EQ(a, b);
  EXPECT_EQ(std::signbit(a), std::signbit(b));
}

void expect_numbers(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_number(a[i], b[i]);
}

void expect_figure(const Figure& a, const Figure& b) {
  ASSERT_EQ(a.marks.size(), b.marks.size());
  for (std::size_t i = 0; i < a.marks.size(); ++i) {
    EXPECT_EQ(a.marks[i].role, b.marks[i].role);
    EXPECT_EQ(a.marks[i].closed, b.marks[i].closed);
    EXPECT_EQ(a.marks[i].points, b.marks[i].points);
    EXPECT_EQ(a.marks[i].label, b.marks[i].label);
  }
}

void expect_disagreement(const Disagreement& a, const Disagreement& b) {
  EXPECT_EQ(std::tie(a.x, a.y, a.sample, a.primitive, a.kind, a.rule, a.legality, a.cause,
                     a.situation, a.ruling, a.explanation),
            std::tie(b.x, b.y, b.sample, b.primitive, b.kind, b.rule, b.legality, b.cause,
                     b.situation, b.ruling, b.explanation));
  ASSERT_EQ(a.upright.has_value(), b.upright.has_value());
  if (a.upright) {
    EXPECT_EQ(std::tie(a.upright->rule, a.upright->ruling, a.upright->legality, a.upright->cause),
              std::tie(b.upright->rule, b.upright->ruling, b.upright->legality, b.upright->cause));
  }
  expect_numbers(a.exact, b.exact);
  expect_numbers(a.rendered, b.rendered);
  expect_figure(a.figure, b.figure);
}

void expect_values(const ValueAggregate& a, const ValueAggregate& b) {
  EXPECT_EQ(std::tie(a.attribute, a.rule, a.ruling, a.cause, a.compared, a.components,
                     a.worst_component, a.ulp_histogram),
            std::tie(b.attribute, b.rule, b.ruling, b.cause, b.compared, b.components,
                     b.worst_component, b.ulp_histogram));
  const auto place = [](const ValueAggregate::Place& p) {
    return std::tuple(p.x, p.y, p.primitive);
  };
  EXPECT_EQ(place(a.worst), place(b.worst));
  EXPECT_EQ(packed_places(a.differing), packed_places(b.differing));
  expect_number(a.worst_exact, b.worst_exact);
  expect_number(a.worst_rendered, b.worst_rendered);
  expect_number(a.worst_ulp, b.worst_ulp);
  expect_number(a.mean_ulp, b.mean_ulp);
  expect_number(a.worst_relative, b.worst_relative);
}

void expect_ramp(const std::vector<Result::LevelPoint>& a,
                 const std::vector<Result::LevelPoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::tie(a[i].x, a[i].y), std::tie(b[i].x, b[i].y));
    expect_numbers({a[i].exact, a[i].low, a[i].high, a[i].rendered},
                   {b[i].exact, b[i].low, b[i].high, b[i].rendered});
  }
}

void expect_fragments(const std::vector<Result::ReportedFragment>& a,
                      const std::vector<Result::ReportedFragment>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Fragment &f = a[i].fragment, &g = b[i].fragment;
    EXPECT_EQ(
        std::tie(f.x, f.y, f.primitive, f.coverage, f.has_depth, f.has_color, f.detail, a[i].pass),
        std::tie(g.x, g.y, g.primitive, g.coverage, g.has_depth, g.has_color, g.detail, b[i].pass));
    if (f.has_depth) expect_number(f.depth, g.depth);
    for (std::size_t c = 0; f.has_color && c < f.color.size(); ++c)
      expect_number(f.color[c], g.color[c]);
  }
}

void expect_result(const Result& a, const Result& b) {
  EXPECT_EQ(a.refuted, b.refuted);
  EXPECT_EQ(a.pixel_counts, b.pixel_counts);
  EXPECT_TRUE(a.samples == b.samples);
  EXPECT_TRUE(a.exact_samples == b.exact_samples);
  EXPECT_EQ(a.exact_pixels, b.exact_pixels);
  expect_ramp(a.ramp, b.ramp);
  expect_fragments(a.exact_fragments, b.exact_fragments);
  expect_fragments(a.rendered_fragments, b.rendered_fragments);
  EXPECT_EQ(a.faults, b.faults);
  EXPECT_EQ(a.images, b.images);
  EXPECT_EQ(a.shown, b.shown);
  EXPECT_EQ(a.again, b.again);
  EXPECT_EQ(std::tie(a.verdict, a.fingerprint, a.illegal_line_snaps, a.pixels, a.standing,
                     a.standing_reason, a.answer_digest),
            std::tie(b.verdict, b.fingerprint, b.illegal_line_snaps, b.pixels, b.standing,
                     b.standing_reason, b.answer_digest));
  ASSERT_EQ(a.failure.has_value(), b.failure.has_value());
  if (a.failure) {
    EXPECT_EQ(a.failure->kind, b.failure->kind);
    EXPECT_EQ(a.failure->reason, b.failure->reason);
  }
  ASSERT_EQ(a.disagreements.size(), b.disagreements.size());
  for (std::size_t i = 0; i < a.disagreements.size(); ++i)
    expect_disagreement(a.disagreements[i], b.disagreements[i]);
  ASSERT_EQ(a.counted.size(), b.counted.size());
  for (std::size_t i = 0; i < a.counted.size(); ++i) {
    const CountedDisagreements &c = a.counted[i], &d = b.counted[i];
    EXPECT_EQ(static_cast<const DisagreementClass&>(c), static_cast<const DisagreementClass&>(d));
    EXPECT_EQ(c.runs, d.runs);
  }
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i) expect_values(a.values[i], b.values[i]);
  ASSERT_EQ(a.evidence.size(), b.evidence.size());
  for (std::size_t i = 0; i < a.evidence.size(); ++i) {
    const auto &e = a.evidence[i], &f = b.evidence[i];
    EXPECT_EQ(std::tie(e.primitive, e.pass, e.causes, e.illegal_line_snaps, e.broken_clause),
              std::tie(f.primitive, f.pass, f.causes, f.illegal_line_snaps, f.broken_clause));
  }
}

}  // namespace

void expect_case(const CaseResults& a, const CaseResults& b) {
  EXPECT_EQ(std::tie(a.id, a.title, a.why, a.rules, a.spec, a.origin, a.tags, a.file, a.surface,
                     a.file_digest),
            std::tie(b.id, b.title, b.why, b.rules, b.spec, b.origin, b.tags, b.file, b.surface,
                     b.file_digest));
  EXPECT_EQ(std::tie(a.width, a.height, a.pixels, a.fragments, a.expect_failures),
            std::tie(b.width, b.height, b.pixels, b.fragments, b.expect_failures));
  ASSERT_EQ(a.viewport.has_value(), b.viewport.has_value());
  if (a.viewport) {
    EXPECT_EQ(std::tie(a.viewport->x, a.viewport->y, a.viewport->width, a.viewport->height),
              std::tie(b.viewport->x, b.viewport->y, b.viewport->width, b.viewport->height));
  }
  EXPECT_TRUE(a.samples == b.samples);
  expect_figure(a.figure, b.figure);
  ASSERT_EQ(a.results.size(), b.results.size());
  for (std::size_t i = 0; i < a.results.size(); ++i) expect_result(a.results[i], b.results[i]);
}

}  // namespace edgecase
