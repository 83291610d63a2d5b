// SPDX-License-Identifier: MIT
//
// edgecase render: cases drawn by one renderer, as lines of JSON or PNG files.
#include <fmt/format.h>

#include <memory>

#include "image/image_file.h"
#include "run/renderers.h"
#include "run/run.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/output/whole_file.h"
#include "tools/edgecase/project.h"
#include "wire/rendering_json.h"

namespace edgecase {
namespace {

struct RenderOptions {
  SelectionOptions selection;
  PolicyOptions policy;
  std::string renderer = "exact";
  ProjectOption project;
  std::string json;
  std::string png;
  int scale = 1;
  double timeout = 10;
};

// Thrown by the renderer's sink after Ctrl-C.
struct Stopped {};

// Writes output of both kinds, and reports failures once per file.
class Output {
 public:
  explicit Output(const RenderOptions& options) : options_(options) {}

  void add(const std::string& id, const Rendering& rendering) {
    if (!options_.json.empty()) lines_ += rendering_json(id, rendering) + "\n";
    if (options_.png.empty()) return;
    const std::filesystem::path path = std::filesystem::path(options_.png) / (id + ".png");
    std::string error = fault_of_links(path);
    std::error_code code;
    if (error.empty()) std::filesystem::create_directories(path.parent_path(), code);
    if (error.empty())
      error =
          write_png(path, {rendering.width, rendering.height, rendering.pixels}, options_.scale);
    if (error.empty()) return;
    print_error(error);
    failed_ = true;
  }

  ExitCode finish() const {
    if (options_.json == "-")
      fmt::print("{}", lines_);
    else if (!options_.json.empty() && !write_file(options_.json, lines_))
      return ExitCode::internal;
    return failed_ ? ExitCode::internal : ExitCode::as_expected;
  }

 private:
  const RenderOptions& options_;
  std::string lines_;
  bool failed_ = false;
};

// Prints failures as they occur. Finished output is kept if the command is interrupted.
ExitCode render_tasks(Renderer& renderer, const std::vector<Task>& tasks, Output& output) {
  ExitCode exit = ExitCode::as_expected;
  const InterruptGuard guard;
  try {
    renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
      if (interrupted()) throw Stopped{};
      if (const auto* failure = std::get_if<Failure>(&outcome)) {
        print_error(
            fmt::format("{}: {}: {}", tasks[index].id, name_of(failure->kind), failure->reason));
        exit = worse(exit, ExitCode::renderer);
      } else {
        output.add(tasks[index].id, std::get<Rendering>(outcome));
      }
    });
  } catch (const Stopped&) {
    print_error("interrupted; renderings are missing");
    exit = worse(exit, ExitCode::unexpected);
  }
  return exit;
}

ExitCode render(RenderOptions options) {
  if (options.json.empty() && options.png.empty()) options.json = "-";
  const Selection selection = options.selection.selection();
  if (!are_distinct({{"--json", options.json}, {"--png", options.png}}, selection.paths))
    return ExitCode::usage;
  const auto policy = options.policy.load(selection);
  if (!policy) return ExitCode::usage;
  auto made =
      make_renderer(options.renderer,
                    {*policy, std::chrono::milliseconds(static_cast<int>(options.timeout * 1000)),
                     worker_directory(), &interrupted(), options.project.folders});
  if (const auto* error = std::get_if<std::string>(&made)) {
    print_error(*error);
    return ExitCode::usage;
  }
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  const std::vector<Case> cases = suite.cases.all();
  std::vector<Task> tasks;
  for (const Case& one : cases) tasks.push_back({one.id, &one.scene});

  ExitCode exit = suite.diagnostics.empty() ? ExitCode::as_expected : ExitCode::usage;
  if (tasks.empty() && suite.diagnostics.empty()) {
    print_nothing_selected();
    exit = ExitCode::nothing_selected;
  }
  Output output(options);
  exit = worse(exit, render_tasks(*std::get<std::unique_ptr<Renderer>>(made), tasks, output));
  return worse(exit, output.finish());
}

}  // namespace

void add_render_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("render", "Render cases with one renderer, as JSON lines or PNG files");
  auto options = std::make_shared<RenderOptions>();
  options->selection.add_to(*command, false);
  options->policy.add_to(*command);
  command->add_option("--with", options->renderer, "Renderer, as `run` names them")
      ->capture_default_str();
  command->add_option("--json", options->json,
                      "File for one JSON object per case, - for standard "
                      "output (the default)");
  command->add_option("--png", options->png, "Folder for one PNG per case");
  command->add_option("--scale", options->scale, "Enlarge pixels of PNG files")
      ->check(in_range(1, 64));
  command->add_option("--timeout", options->timeout, "Seconds per case")
      ->check(in_range(0.01, 3600.0));
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderer, {"paths", "--policy"});
    exit = render(*options);
  });
}

}  // namespace edgecase
