// SPDX-License-Identifier: MIT
#include <charconv>

#include "reference/egl_context.h"
#include "reference/gl_context.h"
#include "reference/osmesa_context.h"

namespace edgecase {

namespace {

constexpr std::string_view kDevicePrefix = "egl-device:";

ContextResult make_context(const std::string& name) {
  if (name == "osmesa") return make_osmesa_context();
  if (name == "egl-surfaceless") return make_egl_surfaceless_context();
  int index = -1;
  const char* end = name.data() + name.size();
  if (name.starts_with(kDevicePrefix)) {
    const auto [stop, error] = std::from_chars(name.data() + kDevicePrefix.size(), end, index);
    if (error != std::errc() || stop != end) index = -1;
  }
  if (index >= 0) return make_egl_device_context(index);
  return ContextError{"there is no context '" + name +
                      "'; known are osmesa, egl-surfaceless and egl-device:N"};
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
