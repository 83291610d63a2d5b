// SPDX-License-Identifier: MIT
//
// The example of reference/PROTOCOL.md as a renderer.
#pragma once

#include "tests/reference/drawings.h"

namespace edgecase {

inline Renderer& example() {
  static ProcessRenderer renderer([] {
    ProcessSpec spec;
    spec.name = "exec:example";
    spec.command.argv = {EDGECASE_PYTHON, EDGECASE_ROOT "/reference/examples/rasterizer.py"};
    return spec;
  }());
  return renderer;
}

}  // namespace edgecase
