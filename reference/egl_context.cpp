// SPDX-License-Identifier: MIT
#include "reference/egl_context.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/egl_library.h"

namespace edgecase {

namespace {

// Of ANGLE's extensions of EGL, which Khronos' headers leave to ANGLE: EGL_ANGLE_platform_angle,
// its _vulkan and its _device_type_swiftshader.
constexpr EGLenum kAngle = 0x3202;
constexpr EGLint kAngleType = 0x3203;
constexpr EGLint kAngleVulkan = 0x3450;
constexpr EGLint kAngleDeviceType = 0x3209;
constexpr EGLint kAngleSwiftShader = 0x3487;

// Pbuffers kept at a time; a suite uses a handful of sizes.
constexpr std::size_t kMostPbuffers = 16;

// The display owns its contexts and surfaces: terminating it frees them.
class EglContext final : public GlContext {
 public:
  EglContext(const EglFunctions& egl, EGLDisplay display, GlApi api, std::string description)
      : egl_(egl), display_(display), api_(api), description_(std::move(description)) {}
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

  GlApi api() const override { return api_; }
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
      // The current surface lives until another one is current.
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
  GlApi api_;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLConfig config_ = nullptr;
  EGLSurface current_ = EGL_NO_SURFACE;
  std::map<std::pair<int, int>, EGLSurface> pbuffers_;
  std::string description_;
};

// A configuration with exactly 8 bits per channel, one sample and pbuffers, or null. EGL lists
// deeper formats first, so the list is searched.
EGLConfig find_config(const EglFunctions& egl, EGLDisplay display, GlApi api) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           api == GlApi::opengl ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT,
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

// The newest version that the display offers.
EGLContext create_context(const EglFunctions& egl, EGLDisplay display, EGLConfig config,
                          GlApi api) {
  struct Version {
    EGLint major;
    EGLint minor;
  };
  constexpr Version kCore[] = {{4, 6}, {4, 5}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}};
  constexpr Version kEs[] = {{3, 2}, {3, 1}, {3, 0}};
  const bool is_core = api == GlApi::opengl;
  for (const auto& [major, minor] : is_core ? std::span<const Version>(kCore) : kEs) {
    // Only OpenGL has profiles: for OpenGL ES the list ends before them.
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 minor,
                                 is_core ? EGL_CONTEXT_OPENGL_PROFILE_MASK : EGL_NONE,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    const EGLContext context = egl.create_context(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT) return context;
  }
  return EGL_NO_CONTEXT;
}

ContextResult make_context(const EglFunctions& egl, EGLDisplay display, GlApi api,
                           const std::string& place) {
  const bool is_core = api == GlApi::opengl;
  const std::string description = is_core ? place : place + ", OpenGL ES";
  if (display == EGL_NO_DISPLAY) return ContextError{fmt::format("{} offers no display", place)};
  if (egl.initialize(display, nullptr, nullptr) != EGL_TRUE)
    return ContextError{
        fmt::format("{} cannot be initialised: EGL error {:#06x}", place, egl.get_error())};
  auto result = std::make_unique<EglContext>(egl, display, api, description);
  const std::string wanted = is_core ? "desktop OpenGL" : "OpenGL ES";
  const std::string remedy = is_core ? "; egl-es: asks for OpenGL ES" : "";
  if (egl.bind_api(is_core ? EGL_OPENGL_API : EGL_OPENGL_ES_API) != EGL_TRUE)
    return ContextError{place + " offers no " + wanted + remedy};
  const EGLConfig config = find_config(egl, display, api);
  if (config == nullptr)
    return ContextError{place + " has no configuration for " + wanted + " with RGBA8" + remedy};
  const EGLContext context = create_context(egl, display, config, api);
  if (context == EGL_NO_CONTEXT)
    return ContextError{place + (is_core ? " offers no OpenGL core context of version 3.3 or later"
                                         : " offers no OpenGL ES context of version 3.0 or later")};
  result->set_context(context, config);
  return result;
}

EGLDisplay platform_display(const EglFunctions& egl, EGLenum platform, void* native,
                            const EGLint* attributes = nullptr) {
  const auto get_display =
      egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get_display == nullptr ? EGL_NO_DISPLAY : get_display(platform, native, attributes);
}

// Does the text hold the other, in upper or lower case? Fewer than three letters stand anywhere.
bool holds(const std::string& text, const std::string& other) {
  if (other.size() < 3) return false;
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  return std::search(text.begin(), text.end(), other.begin(), other.end(), same) != text.end();
}

}  // namespace

