// SPDX-License-Identifier: MIT
#include "casefile/mesh/mesh.h"

#include <cmath>

#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  const LoadedMesh loaded = parse_mesh(std::string(text_of(data, size)));
  promise(loaded.mesh.empty() == !loaded.message.empty(), "a mesh or a message");
  promise(loaded.message.empty() == loaded.remedy.empty(), "a message has a remedy");
  promise(loaded.mesh.size() % 3 == 0, "three vertices a triangle");
  for (const MeshVertex& vertex : loaded.mesh)
    for (const float component : vertex.position)
      promise(std::isfinite(component), "positions are finite");
  return 0;
}
