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
#include <vector>

namespace edgecase {

struct EglFunctions {
  decltype(eglGetProcAddress)* get_proc_address = nullptr;
  decltype(eglQueryString)* query_string = nullptr;
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

  // Opens the library, which stays open. Returns what is missing; empty if nothing is.
  std::string load();

  // An optional function; null if there is none.
  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(get_proc_address(name));
  }
};

// The devices of EGL_EXT_device_enumeration, in order. Returns why they cannot be listed; empty on
// success.
std::string list_devices(const EglFunctions& egl, std::vector<EGLDeviceEXT>& devices);

}  // namespace edgecase
