// SPDX-License-Identifier: MIT
#include "rules/samples/sample_mask.h"

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
        "implementation takes for the centermost (14.3.1, 17.3.10)."}}};
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

}  // namespace edgecase
