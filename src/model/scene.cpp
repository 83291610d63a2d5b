// SPDX-License-Identifier: MIT
#include "model/scene.h"

#include <cstddef>

namespace edgecase {
namespace {

template <class Enum>
struct Named {
  Enum value;
  const char* name;
};

constexpr Named<Primitive> kPrimitives[] = {{Primitive::points, "points"},
                                            {Primitive::lines, "lines"},
                                            {Primitive::triangles, "triangles"}};
constexpr Named<Interpolation> kInterpolations[] = {{Interpolation::flat, "flat"},
                                                    {Interpolation::smooth, "smooth"}};
constexpr Named<ProvokingVertex> kProvoking[] = {{ProvokingVertex::first, "first"},
                                                 {ProvokingVertex::last, "last"}};
constexpr Named<Surface> kSurfaces[] = {{Surface::fbo, "fbo"}};
constexpr Named<ColorFormat> kColorFormats[] = {{ColorFormat::rgba8, "rgba8"}};

template <class Enum, std::size_t N>
const char* find_name(const Named<Enum> (&table)[N], Enum value) {
  for (const auto& row : table)
    if (row.value == value) return row.name;
  return "?";
}

template <class Enum, std::size_t N>
bool find_value(const Named<Enum> (&table)[N], const std::string& name, Enum& value) {
  for (const auto& row : table) {
    if (name != row.name) continue;
    value = row.value;
    return true;
  }
  return false;
}

}  // namespace

const char* name_of(Primitive value) {
  return find_name(kPrimitives, value);
}
const char* name_of(Interpolation value) {
  return find_name(kInterpolations, value);
}
const char* name_of(ProvokingVertex value) {
  return find_name(kProvoking, value);
}
const char* name_of(Surface value) {
  return find_name(kSurfaces, value);
}
const char* name_of(ColorFormat value) {
  return find_name(kColorFormats, value);
}

bool parse_name(const std::string& name, Primitive& value) {
  return find_value(kPrimitives, name, value);
}
bool parse_name(const std::string& name, Interpolation& value) {
  return find_value(kInterpolations, name, value);
}
bool parse_name(const std::string& name, ProvokingVertex& value) {
  return find_value(kProvoking, name, value);
}
bool parse_name(const std::string& name, Surface& value) {
  return find_value(kSurfaces, name, value);
}
bool parse_name(const std::string& name, ColorFormat& value) {
  return find_value(kColorFormats, name, value);
}

std::vector<ScenePrimitive> primitives_of(const Scene& scene) {
  std::vector<ScenePrimitive> result;
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    const Draw& draw = scene.draws[d];
    const auto step = static_cast<std::size_t>(vertices_per_primitive(draw.primitive));
    for (std::size_t v = 0; v + step <= draw.vertices.size(); v += step)
      result.push_back(
          {static_cast<int>(result.size()), static_cast<int>(d), &draw, draw.vertices.data() + v});
  }
  return result;
}

}  // namespace edgecase
