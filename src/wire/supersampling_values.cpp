// SPDX-License-Identifier: MIT
#include "wire/supersampling_values.h"

#include <nlohmann/json.hpp>

namespace edgecase::wire {

using nlohmann::json;

namespace {

Fixed read_place(const json& value, const Path& path) {
  const Fixed place = read_fixed(value, path);
  if (place < Fixed::from_integer(-1) || place > Fixed::from_integer(2))
    throw Refusal(fmt::format("{} is {}, but it must be -1 to 2", path.text(), value.dump()));
  return place;
}

bool are_in_range(const Scene& scene, const Draw& draw, Point shift) {
  for (const Vertex& vertex : draw.vertices)
    if (!is_in_range(moved_vertex(vertex, shift, scene.viewport))) return false;
  return true;
}

}  // namespace

void write_supersampling(Output out, const Supersampling& passes) {
  *out++ = '[';
  for (std::size_t k = 0; k < passes.size(); ++k) {
    fmt::format_to(out, "{}", k == 0 ? "[" : ",[");
    write_number(out, passes[k].at.x.to_double());
    *out++ = ',';
    write_number(out, passes[k].at.y.to_double());
    fmt::format_to(out, ",{}]", passes[k].weight);
  }
  *out++ = ']';
}

Supersampling read_supersampling(const json& value, const Path& path, int samples) {
  if (samples != 1) throw Refusal(path.text() + " is there, but the target has several samples");
  require_array(value, path, value.size());
  if (value.empty() || value.size() > kMaxPasses)
    throw Refusal(fmt::format("{} has {} elements, but it must have 1 to {}", path.text(),
                              value.size(), kMaxPasses));
  Supersampling passes;
  for (std::size_t k = 0; k < value.size(); ++k) {
    const Path at(path, k);
    require_array(value[k], at, 3);
    const Fixed x = read_place(value[k][0], {at, std::size_t{0}});
    const Fixed y = read_place(value[k][1], {at, std::size_t{1}});
    passes.push_back({{x, y}, read_integer(value[k][2], {at, std::size_t{2}}, 1, kMaxPassWeight)});
  }
  return passes;
}

void check_passes(const Scene& scene, const Path& path) {
  if (pass_work(scene) > kMaxPassWork)
    throw Refusal(
        fmt::format("{} has {} passes, which draw {} pixels, texels and vertices, but "
                    "they must be at most {}",
                    path.text(), scene.supersampling.size(), pass_work(scene), kMaxPassWork));
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k)
    for (const Draw& draw : scene.draws)
      if (!are_in_range(scene, draw, shift_of(scene.supersampling[k])))
        throw Refusal(Path(path, k).text() + " moves a vertex out of its range");
}

}  // namespace edgecase::wire
