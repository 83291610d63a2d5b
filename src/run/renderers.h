// SPDX-License-Identifier: MIT
//
// From the name of a renderer to the renderer.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <variant>

#include "model/policy.h"
#include "model/renderer.h"

namespace edgecase {

struct RendererOptions {
  Policy policy;                            // of the renderer `exact`
  std::chrono::milliseconds timeout{};      // per scene
  std::string program_directory;            // where the OpenGL worker lies
  const std::atomic<bool>* stop = nullptr;  // as ProcessSpec has it
};

// `exact`, `recording:FILE` or a name that renderer_names.h knows. A sentence that says why not.
std::variant<std::unique_ptr<Renderer>, std::string> make_renderer(const std::string& name,
                                                                   const RendererOptions& options);

}  // namespace edgecase
