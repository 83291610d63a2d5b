// SPDX-License-Identifier: MIT
#include "casefile/sweep/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/scene/viewport.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

const Names kVariantNames{{"reverse", "winding", "octants", "translate"}, {}};
constexpr int kOctants = 8;
constexpr int kStepX = 3;  // of translate, pixels
constexpr int kStepY = 2;

using Vertices = std::vector<VertexFields>;

bool is_separate(Primitive primitive) {
  return primitive == Primitive::points || primitive == Primitive::lines ||
         primitive == Primitive::triangles;
}

void reverse(Primitive primitive, Vertices& vertices) {
  const auto each = static_cast<std::ptrdiff_t>(vertices_of(kind_of(primitive)));
  if (is_separate(primitive)) {
    for (auto at = vertices.begin(); at != vertices.end(); at += each) std::reverse(at, at + each);
    return;
  }
  const bool hub = primitive == Primitive::triangle_fan;
  std::reverse(vertices.begin() + (hub ? 1 : 0), vertices.end());
}

void turn_winding(Vertices& vertices) {
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3)
    std::swap(vertices[i + 1], vertices[i + 2]);
}

void mirror(int size, int& origin, int extent) {
  origin = size - origin - extent;
}

void exchange(Viewport& rectangle) {
  std::swap(rectangle.x, rectangle.y);
  std::swap(rectangle.width, rectangle.height);
}

Viewport octant_of(Viewport rectangle, int octant, const Target& target) {
  if (octant & 1) mirror(target.width, rectangle.x, rectangle.width);
  if (octant & 2) mirror(target.height, rectangle.y, rectangle.height);
  if (octant & 4) exchange(rectangle);
  return rectangle;
}

// Turns about the viewport's centre, which itself turns with the target. -0 becomes 0.
void turn_clip(ClipPosition& clip, int octant) {
  if (octant & 1) clip.x = 0.0F - clip.x;
  if (octant & 2) clip.y = 0.0F - clip.y;
  if (octant & 4) std::swap(clip.x, clip.y);
}

void turn_vertex(VertexFields& fields, int octant, const Target& target) {
  if (fields.vertex.clip) {
    turn_clip(*fields.vertex.clip, octant);
    return;
  }
  Point& at = fields.vertex.position;
  if (octant & 1) at.x = Fixed::from_integer(target.width) - at.x;
  if (octant & 2) at.y = Fixed::from_integer(target.height) - at.y;
  if ((octant & 4) == 0) return;
  std::swap(at.x, at.y);
  std::swap(fields.x, fields.y);
}

// Gradients of a lookup are changes along the window's x and y. -0 becomes 0.
void turn_gradients(Lookup& lookup, int octant) {
  for (float& change : lookup.dx) change = 0.0F + ((octant & 1) ? -change : change);
  for (float& change : lookup.dy) change = 0.0F + ((octant & 2) ? -change : change);
  if (octant & 4) std::swap(lookup.dx, lookup.dy);
}

// A sample turns about its pixel's centre, as the pixel turns within the target, and keeps its
// index.
void turn_position(Point& within, int octant) {
  if (octant & 1) within.x = Fixed::from_integer(1) - within.x;
  if (octant & 2) within.y = Fixed::from_integer(1) - within.y;
  if (octant & 4) std::swap(within.x, within.y);
}

void settle_viewport(TargetFields& target, const std::vector<DrawFields>& draws) {
  if (target.viewport) return;
  const bool any = std::any_of(draws.begin(), draws.end(), [](const DrawFields& draw) {
    return std::any_of(draw.vertices.begin(), draw.vertices.end(),
                       [](const VertexFields& fields) { return fields.vertex.clip.has_value(); });
  });
  if (any) target.viewport = clip_viewport(target.target);
}

void turn(int octant, TargetFields& target, std::vector<DrawFields>& draws) {
  for (DrawFields& draw : draws) {
    for (VertexFields& vertex : draw.vertices) turn_vertex(vertex, octant, target.target);
    if (draw.draw.scissor) draw.draw.scissor = octant_of(*draw.draw.scissor, octant, target.target);
    if (draw.draw.texture) turn_gradients(draw.draw.texture->lookup, octant);
  }
  if (target.viewport) target.viewport = octant_of(*target.viewport, octant, target.target);
  for (Point& within : target.target.sample_positions) turn_position(within, octant);
  for (ShadingPass& pass : target.supersampling) turn_position(pass.at, octant);
  if (octant & 4) std::swap(target.target.width, target.target.height);
}

void move_rectangle(std::optional<Viewport>& rectangle) {
  if (!rectangle) return;
  rectangle->x += kStepX;
  rectangle->y += kStepY;
}

void move_all(TargetFields& target, std::vector<DrawFields>& draws) {
  for (DrawFields& draw : draws) {
    for (VertexFields& vertex : draw.vertices) {
      Point& at = vertex.vertex.position;
      at = {at.x + Fixed::from_integer(kStepX), at.y + Fixed::from_integer(kStepY)};
    }
    move_rectangle(draw.draw.scissor);
  }
  move_rectangle(target.viewport);
  target.target.width += kStepX;
  target.target.height += kStepY;
}

constexpr const char* kVariant = "the variant";

void check_rectangle(const std::optional<Viewport>& rectangle, const char* mover, const char* what,
                     const Place& place, Findings& findings) {
  if (!rectangle) return;
  if (std::max(std::abs(rectangle->x), std::abs(rectangle->y)) <= kMaxViewportSize) return;
  findings.add(
      place,
      fmt::format("{} moves {} to ({}, {}), out of range", mover, what, rectangle->x, rectangle->y),
      fmt::format("keep corners from -{0} to {0}", kMaxViewportSize));
}

