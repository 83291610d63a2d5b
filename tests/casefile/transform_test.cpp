// SPDX-License-Identifier: MIT
//
// Model, view and projection: by hand where numbers are simple, and against matrices in double that
// are written down here from their definitions (Red Book, appendix E).
#include "casefile/mesh/transform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "casefile/json/json_document.h"
#include "casefile/loader.h"

namespace edgecase {
namespace {

using Rows = std::array<std::array<double, 4>, 4>;

Matrix matrix_of(const std::string& text) {
  const JsonDocument document = parse_json(text, "a.json");
  Findings findings("a.json");
  const Transform transform = read_transform({&*document.root, ""}, findings);
  for (const Diagnostic& fault : findings.take()) ADD_FAILURE() << to_string(fault);
  return transform.matrix;
}

// Within what float32 loses in a few operations on numbers of magnitude 4 at most.
void expect_near(const Matrix& matrix, const Rows& rows) {
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      EXPECT_NEAR(static_cast<double>(matrix[4 * column + row]), rows[row][column], 4e-6)
          << row << " " << column;
}

Matrix model(const std::string& operations) {
  return matrix_of(R"({"model": [)" + operations + "]}");
}

TEST(Transform, OperationsAreAppliedInTheOrderWritten) {
  const std::string move = R"({"translate": [1, 2, 3]})";
  const std::string grow = R"({"scale": [2, 3, 4]})";
  const ClipPosition moved_first = clip_position(model(move + "," + grow), {1, 1, 1});
  EXPECT_EQ(moved_first, (ClipPosition{4, 9, 16, 1}));
  const ClipPosition grown_first = clip_position(model(grow + "," + move), {1, 1, 1});
  EXPECT_EQ(grown_first, (ClipPosition{3, 5, 7, 1}));
  EXPECT_EQ(clip_position(model(""), {1, 2, 3}), (ClipPosition{1, 2, 3, 1}));
}

TEST(Transform, MatricesAreWrittenRowByRow) {
  const Matrix matrix =
      model(R"({"matrix": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]})");
  EXPECT_EQ(clip_position(matrix, {1, 0, 0}), (ClipPosition{5, 13, 21, 29}));
  EXPECT_EQ(clip_position(matrix, {0, 1, 0}), (ClipPosition{6, 14, 22, 30}));
}

// The axis (1, 2, 2)/3 by Rodrigues' formula.
TEST(Transform, RotatesAboutAnyAxis) {
  const double angle = 40 * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
  const double x = 1.0 / 3, y = 2.0 / 3, z = 2.0 / 3;
  expect_near(model(R"({"rotate": {"degrees": 40, "axis": [1, 2, 2]}})"),
              {{{t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0},
                {t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0},
                {t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0},
                {0, 0, 0, 1}}});
}

TEST(Transform, LooksFromTheEyeAtTheCenter) {
  const Matrix view = matrix_of(
      R"({"view": {"look_at": {"eye": [3, 0, 0], "center": [0, 0, 0], "up": [0, 2, 0]}}})");
  expect_near(view, {{{0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, -3}, {0, 0, 0, 1}}});
}

TEST(Transform, Projects) {
  const double n = 0.5, f = 4;
  const double cot = 1 / std::tan(30 * std::numbers::pi / 180);
  expect_near(matrix_of(R"({"projection": {"perspective":
                  {"fov_y_degrees": 60, "aspect": 2, "near": 0.5, "far": 4}}})"),
              {{{cot / 2, 0, 0, 0},
                {0, cot, 0, 0},
                {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)},
                {0, 0, -1, 0}}});
  const std::string sides =
      R"({"left": -1, "right": 3, "bottom": -2, "top": 1, "near": 0.5, "far": 4})";
  expect_near(matrix_of(R"({"projection": {"frustum": )" + sides + "}}"),
              {{{2 * n / 4, 0, 2.0 / 4, 0},
                {0, 2 * n / 3, -1.0 / 3, 0},
                {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)},
                {0, 0, -1, 0}}});
  expect_near(matrix_of(R"({"projection": {"orthographic": )" + sides + "}}"),
              {{{2.0 / 4, 0, 0, -2.0 / 4},
                {0, 2.0 / 3, 0, 1.0 / 3},
                {0, 0, -2 / (f - n), -(f + n) / (f - n)},
                {0, 0, 0, 1}}});
}

