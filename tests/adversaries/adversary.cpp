// SPDX-License-Identifier: MIT
//
// adversary NAME: a renderer behind `exec:` (reference/PROTOCOL.md) with the freedoms of that name,
// or the crime. Without a name: all names, a line each, "legal" or "crime" before it.
#include <cstdio>
#include <iostream>
#include <string>
#include <variant>

#include "tests/adversaries/drawing.h"
#include "wire/answer_line.h"
#include "wire/request_line.h"

int main(int count, char** words) {
  using namespace edgecase;
  std::ios::sync_with_stdio(false);
  if (count < 2) {
    adversary::print_names();
    return 0;
  }
  const adversary::Freedoms* freedoms = adversary::find(words[1]);
  if (freedoms == nullptr) {
    std::fprintf(stderr, "no adversary is called '%s'\n", words[1]);
    return 3;
  }
  // The release of which known faults are recorded: under the name of a driver, they apply.
  RendererInfo info{"", "Edgecase", "Mesa 22.3.6", "adversary", freedoms->bits, {}};
  for (std::string line; std::getline(std::cin, line);) {
    const auto request = parse_request(line);
    if (const auto* error = std::get_if<WireError>(&request)) {
      std::cerr << error->message << '\n';
      return 1;
    }
    const auto& [id, digest, scene, coverage_only] = std::get<Request>(request);
    const Rendering rendering = adversary::draw(scene, *freedoms);
    std::cout << answer_line(digest, rendering, &info) << std::endl;
  }
}
