// SPDX-License-Identifier: MIT
#include "casefile/fragment_operations.h"
#include "casefile/plain_fields.h"
#include "casefile/samples_reader.h"
#include "casefile/scene_reader.h"
#include "casefile/supersample_reader.h"
#include "casefile/viewport.h"

namespace edgecase {
namespace {

Keys target_keys() {
  Keys keys{{"width", "height"},
            {"samples", "sample_positions", "depth", "clear", "viewport", "y", "supersample"},
            {}};
  for (std::string& name : plain_keys<Target>()) keys.optional.push_back(std::move(name));
  for (std::string& name : target_operation_keys()) keys.optional.push_back(std::move(name));
  return keys;
}
const Keys kRectangleKeys{{"x", "y", "width", "height"}, {}, {}};

void read_into(const ObjectReader& object, const char* name, IntegerRange range, Findings& findings,
               int& value) {
  const auto place = object.find(name);
  if (!place) return;
  value = read_integer(*place, name, range, findings).value_or(value);
}

}  // namespace

std::optional<Viewport> read_rectangle(const Place& place, std::string_view what, int least_size,
                                       Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, what, kRectangleKeys, findings);
  Viewport rectangle;
  read_into(object, "x", {-kMaxViewportSize, kMaxViewportSize}, findings, rectangle.x);
  read_into(object, "y", {-kMaxViewportSize, kMaxViewportSize}, findings, rectangle.y);
  read_into(object, "width", {least_size, kMaxViewportSize}, findings, rectangle.width);
  read_into(object, "height", {least_size, kMaxViewportSize}, findings, rectangle.height);
  if (findings.size() != before) return std::nullopt;
  return rectangle;
}

TargetFields read_target(const Place& place, Findings& findings) {
  static const Keys kTargetKeys = target_keys();
  TargetFields fields;
  const ObjectReader object(place, "a target", kTargetKeys, findings);
  fields.depth_known = fields.stencil_known = object.valid();
  read_fields(object, findings, fields.target);
  if (const auto depth = object.find("depth"))
    fields.depth_known = read_plain(*depth, "a depth format", {}, findings, fields.target.depth);
  read_samples(object, fields, findings);
  read_supersample(object, fields, findings);
  read_target_operations(object, fields, findings);
  if (const auto clear = object.find("clear"))
    fields.clear = read_color(*clear, "a clear colour", {0, 1}, findings);
  if (const auto viewport = object.find("viewport"))
    fields.viewport = read_rectangle(*viewport, "a viewport", 1, findings);
  if (const auto y = object.find("y"))
    fields.y_down = read_choice(*y, "the direction of y", {{"up", "down"}, {}}, findings) == "down";
  return fields;
}

}  // namespace edgecase
