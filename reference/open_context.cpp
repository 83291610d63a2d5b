// SPDX-License-Identifier: MIT
#include <charconv>
#include <string_view>

#include "reference/egl_context.h"
#include "reference/gl_context.h"
#include "reference/osmesa_context.h"

namespace edgecase {

namespace {

struct DevicePrefix {
  std::string_view text;
  GlApi api;
};
constexpr DevicePrefix kDevicePrefixes[] = {{"egl-device:", GlApi::opengl},
                                            {"egl-es-device:", GlApi::opengl_es}};

// The number after the prefix; -1 if there is none.
int device_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return -1;
  int index = -1;
  const char* end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, index);
  return error == std::errc() && stop == end ? index : -1;
}

ContextResult make_context(const std::string& name) {
  if (name == "osmesa") return make_osmesa_context();
  if (name == "egl-surfaceless") return make_egl_surfaceless_context(GlApi::opengl);
  if (name == "egl-es-surfaceless") return make_egl_surfaceless_context(GlApi::opengl_es);
  for (const auto& [prefix, api] : kDevicePrefixes)
    if (const int index = device_of(name, prefix); index >= 0)
      return make_egl_device_context(api, index);
  return ContextError{"there is no context '" + name +
                      "'; known are osmesa, egl-surfaceless, egl-device:N, egl-es-surfaceless and "
                      "egl-es-device:N"};
}

}  // namespace

ContextResult open_context(const std::string& name) {
  ContextResult result = make_context(name);
  if (auto* context = std::get_if<std::unique_ptr<GlContext>>(&result))
    if (!(*context)->make_current())
      return ContextError{(*context)->description() + " refuses to make its context current"};
  return result;
}

}  // namespace edgecase
