// SPDX-License-Identifier: MIT
//
// Proof that the active driver is the requested one.
//
// Environment variables choose among Mesa's drivers and among Vulkan's, and a loader that finds
// nothing silently takes another one. So a worker checks what the context reports and, if one
// driver runs on top of another, the code that its process can execute.
#pragma once

#include <string>

namespace edgecase {

// Driver names are those of the worker's command line: "llvmpipe", "softpipe", "zink" (over
// lavapipe) and "zink-swiftshader". All functions return one sentence, or nothing if there is no
// fault.

// What must be installed but is missing. Call it before a context is opened: without it some
// loaders choose another driver, and others fail with just a number. Checks VK_ICD_FILENAMES.
std::string missing_for_driver(const std::string& driver);

// Why the active driver is another one, by GL_RENDERER and /proc/self/maps. For an unknown name,
// GL_RENDERER must begin with it.
std::string doubt_of_driver(const std::string& driver, const std::string& gl_renderer);

// The layers between OpenGL and the pixels, for RendererInfo's traits; empty: the driver alone.
std::string stack_of_driver(const std::string& driver);

}  // namespace edgecase
