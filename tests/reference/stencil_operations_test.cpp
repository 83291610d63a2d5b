// SPDX-License-Identifier: MIT
//
// The stencil test on the OpenGL side: its functions, its operations, its masks and its two faces.
#include <gmock/gmock.h>

#include <array>

#include "tests/reference/operation_scenes.h"

namespace edgecase {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

constexpr int kStored = 5;
constexpr std::array<std::uint8_t, kStored> kValues = {0, 1, 254, 255, 0x5a};
constexpr std::uint8_t kReference = 0x3c;

struct OperationTable {
  StencilOperation operation;
  std::array<std::uint8_t, kStored> values;  // what becomes of kValues
};
constexpr OperationTable kOperations[] = {
    {StencilOperation::keep, {0, 1, 254, 255, 0x5a}},
    {StencilOperation::zero, {0, 0, 0, 0, 0}},
    {StencilOperation::replace, {0x3c, 0x3c, 0x3c, 0x3c, 0x3c}},
    {StencilOperation::incr, {1, 2, 255, 255, 0x5b}},
    {StencilOperation::incr_wrap, {1, 2, 255, 0, 0x5b}},
    {StencilOperation::decr, {0, 0, 253, 254, 0x59}},
    {StencilOperation::decr_wrap, {255, 0, 253, 254, 0x59}},
    {StencilOperation::invert, {255, 254, 1, 0, 0xa5}},
};

StencilTest on_both_faces(const StencilFace& face) {
  return {face, face};
}

class StencilOperationsTest : public OperationsTest {
 protected:
  // A row with kValues in its stencil buffer.
  Scene stored_values(DepthFormat depth) const {
    Scene scene = row(kStored, depth, StencilFormat::stencil8);
    for (int x = 0; x < kStored; ++x) {
      StencilFace face;
      face.reference = kValues[static_cast<std::size_t>(x)];
      face.pass = StencilOperation::replace;
      scene.draws.push_back(point_at(x, 0, {1, 0, 0, 1}));
      scene.draws.back().operations.stencil = on_both_faces(face);
    }
    return scene;
  }
};

TEST_P(StencilOperationsTest, FunctionsCompareTheReferenceWithWhatIsStored) {
  // References below, at and above the stored 0x83, all bits and the lower four alone.
  constexpr std::pair<CompareFunction, const char*> kPassing[] = {
      {CompareFunction::never, "..."},   {CompareFunction::less, "#.."},
      {CompareFunction::equal, ".#."},   {CompareFunction::lequal, "##."},
      {CompareFunction::greater, "..#"}, {CompareFunction::notequal, "#.#"},
      {CompareFunction::gequal, ".##"},  {CompareFunction::always, "###"},
  };
  constexpr std::array<std::uint8_t, 3> kReferences[] = {{0x7f, 0x83, 0x84}, {0xf2, 0x13, 0x04}};
  for (const auto& [function, passing] : kPassing) {
    for (std::size_t masked = 0; masked < 2; ++masked) {
      Scene scene = row(3, DepthFormat::none, StencilFormat::stencil8);
      scene.target.clear_stencil = 0x83;
      for (std::size_t x = 0; x < 3; ++x) {
        StencilFace face;
        face.function = function;
        face.reference = kReferences[masked][x];
        face.read_mask = masked == 1 ? 0x0f : 0xff;
        scene.draws.push_back(point_at(static_cast<int>(x), 0));
        scene.draws.back().operations.stencil = on_both_faces(face);
      }
      const auto rendering = drawn(scene);
      if (!rendering) return;
      EXPECT_EQ(hits_beyond(*rendering, 0), passing) << name_of(function) << ' ' << masked;
      EXPECT_EQ(rendering->fragments.size(), 3u);
      EXPECT_THAT(rendering->stencils, Each(0x83));
      for (int x = 0; x < 3; ++x)
        EXPECT_EQ(pixel(*rendering, x, 0)[0], passing[x] == '#' ? 255 : 0);
    }
  }
}

// Which of a face's operations a fragment meets.
enum class Fate { fail, depth_fail, pass };

// A draw of which every fragment meets `operation` by its fate; the others would show.
void operate(Draw& draw, Fate fate, StencilOperation operation, std::uint8_t write_mask) {
  const StencilOperation other = operation == StencilOperation::invert ? StencilOperation::incr_wrap
                                                                       : StencilOperation::invert;
  StencilFace face{CompareFunction::always, kReference, 0xff, write_mask, other, other, other};
  if (fate == Fate::fail) face.function = CompareFunction::never;
  (fate == Fate::fail         ? face.fail
   : fate == Fate::depth_fail ? face.depth_fail
                              : face.pass) = operation;
  draw.operations.stencil = on_both_faces(face);
  if (fate == Fate::depth_fail) draw.operations.depth.function = CompareFunction::never;
}

TEST_P(StencilOperationsTest, OperationsDoWhatTheyAreNamedAfter) {
  for (Fate fate : {Fate::fail, Fate::depth_fail, Fate::pass}) {
    for (const OperationTable& table : kOperations) {
      for (int mask : {0xff, 0x0f, 0xa0}) {
        SCOPED_TRACE(std::string(name_of(table.operation)) + ' ' + std::to_string(mask));
        Scene scene = stored_values(DepthFormat::depth32f);
        scene.draws.push_back(flat_rectangle(0, 0, kStored, 1, 0.5));
        operate(scene.draws.back(), fate, table.operation, static_cast<std::uint8_t>(mask));
        const auto rendering = drawn(scene);
        if (!rendering) return;
        EXPECT_EQ(hits_beyond(*rendering, 1), fate == Fate::pass ? "#####" : ".....");
        for (std::size_t x = 0; x < kStored; ++x) {
          EXPECT_EQ(rendering->stencils[x], (kValues[x] & ~mask & 0xff) | (table.values[x] & mask));
          EXPECT_EQ(rendering->depths[x], fate == Fate::pass ? 0.75 : 0.5);
        }
      }
    }
  }
}

TEST_P(StencilOperationsTest, AloneItNeedsNoDepthBuffer) {
  for (const OperationTable& table : kOperations) {
    Scene scene = stored_values(DepthFormat::none);
    scene.draws.push_back(flat_rectangle(0, 0, kStored, 1, 0.5));
    operate(scene.draws.back(), Fate::pass, table.operation, 0xff);
    const auto rendering = drawn(scene);
    if (!rendering) return;
    EXPECT_TRUE(rendering->depths.empty());
    EXPECT_TRUE(std::equal(table.values.begin(), table.values.end(), rendering->stencils.begin(),
                           rendering->stencils.end()))
        << name_of(table.operation);
  }
}

TEST_P(StencilOperationsTest, EachFaceHasItsOwnState) {
  StencilTest test;
  test.front = {CompareFunction::lequal, 0x12, 0xff, 0xff, {}, {}, StencilOperation::replace};
  test.back = {CompareFunction::gequal, 0x34, 0xf0, 0x0f, {}, {}, StencilOperation::replace};
  for (FrontFace front : {FrontFace::ccw, FrontFace::cw}) {
    Scene scene = row(4, DepthFormat::depth32f, StencilFormat::stencil8);
    scene.target.clear_stencil = 0x20;
    scene.draws = {flat_rectangle(0, 0, 1, 1, 0), reversed(flat_rectangle(1, 0, 2, 1, 0)),
                   point_at(2, 0), make_draw(Primitive::lines, {{3 * 256, 128}, {4 * 256, 128}})};
    for (Draw& draw : scene.draws) {
      draw.operations.stencil = test;
      draw.front_face = front;
    }
    const auto rendering = drawn(scene);
    if (!rendering) return;
    EXPECT_EQ(rendering->hits, std::vector<std::uint32_t>(4, 1));
    const int ccw = front == FrontFace::ccw ? 0x12 : 0x24;
    // softpipe takes points and lines for back-facing ones, on framebuffer objects.
    const bool is_wrong =
        name().find("softpipe") != std::string::npos && std::get<1>(GetParam()) == Surface::fbo;
    const int unfaced = is_wrong ? 0x24 : 0x12;
    EXPECT_THAT(rendering->stencils, ElementsAre(ccw, 0x12 + 0x24 - ccw, unfaced, unfaced));
  }
}

TEST_P(StencilOperationsTest, TheStencilTestComesBeforeTheDepthTest) {
  // Fails both: what happens is what the stencil's failure says, and nothing is drawn.
  Scene scene = row(1, DepthFormat::depth32f, StencilFormat::stencil8);
  scene.target.clear_stencil = 7;
  scene.draws = {point_at(0, 0)};
  StencilFace face{
      CompareFunction::never,  0, 0xff, 0xff, StencilOperation::incr, StencilOperation::zero,
      StencilOperation::invert};
  scene.draws[0].operations.stencil = on_both_faces(face);
  scene.draws[0].operations.depth.function = CompareFunction::never;
  const auto rendering = drawn(scene);
  if (!rendering) return;
  EXPECT_THAT(rendering->stencils, ElementsAre(8));
  EXPECT_THAT(rendering->depths, ElementsAre(1.0));
  EXPECT_THAT(rendering->hits, ElementsAre(0u));
  EXPECT_EQ(rendering->fragments.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(OpenGl, StencilOperationsTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