TEST(Transform, TakesModelThenViewThenProjection) {
  const Matrix matrix = matrix_of(R"({
      "projection": {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0]},
      "view": [{"translate": [0, 0, -4]}],
      "model": [{"scale": [2, 2, 2]}]})");
  EXPECT_EQ(clip_position(matrix, {1, 0.5F, 1}), (ClipPosition{2, 1, -2, 2}));
}

// ------------------------------------------------------------------------------ in a case file

Case load(const std::string& rest) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 8, "height": 8}, )" + rest + "}",
      "a.json", "a");
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  return loaded.cases.empty() ? Case{} : loaded.cases[0];
}

TEST(Transform, OfTheCaseHoldsForDrawsWithoutTheirOwn) {
  const Case one = load(R"("transform": {"model": [{"scale": [0.5, 0.5, 0.5]}],
                                         "affine": [{"translate": [1, 0]}]},
    "draws": [
      {"primitive": "points", "vertices": [{"object": [1, 0.5, 0]}, [1, 1]]},
      {"primitive": "points", "vertices": [{"object": [0.5, 0.5, 0]}, [1, 1]],
       "transform": {"model": [{"translate": [0, 0, 0.25]}]}}]
  )");
  ASSERT_EQ(one.scene.draws.size(), 2U);
  const auto& first = one.scene.draws[0].vertices;
  EXPECT_EQ(first[0].clip, (ClipPosition{0.5F, 0.25F, 0, 1}));
  EXPECT_EQ(first[0].position, (Point{Fixed::from_integer(6), Fixed::from_integer(5)}));
  EXPECT_EQ(first[1].position.x, Fixed::from_integer(2));
  const auto& second = one.scene.draws[1].vertices;
  EXPECT_EQ(second[0].clip, (ClipPosition{0.5F, 0.5F, 0.25F, 1}));
  EXPECT_EQ(second[0].z, Fixed::from_raw(Fixed::kOne / 4));
  EXPECT_EQ(second[1].position.x, Fixed::from_integer(1));
}

TEST(Transform, RoundingIsNotedOnceADraw) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 8, "height": 8}, "draws": [
        {"primitive": "lines", "vertices": [[1, 1], [2, 1]],
         "transform": {"affine": [{"rotate": {"degrees": 30}}]}},
        {"primitive": "lines", "vertices": [[1, 1], [2, 1]],
         "transform": {"affine": [{"scale": ["1/256", "1/256"]}]}},
        {"primitive": "lines", "vertices": [{"object": [1e-8, 0, 0]}, {"object": [3e-8, 0, 0]}],
         "transform": {"model": [{"scale": [0.3, 0.3, 0.3]}]}}
      ]})",
      "a.json", "a");
  ASSERT_EQ(loaded.cases.size(), 1U);
  ASSERT_EQ(loaded.notes.size(), 2U);
  EXPECT_EQ(loaded.notes[0].pointer, "/draws/0/transform/affine");
  EXPECT_EQ(loaded.notes[1].pointer, "/draws/2/transform");
  const Point turned = loaded.cases[0].scene.draws[0].vertices[0].position;
  EXPECT_NEAR(turned.x.to_double(), (std::numbers::sqrt3 - 1) / 2, std::ldexp(1, -17));
  EXPECT_NEAR(turned.y.to_double(), (std::numbers::sqrt3 + 1) / 2, std::ldexp(1, -17));
}

TEST(Transform, DrawsMeshes) {
  const LoadedCases loaded =
      load_cases(std::string(EDGECASE_ROOT) + "/tests/casefile/good/values-everything.json", "v");
  ASSERT_FALSE(loaded.cases.empty());
  const Draw& draw = loaded.cases[0].scene.draws[2];
  ASSERT_EQ(draw.vertices.size(), 3U);
  EXPECT_EQ(draw.vertices[0].clip->w, 4);
  EXPECT_EQ(draw.vertices[0].position, (Point{Fixed::from_integer(4), Fixed::from_integer(2)}));
  EXPECT_EQ(draw.vertices[2].color, (Color{1, 2, 3, 4}));
}

}  // namespace
}  // namespace edgecase
