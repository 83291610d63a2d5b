// SPDX-License-Identifier: MIT
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "reference/egl_context.h"
#include "reference/gl_context.h"
#include "reference/osmesa_context.h"

namespace edgecase {

namespace {

// The number that the text is; -1 for any other text.
int number_of(std::string_view text) {
  int number = -1;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? number : -1;
}

// The context of EGL that the text behind "egl-" or "egl-es-" names; nothing if it names none.
std::optional<ContextResult> make_egl_context(std::string_view name, GlApi api) {
  if (name == "surfaceless") return make_egl_surfaceless_context(api);
  constexpr std::string_view kDevice = "device:";
  constexpr std::string_view kLibrary = "lib:";
  if (name.starts_with(kLibrary))
    return make_egl_library_context(api, std::string(name.substr(kLibrary.size())));
  if (!name.starts_with(kDevice) || name == kDevice) return std::nullopt;
  const std::string device(name.substr(kDevice.size()));
  const int index = number_of(device);
  return index >= 0 ? make_egl_device_context(api, index) : make_egl_device_context(api, device);
}

ContextResult make_context(const std::string& name) {
  constexpr std::string_view kEgl = "egl-";
  constexpr std::string_view kEs = "egl-es-";
  if (name == "osmesa") return make_osmesa_context();
  const std::string_view text = name;
  std::optional<ContextResult> result;
  if (text.starts_with(kEs))
    result = make_egl_context(text.substr(kEs.size()), GlApi::opengl_es);
  else if (text.starts_with(kEgl))
    result = make_egl_context(text.substr(kEgl.size()), GlApi::opengl);
  if (result) return *std::move(result);
  return ContextError{"there is no context '" + name +
                      "'; known are osmesa, egl-surfaceless, egl-device:N, egl-device:NAME and "
                      "egl-lib:PATH, the last four for OpenGL ES with egl-es- in place of egl-"};
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