void check_vertex(const VertexFields& fields, const char* mover, Findings& findings) {
  const std::pair<const std::optional<Place>&, Fixed> coordinates[] = {
      {fields.x, fields.vertex.position.x}, {fields.y, fields.vertex.position.y}};
  for (const auto& [place, value] : coordinates)
    if (place && !value.in_coordinate_range())
      findings.add(
          *place,
          fmt::format("{} moves a coordinate to {}, out of range", mover, to_decimal(value)),
          "move the vertex nearer to the target");
}

// The image of a pixel's left side is its right side, which belongs to the next pixel.
void check_positions(const TargetFields& target, const char* mover, Findings& findings) {
  for (const Point within : target.target.sample_positions)
    if (std::max(within.x, within.y) >= Fixed::from_integer(1)) {
      findings.add(*target.positions_place,
                   fmt::format("{} moves a sample to ({}, {}), out of its pixel", mover,
                               to_decimal(within.x), to_decimal(within.y)),
                   "give positions above 0, whose images lie below 1");
      return;
    }
}

void check_ranges(const TargetFields& target, const std::vector<DrawFields>& draws,
                  const char* mover, const Place& draws_place, Findings& findings) {
  if (std::max(target.target.width, target.target.height) > kMaxTargetSize)
    findings.add(draws_place,
                 fmt::format("{} needs a target of {} x {} pixels", mover, target.target.width,
                             target.target.height),
                 fmt::format("use a target that leaves room below {} pixels", kMaxTargetSize));
  check_rectangle(target.viewport, mover, "the viewport", draws_place, findings);
  check_positions(target, mover, findings);
  for (const DrawFields& draw : draws) {
    check_rectangle(draw.draw.scissor, mover, "a scissor", draws_place, findings);
    for (const VertexFields& vertex : draw.vertices) check_vertex(vertex, mover, findings);
  }
}

void check_variant(const Place& place, const std::vector<DrawFields>& draws, Findings& findings) {
  const bool only_points = std::all_of(draws.begin(), draws.end(), [](const DrawFields& fields) {
    return fields.draw.primitive == Primitive::points;
  });
  if (place.node->text == "reverse" && only_points)
    findings.add(place, "points have no order to reverse", "remove the variant");
  if (place.node->text != "winding") return;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const Primitive primitive = draws[i].draw.primitive;
    if (primitive == Primitive::triangles) continue;
    findings.add(place,
                 fmt::format("\"winding\" is for separate triangles, and draw {} has {}", i,
                             name_of(primitive)),
                 "remove the variant, or use \"reverse\"");
  }
}

void append_images(const std::string& name, std::vector<Image>& images) {
  if (name == "reverse") images.push_back({VariantKind::reverse, 0});
  if (name == "winding") images.push_back({VariantKind::winding, 0});
  if (name == "translate") images.push_back({VariantKind::translate, 0});
  if (name != "octants") return;
  for (int octant = 1; octant < kOctants; ++octant) images.push_back({VariantKind::octant, octant});
}

}  // namespace

std::string Image::part() const {
  switch (kind) {
    case VariantKind::none:
      return "";
    case VariantKind::reverse:
      return "reverse";
    case VariantKind::winding:
      return "winding";
    case VariantKind::octant:
      return fmt::format("octant={}", octant);
    case VariantKind::translate:
      return fmt::format("translate={},{}", kStepX, kStepY);
  }
  return "";
}

const std::vector<std::string>& variant_names() {
  return kVariantNames.allowed;
}

Variants read_variants(const Place& place, Findings& findings) {
  Variants variants;
  variants.images.push_back({});
  if (!expect_kind(place, JsonKind::array, "variants", findings)) return variants;
  if (place.node->children.empty())
    findings.add(place, "variants are empty",
                 "name one of " + join_names(kVariantNames.allowed) + ", or remove the key");
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place item = place.child(i);
    const auto name = read_choice(item, "a variant", kVariantNames, findings);
    if (!name) continue;
    if (std::find(seen.begin(), seen.end(), *name) != seen.end()) {
      findings.add(item, fmt::format("{} stands twice in variants", quote(*name)), "keep one");
      continue;
    }
    seen.push_back(*name);
    variants.places.push_back(item);
    append_images(*name, variants.images);
  }
  return variants;
}

void check_variants(const Variants& variants, const std::vector<DrawFields>& draws,
                    Findings& findings) {
  for (const Place& place : variants.places) check_variant(place, draws, findings);
}

void apply_image(const Image& image, TargetFields& target, std::vector<DrawFields>& draws,
                 const Place& draws_place, Findings& findings) {
  settle_viewport(target, draws);
  switch (image.kind) {
    case VariantKind::none:
      return;
    case VariantKind::reverse:
      for (DrawFields& draw : draws) reverse(draw.draw.primitive, draw.vertices);
      return;
    case VariantKind::winding:
      for (DrawFields& draw : draws) turn_winding(draw.vertices);
      return;
    case VariantKind::octant:
      turn(image.octant, target, draws);
      break;
    case VariantKind::translate:
      move_all(target, draws);
      break;
  }
  check_ranges(target, draws, kVariant, draws_place, findings);
}

void turn_y_up(TargetFields& target, std::vector<DrawFields>& draws, const Place& draws_place,
               Findings& findings) {
  settle_viewport(target, draws);
  constexpr int kMirrorY = 2;
  turn(kMirrorY, target, draws);
  check_ranges(target, draws, "\"y\": \"down\"", draws_place, findings);
}

}  // namespace edgecase
