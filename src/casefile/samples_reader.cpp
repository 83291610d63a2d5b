// SPDX-License-Identifier: MIT
#include "casefile/samples_reader.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "casefile/plain_fields.h"
#include "casefile/text.h"

namespace edgecase {
namespace {

// Of all pixels of a target: the largest one with one each.
constexpr int kMaxTargetSamples = 1 << 24;
// Within a pixel: 0 to below 1.
constexpr FixedRange kWithinPixel{Fixed(), Fixed::from_raw(Fixed::kOne - 1)};

constexpr const char* kMask = "sample_mask";

Point read_position(const Place& place, Findings& findings) {
  if (!expect_count(place, "a sample position", 2, findings)) return {};
  const auto read = [&](std::size_t index, const char* what) {
    return read_coordinate(place.child(index), what, kWithinPixel, findings).value_or(Fixed());
  };
  return {read(0, "x of a sample"), read(1, "y of a sample")};
}

SamplePositions read_positions(const Place& place, int samples, Findings& findings) {
  SamplePositions positions;
  if (!expect_kind(place, JsonKind::array, "sample_positions", findings)) return positions;
  const std::size_t count = place.node->children.size();
  if (samples > 0 && count != static_cast<std::size_t>(samples))
    findings.add(
        place,
        fmt::format("sample_positions has {} points, and the target {} samples", count, samples),
        fmt::format("write {} points [x, y]", samples));
  for (std::size_t i = 0; i < count; ++i)
    positions.push_back(read_position(place.child(i), findings));
  return positions;
}

// Nothing of it would count, and what is ignored would pass for tested.
void refuse_of_one_sample(const ObjectReader& state, Findings& findings) {
  for (const std::string& name : multisampling_keys())
    if (const auto place = state.find(name))
      findings.add_key(*place,
                       fmt::format("{} is for several samples, and the target has 1", quote(name)),
                       "write \"samples\": 4 into the target, or remove the key");
}

}  // namespace

std::vector<std::string> multisampling_keys() {
  std::vector<std::string> keys = plain_keys<Multisampling>();
  keys.emplace_back(kMask);
  return keys;
}

void read_samples(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  Target& target = fields.target;
  if (const auto samples = object.find("samples"))
    target.samples = read_integer(*samples, "samples", {1, kMaxSamples}, findings).value_or(0);
  const int all = target.width * target.height * target.samples;  // at most 2^28
  if (all > kMaxTargetSamples)
    findings.add(*object.find("samples"),
                 fmt::format("{} x {} pixels of {} samples are {} samples", target.width,
                             target.height, target.samples, all),
                 fmt::format("use fewer samples or a smaller target: {} samples at most in all",
                             kMaxTargetSamples));
  const auto surface = object.find("surface");
  if (surface && target.samples > 1 && target.surface == Surface::window)
    findings.add(*surface, "a window's samples cannot be chosen",
                 "write \"fbo\", or \"samples\": 1");
  fields.positions_place = object.find("sample_positions");
  if (!fields.positions_place) return;
  if (target.samples == 1)
    findings.add_key(*fields.positions_place,
                     "\"sample_positions\" is for several samples, and the target has 1",
                     "write \"samples\", the number of points, or remove the key");
  else
    target.sample_positions = read_positions(*fields.positions_place, target.samples, findings);
}

Multisampling read_multisampling(const ObjectReader& state, int samples, Findings& findings) {
  Multisampling result;
  if (samples == 1) {
    refuse_of_one_sample(state, findings);
    return result;
  }
  read_fields(state, findings, result);
  const int bits = samples > 0 ? samples : kMaxSamples;
  if (const auto mask = state.find(kMask))
    if (const auto value = read_integer(*mask, kMask, {0, (1 << bits) - 1}, findings))
      result.mask = static_cast<std::uint32_t>(*value);
  return result;
}

}  // namespace edgecase
