// SPDX-License-Identifier: MIT
#include "rules/samples/sample_mask.h"

#include "rules/alternative_table.h"

namespace edgecase {
namespace {

constexpr TabledAlternative<MultisampleSwitch> kSwitches[] = {
    {MultisampleSwitch::honoured, "honoured", Openness::mandated,
     "without GL_MULTISAMPLE the pixel's centre decides for all samples"},
    {MultisampleSwitch::depth_of_first, "depth-of-first", Openness::illegal,
     "the pixel's centre decides for all samples, and only sample 0 gets a depth"},
    {MultisampleSwitch::ignored, "ignored", Openness::illegal,
     "each sample decides for itself, whether GL_MULTISAMPLE is enabled or not; the sample mask "
     "applies only while it is enabled"},
    {MultisampleSwitch::ignored_but_for_lines, "ignored-but-for-lines", Openness::illegal,
     "honoured for lines, ignored for points and triangles"},
    {MultisampleSwitch::ignored_but_whole_lines, "ignored-but-whole-lines", Openness::illegal,
     "ignored for points and triangles; for lines the pixel's centre decides for all samples, and "
     "the coverage has the bits of all samples"}};
constexpr auto kAllSwitches = values_in(kSwitches);

constexpr TabledAlternative<SampleMask> kMasks[] = {
    {SampleMask::applied, "applied", Openness::mandated,
     "samples whose bit is clear are not covered"},
    {SampleMask::ignored, "ignored", Openness::illegal, "the mask changes nothing"}};

}  // namespace

std::span<const MultisampleSwitch> all_multisample_switches() {
  return kAllSwitches;
}

const char* name_of(MultisampleSwitch choice) {
  return name_in(kSwitches, choice);
}

bool parse_name(std::string_view name, MultisampleSwitch& choice) {
  return find_in(kSwitches, name, choice);
}

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

const char* name_of(SampleMask choice) {
  return name_in(kMasks, choice);
}

bool parse_name(std::string_view name, SampleMask& choice) {
  return find_in(kMasks, name, choice);
}

std::uint32_t writable_samples(const Multisampling& use, int samples, SampleMask choice) {
  const std::uint32_t all = mask_of_all(samples);
  return use.enabled && choice == SampleMask::applied ? use.mask & all : all;
}

Rule multisample_switch_rule() {
  return {
      "sample.enable",
      "Without GL_MULTISAMPLE a multisampled target is drawn to as if it had one sample",
      "14.3.1 (multisampling)",
      "where depths and attributes are evaluated (rulings 29 and 35); single-sampled rules "
      "decide what is covered, and all samples of a fragment are written",
      "honoured",
      alternatives_in(kSwitches),
      {{35,
        "While GL_MULTISAMPLE is disabled, a primitive covers the pixels that it covers in a "
        "target of one sample, and a fragment's coverage is bit 0 alone (15.2.2): any other bit "
        "is a violation, and so is a sample that is not written. The depths of a pixel's "
        "samples are that of its centre, or each its own, or all that of one sample, which the "
        "implementation takes for the centermost (14.3.1, 17.3.10)."}}};
}

Rule sample_mask_rule() {
  return {"sample.mask",
          "Only samples in the sample mask are written",
          "14.9.3 (multisample fragment operations)",
          "none",
          "applied",
          alternatives_in(kMasks),
          {{32,
            "The sample mask is exact: a fragment's coverage is what its primitive covers and the "
            "mask, bit by bit, bits beyond the samples count for nothing, and a pixel of which "
            "nothing is left has no fragment. While GL_MULTISAMPLE is disabled it does nothing."}}};
}

}  // namespace edgecase
