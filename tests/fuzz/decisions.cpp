// SPDX-License-Identifier: MIT
#include "results/decisions.h"

#include <variant>

#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const auto read = parse_decisions(std::string(text_of(data, size)));
  if (const auto* fault = std::get_if<std::string>(&read)) {
    promise(!fault->empty(), "a refusal has a reason");
    return 0;
  }
  for (const Decision& decision : std::get<std::vector<Decision>>(read))
    promise(!decision.reason.empty() && !decision.renderer.empty(),
            "a decision has a reason and a renderer");
  return 0;
}
