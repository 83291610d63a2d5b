// SPDX-License-Identifier: MIT
#include "casefile/numbers.h"
#include "casefile/scene_reader.h"
#include "casefile/viewport.h"

namespace edgecase {
namespace {

const Keys kTargetKeys{{"width", "height"},
                       {"samples", "color", "surface", "clear", "viewport"},
                       {"depth", "stencil", "sample_positions", "supersample"}};
const Keys kViewportKeys{{"x", "y", "width", "height"}, {}, {}};

void read_into(const ObjectReader& object, const char* name, IntegerRange range, Findings& findings,
               int& value) {
  const auto place = object.find(name);
  if (!place) return;
  value = read_integer(*place, name, range, findings).value_or(value);
}

void read_samples(const Place& place, Findings& findings) {
  constexpr int kMostSamples = 64;
  const auto samples = read_integer(place, "samples", {1, kMostSamples}, findings);
  if (samples && *samples != 1)
    findings.add(place, "more than one sample is not supported yet", "write 1, or leave it out");
}

std::optional<Viewport> read_viewport(const Place& place, Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, "a viewport", kViewportKeys, findings);
  Viewport viewport;
  read_into(object, "x", {-kMaxViewportSize, kMaxViewportSize}, findings, viewport.x);
  read_into(object, "y", {-kMaxViewportSize, kMaxViewportSize}, findings, viewport.y);
  read_into(object, "width", {1, kMaxViewportSize}, findings, viewport.width);
  read_into(object, "height", {1, kMaxViewportSize}, findings, viewport.height);
  if (findings.size() != before) return std::nullopt;
  return viewport;
}

}  // namespace

TargetFields read_target(const Place& place, Findings& findings) {
  TargetFields fields;
  const ObjectReader object(place, "a target", kTargetKeys, findings);
  read_into(object, "width", {1, kMaxTargetSize}, findings, fields.target.width);
  read_into(object, "height", {1, kMaxTargetSize}, findings, fields.target.height);
  if (const auto samples = object.find("samples")) read_samples(*samples, findings);
  if (const auto color = object.find("color"))
    read_enum(*color, "a colour format", {{"rgba8"}, {}}, findings, fields.target.color);
  if (const auto surface = object.find("surface"))
    read_enum(*surface, "a surface", {{"fbo"}, {"window"}}, findings, fields.target.surface);
  if (const auto clear = object.find("clear"))
    fields.clear = read_color(*clear, "a clear colour", findings);
  if (const auto viewport = object.find("viewport"))
    fields.viewport = read_viewport(*viewport, findings);
  return fields;
}

}  // namespace edgecase
