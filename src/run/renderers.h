// SPDX-License-Identifier: MIT
//
// From the name of a renderer to the renderer.
#pragma once

#include <atomic>
#include <chrono>
#include <map>
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
  // By renderers' names: the folders that their programs are started in; others in our own.
  std::map<std::string, std::string> folders{};
};

// `exact`, `recording:FILE` or what renderer_names.h knows, with a name of its own before it or
// without: "mine=exec:./r". A sentence that says why not.
std::variant<std::unique_ptr<Renderer>, std::string> make_renderer(const std::string& renderer,
                                                                   const RendererOptions& options);

}  // namespace edgecase
