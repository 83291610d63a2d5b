// SPDX-License-Identifier: MIT
//
// How often the shader runs, and the samples that it may write.
#include "rules/samples/shading_rate.h"

#include <gtest/gtest.h>

#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

TEST(ShadingRate, OncePerSampleWhereMoreThanOneIsAskedFor) {
  Multisampling use;
  EXPECT_FALSE(runs_per_sample(use, 4, ShadingRate::as_needed));
  EXPECT_TRUE(runs_per_sample(use, 4, ShadingRate::per_sample));
  use.min_sample_shading = 0.25F;
  EXPECT_FALSE(runs_per_sample(use, 4, ShadingRate::as_needed));
  EXPECT_TRUE(runs_per_sample(use, 8, ShadingRate::as_needed));
  use.min_sample_shading = 0.26F;
  EXPECT_TRUE(runs_per_sample(use, 4, ShadingRate::as_needed));
  EXPECT_FALSE(runs_per_sample(use, 4, ShadingRate::per_pixel));
  use = {};
  use.location = AttributeLocation::centroid;
  EXPECT_FALSE(runs_per_sample(use, 4, ShadingRate::as_needed));
  use.location = AttributeLocation::sample;
  EXPECT_TRUE(runs_per_sample(use, 2, ShadingRate::as_needed));
  EXPECT_FALSE(runs_per_sample(use, 2, ShadingRate::per_pixel));
}

TEST(ShadingRate, NeverPerSampleWithoutMultisampling) {
  Multisampling use;
  use.location = AttributeLocation::sample;
  for (ShadingRate rate : values_of<ShadingRate>()) {
    EXPECT_FALSE(runs_per_sample(use, 1, rate));
    use.enabled = false;
    EXPECT_FALSE(runs_per_sample(use, 4, rate));
    use.enabled = true;
  }
}

TEST(SampleMask, KeepsItsBitsOfTheSamples) {
  Multisampling use;
  EXPECT_EQ(writable_samples(use, 4, SampleMask::applied), 15u);
  use.mask = 0xa5;
  EXPECT_EQ(writable_samples(use, 4, SampleMask::applied), 5u);
  EXPECT_EQ(writable_samples(use, 16, SampleMask::applied), 0xa5u);
  EXPECT_EQ(writable_samples(use, 16, SampleMask::ignored), 0xffffu);
  EXPECT_EQ(mask_of_all(1), 1u);
}

template <class Choice>
void expect_names(std::initializer_list<Choice> choices) {
  for (Choice choice : choices) {
    Choice read = *choices.begin();
    EXPECT_TRUE(parse_name(name_of(choice), read));
    EXPECT_EQ(read, choice);
    EXPECT_FALSE(parse_name("other", read));
  }
}

TEST(ShadingRate, NamesAreReadBack) {
  expect_names({ShadingRate::as_needed, ShadingRate::per_sample, ShadingRate::per_pixel});
  expect_names({SampleMask::applied, SampleMask::ignored});
  expect_names({MultisampleSwitch::honoured, MultisampleSwitch::depth_of_first,
                MultisampleSwitch::ignored, MultisampleSwitch::ignored_but_for_lines,
                MultisampleSwitch::ignored_but_whole_lines});
  EXPECT_EQ(values_of<MultisampleSwitch>().size(), 5u);
}

}  // namespace
}  // namespace edgecase
