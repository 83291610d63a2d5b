// SPDX-License-Identifier: MIT
//
// Case files, sweeps among them. What is loaded is a scene that can be asked of a renderer; what is
// not has a place and a remedy.
#include <filesystem>
#include <variant>

#include "casefile/loader.h"
#include "tests/fuzz/target.h"
#include "wire/request_line.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const std::filesystem::path file = EDGECASE_ROOT "/tests/casefile/good/input.json";
  const LoadedCases loaded = load_cases_text(std::string(text_of(data, size)), file, "input");
  promise(loaded.cases.empty() == !loaded.diagnostics.empty(), "cases or faults");
  for (const Diagnostic& fault : loaded.diagnostics)
    promise(!fault.message.empty() && !fault.remedy.empty() && fault.line > 0,
            "a fault has a message, a remedy and a line");
  if (loaded.cases.empty()) return 0;
  const Case& one = loaded.cases.back();
  const std::string request = request_line(one.id, scene_json(one.scene));
  const auto read = parse_request(request);
  promise(std::holds_alternative<Request>(read), "a scene that is loaded can be asked for");
  promise(scene_json(std::get<Request>(read).scene) == scene_json(one.scene),
          "and is read as it was written");
  return 0;
}
