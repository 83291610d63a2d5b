// SPDX-License-Identifier: MIT
#include "reference/egl_library.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <system_error>

#include "reference/shared_library.h"

namespace edgecase {

namespace {

SharedLibrary open_library(const std::string& path) {
  if (path.empty()) return SharedLibrary({"libEGL.so.1", "libEGL.so"});
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return SharedLibrary({path.c_str()});
  return SharedLibrary({(path + "/libEGL.so.1").c_str(), (path + "/libEGL.so").c_str()});
}

}  // namespace

std::string EglFunctions::load(const std::string& path) {
  const SharedLibrary library = open_library(path);
  if (!library.is_open()) return "EGL cannot be opened: " + library.error();
  const bool complete =
      library.load("eglGetProcAddress", get_proc_address) &&
      library.load("eglQueryString", query_string) && library.load("eglGetDisplay", get_display) &&
      library.load("eglInitialize", initialize) && library.load("eglTerminate", terminate) &&
      library.load("eglBindAPI", bind_api) && library.load("eglChooseConfig", choose_config) &&
      library.load("eglGetConfigAttrib", get_config_attribute) &&
      library.load("eglCreateContext", create_context) &&
      library.load("eglCreatePbufferSurface", create_pbuffer) &&
      library.load("eglDestroySurface", destroy_surface) &&
      library.load("eglMakeCurrent", make_current) && library.load("eglGetError", get_error);
  return complete ? "" : (path.empty() ? "libEGL.so.1" : path) + " lacks functions of EGL 1.4";
}

bool has_extension(const char* list, std::string_view name) {
  std::istringstream words(list == nullptr ? "" : list);
  return std::find(std::istream_iterator<std::string>(words), {}, name) !=
         std::istream_iterator<std::string>();
}

std::string list_devices(const EglFunctions& egl, std::vector<EGLDeviceEXT>& devices) {
  const auto query_devices = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (query_devices == nullptr || query_devices(0, nullptr, &count) != EGL_TRUE)
    return "this EGL cannot list its devices";
  devices.resize(static_cast<std::size_t>(count));
  if (count > 0 && query_devices(count, devices.data(), &count) != EGL_TRUE)
    return "this EGL cannot list its devices";
  devices.resize(static_cast<std::size_t>(count));
  return "";
}

std::string describe_device(const EglFunctions& egl, EGLDeviceEXT device) {
  const auto query = egl.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const char* const extensions = query == nullptr ? nullptr : query(device, EGL_EXTENSIONS);
  if (extensions == nullptr) return "";
  struct Part {
    const char* extension;
    EGLint name;
  };
  constexpr Part kParts[] = {{"EGL_EXT_device_query_name", EGL_RENDERER_EXT},
                             {"EGL_EXT_device_query_name", EGL_VENDOR},
                             {"EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT}};
  std::string text;
  for (const auto& [extension, name] : kParts) {
    if (!has_extension(extensions, extension)) continue;
    const char* const value = query(device, name);
    if (value != nullptr) text += std::string(value) + ' ';
  }
  return text + extensions;
}

}  // namespace edgecase
