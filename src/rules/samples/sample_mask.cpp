// SPDX-License-Identifier: MIT
#include "rules/samples/sample_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace edgecase {

Unsampled unsampled(PrimitiveKind kind, MultisampleSwitch choice) {
  const bool line = kind == PrimitiveKind::line;
  switch (choice) {
    case MultisampleSwitch::honoured:
    case MultisampleSwitch::depth_of_first:
      return Unsampled::by_centre;
    case MultisampleSwitch::ignored:
      return Unsampled::by_each_sample;
    case MultisampleSwitch::ignored_but_for_lines:
      return line ? Unsampled::by_centre : Unsampled::by_each_sample;
    case MultisampleSwitch::ignored_but_whole_lines:
      return line ? Unsampled::whole_pixels : Unsampled::by_each_sample;
  }
  return Unsampled::by_centre;
}

std::uint32_t writable_samples(const Multisampling& use, int samples, SampleMask choice) {
  const std::uint32_t all = mask_of_all(samples);
  return use.enabled && choice == SampleMask::applied ? use.mask & all : all;
}

Rule multisample_switch_rule() {
  return {
      RuleId::sample_enable,
      "Without GL_MULTISAMPLE a multisampled target is drawn to as if it had one sample",
      "14.3.1 (multisampling)",
      "where depths and attributes are evaluated (rulings 29 and 35); single-sampled rules "
      "decide what is covered, and all samples of a fragment are written",
      "honoured",
      alternatives_of<MultisampleSwitch>(),
      {{35,
        "While GL_MULTISAMPLE is disabled, a primitive covers the pixels that it covers in a "
        "target of one sample, and a fragment's coverage is bit 0 alone (15.2.2): any other bit "
        "is a violation, and so is a sample that is not written. The depths of a pixel's "
        "samples are that of its centre, or each its own, or all that of one sample, which the "
        "implementation takes for the centermost (14.3.1, 17.3.10). Stencil and depth tests may be "
        "done at that sample alone, the same in the whole case: all samples of the pixel then get "
        "the new stencil value, and all of them get colour and depth, or none does."}}};
}

Rule sample_mask_rule() {
  return {RuleId::sample_mask,
          "Only samples in the sample mask are written",
          "14.9.3 (multisample fragment operations)",
          "none",
          "applied",
          alternatives_of<SampleMask>(),
          {{32,
            "The sample mask is exact: a fragment's coverage is what its primitive covers and the "
            "mask, bit by bit, bits beyond the samples count for nothing, and a pixel of which "
            "nothing is left has no fragment. While GL_MULTISAMPLE is disabled it does nothing."}}};
}

namespace {

// Products of an alpha of single precision with these numbers are exact in double precision.
bool keeps(double alpha, int sample, int samples, AlphaToCoverage choice) {
  switch (choice) {
    case AlphaToCoverage::proportional:
      return 2 * alpha * samples >= 2 * sample + 1;
    case AlphaToCoverage::above_quotient:
    case AlphaToCoverage::above_quotient_of_others:
      return alpha * samples > sample;
    case AlphaToCoverage::spread:
      return alpha * (samples + 1) >= sample + 1;
    case AlphaToCoverage::ignored:
      return true;
  }
  return true;
}

}  // namespace

std::uint32_t alpha_mask(double alpha, int samples, AlphaToCoverage choice) {
  std::uint32_t mask = 0;
  for (int sample = 0; sample < samples; ++sample)
    if (keeps(alpha, sample, samples, choice)) mask |= std::uint32_t{1} << sample;
  return mask;
}

std::uint32_t mask_by_others(std::span<const double> alphas) {
  const int samples = static_cast<int>(alphas.size());
  std::uint32_t mask = mask_of_all(samples);
  for (int own = 0; own < samples; ++own)
    mask &= alpha_mask(alphas[static_cast<std::size_t>(own)], samples,
                       AlphaToCoverage::above_quotient) |
            std::uint32_t{1} << own;
  return mask;
}

std::uint32_t runs_by_others(std::span<const double> alphas) {
  const int samples = static_cast<int>(alphas.size());
  std::uint32_t left = mask_of_all(samples);
  std::uint32_t runs = 0;
  for (int sample = 0; sample < samples; ++sample) {
    runs |= left & std::uint32_t{1} << sample;
    left &= alpha_mask(alphas[static_cast<std::size_t>(sample)], samples,
                       AlphaToCoverage::above_quotient);
  }
  return runs;
}

SampleCounts alpha_permitted(Interval alpha, int samples) {
  return {alpha.low >= 1 ? samples : 0, alpha.high <= 0 ? 0 : samples};
}

bool is_proportional(double alpha, int kept, int samples) {
  return std::fabs(kept - std::clamp(alpha, 0.0, 1.0) * samples) < 1;
}

Rule alpha_to_coverage_rule() {
  return {
      RuleId::sample_alpha_to_coverage,
      "Alpha to coverage keeps samples in proportion to alpha",
      "17.3.1 (alpha to coverage)",
      "which samples, which may differ from pixel to pixel; none for alpha 0, all for 1 (rulings "
      "33 and 52)",
      "proportional",
      alternatives_of<AlphaToCoverage>(),
      {{33,
        "Alpha to coverage: a fragment whose alpha, clamped to 0 to 1, is 0 writes no sample, one "
        "whose alpha is 1 writes all that it covers, and of others any part of them. Fragments of "
        "one pixel with the same alpha keep the same samples. The function may be pseudo-random "
        "and "
        "differ from pixel to pixel (14.9.3): a pixel may keep fewer samples than another one of a "
        "smaller alpha. Where fragments cover all samples, the numbers that they keep fall as "
        "alpha grows only if a threshold for each sample of each pixel, drawn evenly from 0 to 1, "
        "yields so low a slope with odds of less than 10^-9, or if one function holds for all "
        "pixels, since their equal numbers for equal alphas have such odds. Where the shader runs "
        "for each sample, an invocation's alpha counts for its own sample. While GL_MULTISAMPLE is "
        "disabled it does nothing."},
       {kRulingOnProportion,
        "Contested: fragments that cover all n samples keep numbers of them that are not "
        "proportional to alpha. Some fragment's number is one or more off alpha n, and thresholds "
        "for each sample of each pixel, drawn evenly from 0 to 1, yield the sum of the case's "
        "numbers, their slope or their distances from alpha n with odds of less than 10^-9; or one "
        "function holds for all pixels, since their equal numbers for equal alphas have such odds. "
        "17.3.1 says that the function must have the properties of proportionality of 14.9.3. But "
        "14.9.3 only calls them intended, and OpenGL ES 3.2 says the same (15.1.1, 13.8.3). The "
        "Khronos tests (dEQP-GLES3.functional.multisample.*.proportionality_alpha_to_coverage) "
        "want no more than that an image's sum never falls as alpha grows, that 0 keeps nothing "
        "and that 1 keeps all."},
       {kRulingOnFallingNumbers,
        "Contested: at one pixel of a framebuffer object, fragments that cover all samples keep "
        "fewer of them of a larger alpha, be it in another answer of the renderer. 14.9.3 lets the "
        "function differ between pixels, and wants the number proportional to alpha, so that at "
        "one pixel it never falls, however it is rounded or drawn. But 14.9.3 calls that intended "
        "(ruling 52), and the Khronos tests "
        "(dEQP-GLES3.functional.multisample.*.proportionality_alpha_to_coverage) add up whole "
        "images, whose sums may grow where a pixel's number falls; where sums fall, ruling 33 "
        "convicts."}}};
}

}  // namespace edgecase
