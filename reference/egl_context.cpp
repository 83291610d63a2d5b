// SPDX-License-Identifier: MIT
#include "reference/egl_context.h"

// Keeps the X11 headers out; there is no window.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "reference/shared_library.h"

namespace edgecase {

namespace {

struct EglFunctions {
  decltype(eglGetProcAddress)* get_proc_address = nullptr;
  decltype(eglQueryString)* query_string = nullptr;
  decltype(eglInitialize)* initialize = nullptr;
  decltype(eglTerminate)* terminate = nullptr;
  decltype(eglBindAPI)* bind_api = nullptr;
  decltype(eglChooseConfig)* choose_config = nullptr;
  decltype(eglCreateContext)* create_context = nullptr;
  decltype(eglMakeCurrent)* make_current = nullptr;
  decltype(eglGetError)* get_error = nullptr;

  bool load(const SharedLibrary& library) {
    return library.load("eglGetProcAddress", get_proc_address) &&
           library.load("eglQueryString", query_string) &&
           library.load("eglInitialize", initialize) && library.load("eglTerminate", terminate) &&
           library.load("eglBindAPI", bind_api) && library.load("eglChooseConfig", choose_config) &&
           library.load("eglCreateContext", create_context) &&
           library.load("eglMakeCurrent", make_current) && library.load("eglGetError", get_error);
  }

  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(get_proc_address(name));
  }
};

// The display owns its contexts: terminating it frees them.
class EglContext final : public GlContext {
 public:
  EglContext(const EglFunctions& egl, EGLDisplay display, std::string description)
      : egl_(egl), display_(display), description_(std::move(description)) {}
  ~EglContext() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.terminate(display_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void set_context(EGLContext context) { context_ = context; }

  bool make_current() override {
    return egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  GlFunction get_proc(const char* name) const override { return egl_.get_proc_address(name); }
  std::string description() const override { return description_; }

 private:
  EglFunctions egl_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string description_;
};

EGLContext create_core_context(const EglFunctions& egl, EGLDisplay display, EGLConfig config) {
  constexpr EGLint kVersions[][2] = {{4, 6}, {4, 5}, {4, 3}, {3, 3}};
  for (const auto& [major, minor] : kVersions) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    const EGLContext context = egl.create_context(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT) return context;
  }
  return EGL_NO_CONTEXT;
}

ContextResult make_context(const EglFunctions& egl, EGLDisplay display, std::string description) {
  if (display == EGL_NO_DISPLAY)
    return ContextError{fmt::format("{} offers no display", description)};
  if (egl.initialize(display, nullptr, nullptr) != EGL_TRUE)
    return ContextError{
        fmt::format("{} cannot be initialised: EGL error {:#06x}", description, egl.get_error())};
  auto result = std::make_unique<EglContext>(egl, display, description);
  if (egl.bind_api(EGL_OPENGL_API) != EGL_TRUE)
    return ContextError{description + " offers no desktop OpenGL"};
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (egl.choose_config(display, wanted, &config, 1, &count) != EGL_TRUE || count == 0)
    return ContextError{description + " has no configuration for desktop OpenGL"};
  const EGLContext context = create_core_context(egl, display, config);
  if (context == EGL_NO_CONTEXT)
    return ContextError{description + " offers no OpenGL core context of version 3.3 or later"};
  result->set_context(context);
  return result;
}

// Opens libEGL and, for a platform, a display of it. The message says what is missing.
std::string load_egl(EglFunctions& egl) {
  const SharedLibrary library({"libEGL.so.1", "libEGL.so"});
  if (!library.is_open()) return "EGL cannot be opened: " + library.error();
  return egl.load(library) ? "" : "libEGL.so.1 lacks functions of EGL 1.4";
}

EGLDisplay platform_display(const EglFunctions& egl, EGLenum platform, void* native) {
  const auto get_display =
      egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get_display == nullptr ? EGL_NO_DISPLAY : get_display(platform, native, nullptr);
}

}  // namespace

ContextResult make_egl_surfaceless_context() {
  EglFunctions egl;
  if (std::string error = load_egl(egl); !error.empty()) return ContextError{error};
  const EGLDisplay display =
      platform_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  return make_context(egl, display, "EGL surfaceless");
}

ContextResult make_egl_device_context(int index) {
  EglFunctions egl;
  if (std::string error = load_egl(egl); !error.empty()) return ContextError{error};
  const auto query_devices = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (query_devices == nullptr || query_devices(0, nullptr, &count) != EGL_TRUE)
    return ContextError{"this EGL cannot list its devices"};
  if (index >= count)
    return ContextError{fmt::format("there is no EGL device {}: EGL lists {}", index, count)};
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  query_devices(count, devices.data(), &count);
  const EGLDisplay display =
      platform_display(egl, EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(index)]);
  return make_context(egl, display, fmt::format("EGL device {}", index));
}

}  // namespace edgecase
