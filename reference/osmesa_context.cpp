// SPDX-License-Identifier: MIT
#include "reference/osmesa_context.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <vector>

#include "reference/shared_library.h"

namespace edgecase {

namespace {

// What GL/osmesa.h declares. That header is missing where Mesa has no OSMesa any more, and defines
// OpenGL's own types a second time, beside glad's, where it is present.
using OSMesaContext = struct osmesa_context*;
constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kStencilBits = 0x31;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

struct OsmesaFunctions {
  OSMesaContext (*create_context)(const int* attributes, OSMesaContext shared) = nullptr;
  void (*destroy_context)(OSMesaContext context) = nullptr;
  GLboolean (*make_current)(OSMesaContext context, void* buffer, GLenum type, GLsizei width,
                            GLsizei height) = nullptr;
  GlFunction (*get_proc_address)(const char* name) = nullptr;

  bool load(const SharedLibrary& library) {
    return library.load("OSMesaCreateContextAttribs", create_context) &&
           library.load("OSMesaDestroyContext", destroy_context) &&
           library.load("OSMesaMakeCurrent", make_current) &&
           library.load("OSMesaGetProcAddress", get_proc_address);
  }
};

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext(const OsmesaFunctions& functions, OSMesaContext context)
      : functions_(functions), context_(context) {}
  ~OsmesaContext() override { functions_.destroy_context(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  GlApi api() const override { return GlApi::opengl; }
  bool make_current() override { return bind(kFirstSize, kFirstSize); }
  std::string bind_window(int width, int height) override {
    if (width == width_ && height == height_) return "";
    if (bind(width, height)) return "";
    width_ = height_ = 0;
    return fmt::format("OSMesa refuses a buffer of {}x{}", width, height);
  }
  GlFunction get_proc(const char* name) const override { return functions_.get_proc_address(name); }
  std::string description() const override { return "OSMesa"; }

 private:
  static constexpr int kFirstSize = 16;  // pixels; until a scene requests a window

  // OSMesa copies the drawing to the buffer, which must live until another one is bound.
  bool bind(int width, int height) {
    std::vector<unsigned char> buffer(4 * static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(height));
    if (functions_.make_current(context_, buffer.data(), GL_UNSIGNED_BYTE, width, height) !=
        GL_TRUE)
      return false;
    buffer_.swap(buffer);
    width_ = width;
    height_ = height;
    return true;
  }

  OsmesaFunctions functions_;
  OSMesaContext context_;
  std::vector<unsigned char> buffer_;  // RGBA8, bottom row first: OSMESA_Y_UP is the default
  int width_ = 0;                      // of buffer_, in pixels
  int height_ = 0;
};

OSMesaContext create_core_context(const OsmesaFunctions& functions, int major, int minor) {
  const int attributes[] = {kFormat,
                            GL_RGBA,
                            kDepthBits,
                            24,
                            kStencilBits,
                            8,
                            kProfile,
                            kCoreProfile,
                            kMajorVersion,
                            major,
                            kMinorVersion,
                            minor,
                            0,
                            0};
  return functions.create_context(attributes, nullptr);
}

}  // namespace

ContextResult make_osmesa_context() {
  const SharedLibrary library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
  if (!library.is_open())
    return ContextError{"OSMesa cannot be opened: " + library.error() +
                        "; Mesa ended it in 25.1: name egl:llvmpipe or egl:softpipe instead"};
  OsmesaFunctions functions;
  if (!functions.load(library))
    return ContextError{"OSMesa is too old: it lacks OSMesaCreateContextAttribs"};
  constexpr int kVersions[][2] = {{4, 6}, {4, 5}, {4, 3}, {4, 2}, {3, 3}};
  for (const auto& [major, minor] : kVersions)
    if (OSMesaContext context = create_core_context(functions, major, minor))
      return std::make_unique<OsmesaContext>(functions, context);
  return ContextError{"OSMesa offers no OpenGL core context of version 3.3 or later"};
}

}  // namespace edgecase
