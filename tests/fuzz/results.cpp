// SPDX-License-Identifier: MIT
//
// Results files. What is read can be written, and is read again as the same.
#include <sstream>
#include <variant>

#include "results/results_json.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const auto read = read_results(std::string(text_of(data, size)));
  if (const auto* fault = std::get_if<std::string>(&read)) {
    promise(!fault->empty(), "a refusal has a reason");
    return 0;
  }
  std::ostringstream first;
  write_results(std::get<Results>(read), first);
  const auto again = read_results(first.str());
  promise(std::holds_alternative<Results>(again), "what is written is read");
  std::ostringstream second;
  write_results(std::get<Results>(again), second);
  promise(first.str() == second.str(), "as the same");
  return 0;
}
