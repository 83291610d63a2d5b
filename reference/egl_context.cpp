// SPDX-License-Identifier: MIT
#include "reference/egl_context.h"

// Keeps the X11 headers out; there is no window.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
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
  decltype(eglGetConfigAttrib)* get_config_attribute = nullptr;
  decltype(eglCreateContext)* create_context = nullptr;
  decltype(eglCreatePbufferSurface)* create_pbuffer = nullptr;
  decltype(eglDestroySurface)* destroy_surface = nullptr;
  decltype(eglMakeCurrent)* make_current = nullptr;
  decltype(eglGetError)* get_error = nullptr;

  bool load(const SharedLibrary& library) {
    return library.load("eglGetProcAddress", get_proc_address) &&
           library.load("eglQueryString", query_string) &&
           library.load("eglInitialize", initialize) && library.load("eglTerminate", terminate) &&
           library.load("eglBindAPI", bind_api) && library.load("eglChooseConfig", choose_config) &&
           library.load("eglGetConfigAttrib", get_config_attribute) &&
           library.load("eglCreateContext", create_context) &&
           library.load("eglCreatePbufferSurface", create_pbuffer) &&
           library.load("eglDestroySurface", destroy_surface) &&
           library.load("eglMakeCurrent", make_current) && library.load("eglGetError", get_error);
  }

  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(get_proc_address(name));
  }
};

// Pbuffers kept at a time; a suite uses a handful of sizes.
constexpr std::size_t kMostPbuffers = 16;

// The display owns its contexts and surfaces: terminating it frees them.
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

  void set_context(EGLContext context, EGLConfig config) {
    context_ = context;
    config_ = config;
  }

  bool make_current() override { return bind(EGL_NO_SURFACE); }
  std::string bind_window(int width, int height) override {
    const EGLSurface surface = find_pbuffer(width, height);
    if (surface == EGL_NO_SURFACE || (surface != current_ && !bind(surface)))
      return fmt::format("{} refuses a pbuffer of {}x{}: EGL error {:#06x}", description_, width,
                         height, egl_.get_error());
    return "";
  }
  GlFunction get_proc(const char* name) const override { return egl_.get_proc_address(name); }
  std::string description() const override { return description_; }

 private:
  bool bind(EGLSurface surface) {
    if (egl_.make_current(display_, surface, surface, context_) != EGL_TRUE) return false;
    current_ = surface;
    return true;
  }

  EGLSurface find_pbuffer(int width, int height) {
    const std::pair size(width, height);
    if (const auto found = pbuffers_.find(size); found != pbuffers_.end()) return found->second;
    if (pbuffers_.size() >= kMostPbuffers) {
      // The one that is current lives until another one is.
      for (const auto& [ignored, surface] : pbuffers_) egl_.destroy_surface(display_, surface);
      pbuffers_.clear();
      current_ = EGL_NO_SURFACE;
    }
    const EGLint attributes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLSurface surface = egl_.create_pbuffer(display_, config_, attributes);
    if (surface != EGL_NO_SURFACE) pbuffers_.emplace(size, surface);
    return surface;
  }

  EglFunctions egl_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLConfig config_ = nullptr;
  EGLSurface current_ = EGL_NO_SURFACE;
  std::map<std::pair<int, int>, EGLSurface> pbuffers_;
  std::string description_;
};

// A configuration with exactly 8 bits per channel, one sample and pbuffers; null when there is
// none. EGL lists deeper formats first, so the list is searched.
EGLConfig find_config(const EglFunctions& egl, EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_SAMPLE_BUFFERS,
                           0,
                           EGL_NONE};
  EGLint count = 0;
  if (egl.choose_config(display, wanted, nullptr, 0, &count) != EGL_TRUE) return nullptr;
  std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
  egl.choose_config(display, wanted, configs.data(), count, &count);
  const auto has_eight_bits = [&](EGLConfig config) {
    for (EGLint channel : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE}) {
      EGLint bits = 0;
      egl.get_config_attribute(display, config, channel, &bits);
      if (bits != 8) return false;
    }
    return true;
  };
  const auto found = std::find_if(configs.begin(), configs.end(), has_eight_bits);
  return found == configs.end() ? nullptr : *found;
}

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
  const EGLConfig config = find_config(egl, display);
  if (config == nullptr)
    return ContextError{description + " has no configuration for desktop OpenGL with RGBA8"};
  const EGLContext context = create_core_context(egl, display, config);
  if (context == EGL_NO_CONTEXT)
    return ContextError{description + " offers no OpenGL core context of version 3.3 or later"};
  result->set_context(context, config);
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
