// SPDX-License-Identifier: MIT
//
// Policies and galleries: the same bytes are read as either.
#include "casefile/policy_reader.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const std::string text(text_of(data, size));
  const LoadedPolicy policy = load_policy_text(text, "input.json", {});
  promise(policy.value.has_value() == policy.diagnostics.empty(), "a policy or faults");
  const LoadedGallery gallery = load_gallery_text(text, "input.json", {});
  promise(gallery.value.has_value() == gallery.diagnostics.empty(), "a gallery or faults");
  return 0;
}