ContextResult make_egl_surfaceless_context(GlApi api) {
  EglFunctions egl;
  if (std::string error = egl.load(); !error.empty()) return ContextError{error};
  const EGLDisplay display =
      platform_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  return make_context(egl, display, api, "EGL surfaceless");
}

ContextResult make_egl_device_context(GlApi api, int index) {
  EglFunctions egl;
  if (std::string error = egl.load(); !error.empty()) return ContextError{error};
  std::vector<EGLDeviceEXT> devices;
  if (std::string error = list_devices(egl, devices); !error.empty()) return ContextError{error};
  const auto place = static_cast<std::size_t>(index);
  if (place >= devices.size())
    return ContextError{
        fmt::format("there is no EGL device {}: EGL lists {}", index, devices.size())};
  const EGLDisplay display = platform_display(egl, EGL_PLATFORM_DEVICE_EXT, devices[place]);
  return make_context(egl, display, api, fmt::format("EGL device {}", index));
}

ContextResult make_egl_device_context(GlApi api, const std::string& name) {
  EglFunctions egl;
  if (std::string error = egl.load(); !error.empty()) return ContextError{error};
  std::vector<EGLDeviceEXT> devices;
  if (std::string error = list_devices(egl, devices); !error.empty()) return ContextError{error};
  std::vector<std::string> listed;
  std::vector<int> matching;
  for (const EGLDeviceEXT device : devices) {
    const std::string text = describe_device(egl, device);
    const int index = static_cast<int>(listed.size());
    if (holds(text, name)) matching.push_back(index);
    listed.push_back(fmt::format("{} ({})", index, text));
  }
  if (matching.size() == 1) return make_egl_device_context(api, matching.front());
  return ContextError{
      fmt::format("{} EGL devices have \"{}\" in what EGL says of them: {}; name three "
                  "letters or more that one of these has, or its number: egl:device0",
                  matching.empty() ? "no" : "several", name, fmt::join(listed, ", "))};
}

ContextResult make_egl_library_context(GlApi api, const std::string& path) {
  EglFunctions egl;
  if (std::string error = egl.load(path); !error.empty()) return ContextError{error};
  const std::string place = "EGL of " + path;
  const char* const extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!has_extension(extensions, "EGL_ANGLE_platform_angle"))
    return make_context(
        egl,
        has_extension(extensions, "EGL_MESA_platform_surfaceless")
            ? platform_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY)
            : egl.get_display(EGL_DEFAULT_DISPLAY),
        api, place);
  constexpr EGLint kVulkan[] = {kAngleType, kAngleVulkan, EGL_NONE};
  constexpr EGLint kSwiftShader[] = {kAngleType, kAngleVulkan, kAngleDeviceType, kAngleSwiftShader,
                                     EGL_NONE};
  ContextResult result;
  for (const EGLint* const attributes :
       {static_cast<const EGLint*>(nullptr), kVulkan, kSwiftShader}) {
    result = make_context(egl, platform_display(egl, kAngle, EGL_DEFAULT_DISPLAY, attributes), api,
                          place);
    if (!std::holds_alternative<ContextError>(result)) return result;
  }
  return result;
}

int count_egl_devices() {
  EglFunctions egl;
  std::vector<EGLDeviceEXT> devices;
  if (!egl.load().empty() || !list_devices(egl, devices).empty()) return 0;
  return static_cast<int>(devices.size());
}

}  // namespace edgecase
