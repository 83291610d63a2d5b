// SPDX-License-Identifier: MIT
//
// libEGL, opened at run time: its functions for making contexts.
#pragma once

// avoids the X11 headers, since there is no window
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>
#include <string_view>
#include <vector>

namespace edgecase {

struct EglFunctions {
  decltype(eglGetProcAddress)* get_proc_address = nullptr;
  decltype(eglQueryString)* query_string = nullptr;
  decltype(eglGetDisplay)* get_display = nullptr;
  decltype(eglInitialize)* initialize = nullptr;
  decltype(eglTerminate)* terminate = nullptr;
  decltype(eglBindAPI)* bind_api = nullptr;
  decltype(eglChooseConfig)* choose_config = nullptr;
  decltype(eglGetConfigAttrib)* get_config_attribute = nullptr;
  decltype(eglCreateContext)* create_context = nullptr;
  decltype(eglCreatePbufferSurface)* create_pbuffer = nullptr;
  decltype(eglDestroySurface)* destroy_surface = nullptr;
  decltype(eglMakeCurrent)* make_current = nullptr;
  decltype(eglGetError)* get_error = nullptr;

  // Opens the library, which stays open: the system's or, unless `path` is empty, that file or the
  // one in that folder. Returns what is missing; empty if nothing is.
  std::string load(const std::string& path = "");

  // An optional function; null if there is none.
  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(get_proc_address(name));
  }
};

// Does a list of extensions, separated by spaces, have this one? Null is an empty list.
bool has_extension(const char* list, std::string_view name);

// The devices of EGL_EXT_device_enumeration, in order. Returns why they cannot be listed; empty on
// success.
std::string list_devices(const EglFunctions& egl, std::vector<EGLDeviceEXT>& devices);

// What EGL says of a device, its parts separated by spaces: its renderer and vendor
// (EGL_EXT_device_query_name), its file (EGL_EXT_device_drm), and its extensions, of which
// EGL_MESA_device_software marks Mesa's own.
std::string describe_device(const EglFunctions& egl, EGLDeviceEXT device);

}  // namespace edgecase
