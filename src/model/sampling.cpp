// SPDX-License-Identifier: MIT
#include "model/sampling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/name_table.h"

namespace edgecase {
namespace {

constexpr Named<AttributeLocation> kLocations[] = {
    {AttributeLocation::center, "center"},
    {AttributeLocation::centroid, "centroid"},
    {AttributeLocation::sample, "sample"},
};

}  // namespace

Point place_in(PixelPosition pixel, Point within) {
  return {Fixed::from_integer(pixel.x) + within.x, Fixed::from_integer(pixel.y) + within.y};
}

int least_invocations(const Multisampling& multisampling, int samples) {
  if (!multisampling.enabled) return 1;
  if (multisampling.location == AttributeLocation::sample) return samples;
  // A float32 times a small integer is exact in a double.
  const double share = static_cast<double>(multisampling.min_sample_shading.value_or(0));
  return std::clamp(static_cast<int>(std::ceil(share * samples)), 1, samples);
}

const char* name_of(AttributeLocation location) {
  return find_name(kLocations, location);
}

bool parse_name(const std::string& name, AttributeLocation& value) {
  return find_value(kLocations, name, value);
}

}  // namespace edgecase
