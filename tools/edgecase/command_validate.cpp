// SPDX-License-Identifier: MIT
//
// edgecase validate: are case files well formed, and does exact meet their drawings? No OpenGL.
#include <fmt/format.h>

#include <memory>

#include "raster/rasterizer.h"
#include "run/expectation_check.h"
#include "run/selection.h"
#include "tools/edgecase/commands.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

ExitCode validate(const Selection& selection) {
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  for (const Diagnostic& note : suite.notes) fmt::print("{}\n", to_string(note));
  std::size_t unmet = 0;
  for (const Case& one : suite.cases) {
    const Policy policy;
    for (const std::string& drawing :
         unmet_drawings(one, policy.name, rasterize(one.scene, policy))) {
      fmt::print(stderr, "{}", drawing);
      ++unmet;
    }
  }
  fmt::print("{} cases are well formed, {} faults, {} drawings not met\n", suite.cases.size(),
             suite.diagnostics.size(), unmet);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (unmet > 0) return ExitCode::unexpected;
  if (!suite.cases.empty()) return ExitCode::as_expected;
  print_nothing_selected();
  return ExitCode::nothing_selected;
}

}  // namespace

void add_validate_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "validate", "Check case files, and their drawings against the exact side, without OpenGL");
  auto options = std::make_shared<SelectionOptions>();
  options->add_to(*command, false);
  command->callback([options, &exit] { exit = validate(options->selection()); });
}

}  // namespace edgecase
