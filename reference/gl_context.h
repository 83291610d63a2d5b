// SPDX-License-Identifier: MIT
//
// GlContext: a current context of OpenGL core or OpenGL ES without a window, however it was made.
//
// One process has one context for its whole life: Mesa reads the choice of its driver once per
// process, and a driver that crashes must take nothing else with it.
//
// Besides framebuffer objects, which belong to the GL, there is the framebuffer of the window
// system: OSMesa's own buffer, or an EGL pbuffer. It is framebuffer 0 while it is bound, has RGBA8
// colours and one sample, and drivers may treat it differently from a framebuffer object.
#pragma once

#include <memory>
#include <string>
#include <variant>

namespace edgecase {

using GlFunction = void (*)();

// The API of a context. The two differ in functions, in shaders, and in features:
// reference/gl_api.h.
enum class GlApi { opengl, opengl_es };

class GlContext {
 public:
  virtual ~GlContext() = default;
  virtual GlApi api() const = 0;
  // Makes the context current on this thread; false if the system refuses.
  virtual bool make_current() = 0;
  // Keeps the context current, and makes a window-system framebuffer of this size, in pixels, its
  // framebuffer 0, with undefined contents. Returns why that is impossible; empty on success.
  // Framebuffer objects and all other state are unchanged.
  virtual std::string bind_window(int width, int height) = 0;
  // The GL function of this name, or null. The context must be current.
  virtual GlFunction get_proc(const char* name) const = 0;
  // How the context was made: "OSMesa", "EGL surfaceless", "EGL device 0, OpenGL ES".
  virtual std::string description() const = 0;
};

// Why there is no context: one sentence for people.
struct ContextError {
  std::string message;
};

using ContextResult = std::variant<std::unique_ptr<GlContext>, ContextError>;

// Opens the context named on a worker's command line and makes it current: "osmesa",
// "egl-surfaceless" or "egl-device:N" (N from 0) or, for OpenGL ES, "egl-es-surfaceless" or
// "egl-es-device:N".
ContextResult open_context(const std::string& name);

}  // namespace edgecase
