// SPDX-License-Identifier: MIT
//
// What is made of the parts of records that a target shows, and when there is doubt.
#include "reference/word_capture.h"

#include <gtest/gtest.h>

#include <bit>

namespace edgecase {
namespace {

constexpr int kSamplesWord = 38;

// What a sample shows: the words of a fragment, or nothing.
struct Shown {
  std::int32_t primitive = -1;  // -1: nothing
  float depth = 0;
  std::uint32_t samples = 0;
};

// OpenGL that takes images.
GladGLContext quiet_gl() {
  GladGLContext gl{};
  gl.ActiveTexture = [](GLenum) {};
  gl.BindTexture = [](GLenum, GLuint) {};
  gl.DeleteTextures = [](GLsizei, const GLuint*) {};
  gl.GenTextures = [](GLsizei, GLuint* names) { *names = 1; };
  gl.TexParameteri = [](GLenum, GLenum, GLint) {};
  gl.TexImage2D = [](GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {};
  return gl;
}

// A target of 2 x 1 pixels.
class WordCaptureTest : public ::testing::Test {
 protected:
  void begin(int samples = 1) {
    scene_.target.width = rendering_.width = 2;
    scene_.target.height = rendering_.height = 1;
    scene_.target.samples = rendering_.samples = samples;
    capture_.begin(scene_, Capture::Form::plain, false, rendering_);
  }

  // RGBA8 of a part, as the shader writes it.
  static std::vector<std::uint8_t> colors_of(int part, const std::vector<Shown>& shown) {
    std::vector<std::uint8_t> colors;
    for (const Shown& one : shown) {
      std::uint32_t words[kSamplesWord + 1] = {};
      words[0] = static_cast<std::uint32_t>(one.primitive);
      words[1] = std::bit_cast<std::uint32_t>(one.depth);
      words[5] = std::bit_cast<std::uint32_t>(-0.75F);
      words[kSamplesWord] = one.samples;
      for (int byte = 3 * part; byte < 3 * part + 3; ++byte)
        colors.push_back(one.primitive < 0
                             ? std::uint8_t{0}
                             : static_cast<std::uint8_t>(words[byte / 4] >> 8 * (byte % 4)));
      colors.push_back(one.primitive < 0 ? std::uint8_t{0}
                                         : static_cast<std::uint8_t>(one.primitive % 255 + 1));
    }
    return colors;
  }

  // Draws a layer; the later parts are of `again`. False if it is empty.
  bool draw(const std::vector<Shown>& shown, const std::vector<Shown>& again) {
    if (!capture_.take_first(colors_of(capture_.parts().front(), shown))) return false;
    for (std::size_t i = 1; i < capture_.parts().size(); ++i)
      capture_.take(capture_.parts()[i], colors_of(capture_.parts()[i], again));
    capture_.finish_layer(rendering_);
    return true;
  }
  bool draw(const std::vector<Shown>& shown) { return draw(shown, shown); }

  GladGLContext gl_ = quiet_gl();
  Scene scene_;
  Rendering rendering_;
  WordCapture capture_{gl_};
};

TEST_F(WordCaptureTest, MakesFragmentsOfParts) {
  begin();
  EXPECT_EQ(capture_.parts().size(), 8u) << "24 bytes";
  EXPECT_TRUE(draw({{300, 0.1F}, {}}));
  EXPECT_TRUE(draw({{7, 0.3F}, {}}));
  EXPECT_FALSE(draw({{}, {}}));
  ASSERT_EQ(rendering_.fragments.size(), 2u);
  EXPECT_EQ(rendering_.fragments[0].primitive, 300);
  EXPECT_EQ(rendering_.fragments[0].depth, static_cast<double>(0.1F));
  EXPECT_EQ(rendering_.fragments[0].color[3], -0.75);
  EXPECT_EQ(rendering_.fragments[1].primitive, 7);
  EXPECT_EQ(capture_.doubt(), "");
  EXPECT_EQ(capture_.doubt_of_hits({2, 0}), "");
  EXPECT_EQ(capture_.doubt_of_hits({1, 0}), "") << "the reader of the answer refuses it";
  EXPECT_TRUE(capture_.doubt_of_hits({3, 0}).starts_with("pixel (0, 0) has 3 hits, and 2"));
  EXPECT_TRUE(capture_.doubt_of_hits({2, 1}).starts_with("pixel (1, 0) has 1 hits, and 0"));
}

TEST_F(WordCaptureTest, DoubtsPartsOfSeveralFragments) {
  begin();
  draw({{3, 0.5F}, {}}, {{4, 0.5F}, {}});
  EXPECT_EQ(capture_.doubt(), "pixel (0, 0) was drawn otherwise when asked again");
  begin();
  draw({{}, {3, 0.5F}}, {{}, {}});
  EXPECT_EQ(capture_.doubt(), "pixel (1, 0) was drawn otherwise when asked again");
}

TEST_F(WordCaptureTest, DoubtsADriverThatDoesNotDiscard) {
  begin();
  EXPECT_TRUE(draw({{3, 0.5F}, {}}));
  EXPECT_TRUE(draw({{3, 0.5F}, {}}));
  EXPECT_EQ(capture_.doubt(), "pixel (0, 0) shows a fragment that was discarded");
}

// Planes of samples. Of a pixel, a layer tells the latest primitive, and each of its invocations.
TEST_F(WordCaptureTest, MakesOneFragmentOfTheSamplesOfAnInvocation) {
  begin(2);
  EXPECT_TRUE(draw({{1, 0.5F, 3}, {2, 0.25F, 1}, {5, 0.5F, 2}, {2, 0.75F, 2}}));
  EXPECT_TRUE(draw({{1, 0.5F, 3}, {}, {1, 0.5F, 3}, {}}));
  EXPECT_FALSE(draw({{}, {}, {}, {}}));
  EXPECT_EQ(capture_.doubt(), "");
  sort_fragments(rendering_);
  std::vector<std::array<int, 3>> told;
  for (const Fragment& fragment : rendering_.fragments)
    told.push_back({fragment.x, fragment.primitive, static_cast<int>(fragment.coverage)});
  EXPECT_EQ(told, (std::vector<std::array<int, 3>>{{0, 1, 3}, {0, 5, 2}, {1, 2, 1}, {1, 2, 2}}));
  EXPECT_EQ(capture_.doubt_of_hits({1, 1, 2, 1}), "");
  EXPECT_TRUE(capture_.doubt_of_hits({1, 1, 3, 1}).starts_with("pixel (0, 0) has 3 hits"));
}

TEST_F(WordCaptureTest, DoubtsSamplesOfOneInvocationThatDiffer) {
  begin(2);
  draw({{1, 0.5F, 3}, {}, {1, 0.75F, 3}, {}});
  EXPECT_EQ(capture_.doubt(),
            "samples of pixel (0, 0) with one gl_SampleMaskIn show several fragments");
}

}  // namespace
}  // namespace edgecase
