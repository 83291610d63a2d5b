// SPDX-License-Identifier: MIT
#include "rules/samples/attribute_location.h"

#include <bit>

#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

Point first_covered(const Invocation& invocation, const SamplePositions& positions) {
  return positions[static_cast<std::size_t>(std::countr_zero(invocation.coverage))];
}

Point mean_covered(const Invocation& invocation, const SamplePositions& positions) {
  const std::int64_t count = std::popcount(invocation.coverage);
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (std::size_t s = 0; s < positions.size(); ++s) {
    if ((invocation.coverage >> s & 1) == 0) continue;
    x += positions[s].x.raw();
    y += positions[s].y.raw();
  }
  const auto nearest = [&](std::int64_t sum) {
    return Fixed::from_raw((2 * sum + count) / (2 * count));
  };
  return {nearest(x), nearest(y)};
}

Point half_pixel_off(PrimitiveKind kind, Point place) {
  if (kind == PrimitiveKind::triangle) return place;
  const Fixed half = Fixed::from_raw(Fixed::kOne / 2);
  return {place.x + half, place.y + half};
}

Point mirrored_x(Point place) {
  return {Fixed::from_integer(1) - place.x, place.y};
}

Point centroid_location(const Invocation& invocation, const SamplePositions& positions,
                        CentroidLocation choice) {
  const std::uint32_t all = mask_of_all(static_cast<int>(positions.size()));
  switch (choice) {
    case CentroidLocation::centre_or_first:
      return invocation.coverage == all ? centre_of_pixel() : first_covered(invocation, positions);
    case CentroidLocation::first_covered:
      return first_covered(invocation, positions);
    case CentroidLocation::mean_covered:
      return mean_covered(invocation, positions);
    case CentroidLocation::centre:
      return centre_of_pixel();
  }
  return centre_of_pixel();
}

}  // namespace

Point attribute_location(AttributeLocation qualifier, const Invocation& invocation,
                         const SamplePositions& positions, const LocationChoice& choice) {
  Point place = centre_of_pixel();
  if (invocation.per_sample)
    place = first_covered(invocation, positions);
  else if (qualifier == AttributeLocation::centroid)
    place = centroid_location(invocation, positions, choice.centroid);
  else if (choice.plain == PlainLocation::first_covered)
    place = first_covered(invocation, positions);
  const bool is_off = choice.plain == PlainLocation::half_pixel_off;
  return is_off ? half_pixel_off(invocation.kind, place) : place;
}

Point coordinates_location(const Invocation& invocation, const SamplePositions& positions) {
  return invocation.per_sample ? first_covered(invocation, positions) : centre_of_pixel();
}

Point fragment_depth_location(const Invocation& invocation, const SamplePositions& positions,
                              const LocationChoice& choice) {
  const Point place = coordinates_location(invocation, positions);
  switch (choice.depth) {
    case DepthLocation::at_sample:
      return place;
    case DepthLocation::centre:
      return centre_of_pixel();
    case DepthLocation::mirrored_x:
    case DepthLocation::mirrored_x_or_zero:
      return mirrored_x(positions[0]);
    case DepthLocation::half_pixel_off:
      return half_pixel_off(invocation.kind, place);
  }
  return place;
}

bool fragment_depth_is_zero(const Multisampling& use, const LocationChoice& choice) {
  return choice.depth == DepthLocation::mirrored_x_or_zero && use.enabled && (use.mask & 1) == 0;
}

Point sample_depth_location(PrimitiveKind kind, Point sample, const LocationChoice& choice) {
  switch (choice.depth) {
    case DepthLocation::at_sample:
      return sample;
    case DepthLocation::centre:
      return centre_of_pixel();
    case DepthLocation::mirrored_x:
    case DepthLocation::mirrored_x_or_zero:
      return mirrored_x(sample);
    case DepthLocation::half_pixel_off:
      return half_pixel_off(kind, sample);
  }
  return sample;
}

bool is_at_sample(const Multisampling& use) {
  return use.location == AttributeLocation::sample || use.min_sample_shading == 1.0F;
}

Rule attribute_location_rule() {
  return {
      RuleId::attribute_location,
      "Attributes of a multisampled fragment are evaluated in its pixel",
      "14.3.1 (multisampling) and 14.3.1.1 (sample shading)",
      "anywhere in the pixel, unless the shader qualifies the attribute or runs for each sample",
      "centre",
      alternatives_of<PlainLocation>(),
      {{29,
        "Multisampled targets: an attribute without a qualifier may be evaluated anywhere in the "
        "fragment's pixel, boundary included, each one at a place of its own, and so may "
        "gl_FragCoord, which no qualifier concerns. Qualified sample, or under GL_SAMPLE_SHADING "
        "with a share of 1, attributes are evaluated at the sample that the invocation runs for, "
        "and with that share so is gl_FragCoord. The depth that is written to a sample is always "
        "evaluated there. With GL_MULTISAMPLE disabled attributes and gl_FragCoord are those of "
        "the centre or, whatever their qualifiers, of any place in the pixel; of depths see ruling "
        "35."}}};
}

Rule centroid_rule() {
  return {RuleId::attribute_centroid,
          "A centroid attribute is evaluated where its primitive covers the pixel",
          "14.3.1 (multisampling); GLSL 4.60, 4.5 (interpolation qualifiers)",
          "any place that lies both in the pixel and in the primitive",
          "centre-or-first",
          alternatives_of<CentroidLocation>(),
          {{30,
            "Attributes qualified centroid may be evaluated anywhere in what the pixel and the "
            "primitive (of a point its square, of a line its rectangle) have in common, boundaries "
            "included, for some position of each vertex less than one step of 2^-b away (b as in "
            "ruling "
            "4)."}}};
}

Rule sample_depth_rule() {
  return {RuleId::sample_depth,
          "Each sample has the depth at its own location",
          "14.3.1 (multisampling)",
          "none beyond that of values (ruling 29)",
          "at-sample",
          alternatives_of<DepthLocation>(),
          {}};
}

}  // namespace edgecase
