// SPDX-License-Identifier: MIT
#include "reference/egl_library.h"

#include "reference/shared_library.h"

namespace edgecase {

std::string EglFunctions::load() {
  const SharedLibrary library({"libEGL.so.1", "libEGL.so"});
  if (!library.is_open()) return "EGL cannot be opened: " + library.error();
  const bool complete =
      library.load("eglGetProcAddress", get_proc_address) &&
      library.load("eglQueryString", query_string) && library.load("eglInitialize", initialize) &&
      library.load("eglTerminate", terminate) && library.load("eglBindAPI", bind_api) &&
      library.load("eglChooseConfig", choose_config) &&
      library.load("eglGetConfigAttrib", get_config_attribute) &&
      library.load("eglCreateContext", create_context) &&
      library.load("eglCreatePbufferSurface", create_pbuffer) &&
      library.load("eglDestroySurface", destroy_surface) &&
      library.load("eglMakeCurrent", make_current) && library.load("eglGetError", get_error);
  return complete ? "" : "libEGL.so.1 lacks functions of EGL 1.4";
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

}  // namespace edgecase
