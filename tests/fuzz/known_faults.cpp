// SPDX-License-Identifier: MIT
#include "results/known_faults.h"

#include <variant>

#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const auto read = parse_known_faults(std::string(text_of(data, size)));
  if (const auto* fault = std::get_if<std::string>(&read)) {
    promise(!fault->empty(), "a refusal has a reason");
    return 0;
  }
  const std::string text = known_faults_text(std::get<KnownFaults>(read));
  const auto again = parse_known_faults(text);
  promise(std::holds_alternative<KnownFaults>(again), "what is written is read");
  promise(known_faults_text(std::get<KnownFaults>(again)) == text, "as the same");
  return 0;
}
