// SPDX-License-Identifier: MIT
#include "run/renderers.h"

#include <utility>

#include "raster/rasterizer.h"
#include "run/process_renderer.h"
#include "run/recording_renderer.h"
#include "run/renderer_names.h"

namespace edgecase {
namespace {

using Made = std::variant<std::unique_ptr<Renderer>, std::string>;

// A renderer that is called otherwise than what it is reached by.
class RenamedRenderer final : public Renderer {
 public:
  RenamedRenderer(std::unique_ptr<Renderer> inner, NamedRenderer named)
      : inner_(std::move(inner)), named_(std::move(named)) {}

  const RendererInfo& info() const override {
    info_ = inner_->info();
    info_.name = named_.name;
    info_.traits[kAddressTrait] = named_.address;
    return info_;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    inner_->render(tasks, sink);
  }

 private:
  std::unique_ptr<Renderer> inner_;
  NamedRenderer named_;
  mutable RendererInfo info_;  // as info() gave it last
};

Made make_unnamed(const NamedRenderer& named, const RendererOptions& options) {
  if (named.address == "exact") return std::make_unique<ExactRenderer>(options.policy);
  if (is_recording(named.address)) return open_recording(named.address);
  const auto folder = options.folders.find(named.name);
  auto found = find_renderer(named.address, options.program_directory,
                             folder == options.folders.end() ? "" : folder->second);
  if (auto* unknown = std::get_if<UnknownRenderer>(&found)) return std::move(unknown->message);
  auto& spec = std::get<ProcessSpec>(found);
  spec.timeout = options.timeout;
  spec.startup_timeout = startup_patience(options.timeout);
  spec.stop = options.stop;
  return std::make_unique<ProcessRenderer>(std::move(spec));
}

}  // namespace

Made make_renderer(const std::string& renderer, const RendererOptions& options) {
  NamedRenderer named = split_name(renderer);
  if (named.address == renderer) return make_unnamed(named, options);
  // It says what is wrong with a name.
  if (!is_own_name(named.name))
    return std::get<UnknownRenderer>(find_renderer(renderer, options.program_directory)).message;
  Made made = make_unnamed(named, options);
  if (auto* inner = std::get_if<std::unique_ptr<Renderer>>(&made))
    return std::make_unique<RenamedRenderer>(std::move(*inner), std::move(named));
  return made;
}

}  // namespace edgecase
