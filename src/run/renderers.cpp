// SPDX-License-Identifier: MIT
#include "run/renderers.h"

#include <utility>

#include "raster/exact_renderer.h"
#include "run/process_renderer.h"
#include "run/recording_renderer.h"
#include "run/renderer_names.h"

namespace edgecase {

std::variant<std::unique_ptr<Renderer>, std::string> make_renderer(const std::string& name,
                                                                   const RendererOptions& options) {
  if (name == "exact") return std::make_unique<ExactRenderer>(options.policy);
  if (is_recording(name)) return open_recording(name);
  auto found = find_renderer(name, options.program_directory);
  if (auto* unknown = std::get_if<UnknownRenderer>(&found)) return std::move(unknown->message);
  auto& spec = std::get<ProcessSpec>(found);
  spec.timeout = options.timeout;
  spec.stop = options.stop;
  return std::make_unique<ProcessRenderer>(std::move(spec));
}

}  // namespace edgecase
