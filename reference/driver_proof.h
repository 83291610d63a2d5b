// SPDX-License-Identifier: MIT
//
// Proof that the driver at work is the one that was asked for.
//
// Environment variables choose among Mesa's drivers and among Vulkan's, and a chooser that finds
// nothing takes another one without a word. So a worker looks at what the context says of itself,
// and, where one driver runs upon another, at the code that its process can execute.
#pragma once

#include <string>

namespace edgecase {

// Drivers by the names that the worker's command line gives them: "llvmpipe", "softpipe", "zink"
// (over lavapipe) and "zink-swiftshader". All functions return one sentence; empty: nothing is
// wrong.

// What must be installed and is not. To be asked before a context is opened: without it some
// loaders choose another driver, and others fail with a number. Looks at VK_ICD_FILENAMES.
std::string missing_for_driver(const std::string& driver);

// Why the driver at work is another one, by GL_RENDERER and /proc/self/maps. A name that is not
// known must begin GL_RENDERER.
std::string doubt_of_driver(const std::string& driver, const std::string& gl_renderer);

// What stands between OpenGL and the pixels, for RendererInfo's traits; empty: the driver alone.
std::string stack_of_driver(const std::string& driver);

}  // namespace edgecase
