// SPDX-License-Identifier: MIT
#include "results/expectations.h"

#include <variant>

#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const auto read = parse_expectations(std::string(text_of(data, size)));
  if (const auto* fault = std::get_if<std::string>(&read)) {
    promise(!fault->empty(), "a refusal has a reason");
    return 0;
  }
  const std::string text = expectations_text(std::get<Expectations>(read));
  const auto again = parse_expectations(text);
  promise(std::holds_alternative<Expectations>(again), "what is written is read");
  promise(expectations_text(std::get<Expectations>(again)) == text, "as the same");
  return 0;
}
