// SPDX-License-Identifier: MIT
//
// The `edgecase` command. It handles only arguments and output; each subcommand has a file.
#include <CLI/CLI.hpp>

#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/help/help_pages.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/program.h"

int main(int argc, char** argv) {
  using edgecase::ExitCode;
  if (!edgecase::begin_program()) return static_cast<int>(ExitCode::usage);
  CLI::App app{
      "Renders test cases exactly and with real OpenGL. Explains every disagreement: the rule that "
      "it concerns, the cause, and whether the specification allows it."};
  app.name("edgecase");
  app.set_version_flag("--version", edgecase::kToolName);
  // A subcommand is not required here: a misspelt one would be reported as a missing one.
  app.require_subcommand(0, 1);
  app.footer(
      "`edgecase help run` prints the options of run, and examples.\n\n"
      "Exit codes: 0 as expected, 1 something unexpected, 2 usage or case error, "
      "3 input, output or internal error, 4 renderer missing or failing, 5 nothing selected, "
      "6 a renderer drew nothing.\n\n"
      "Results do not depend on the processor. The variable EDGECASE_KERNELS names the SIMD target "
      "of the fast kernels; none turns them off.");
  ExitCode exit = ExitCode::as_expected;
  // Group by group, in the order in which help lists them.
  edgecase::add_run_command(app, exit);
  edgecase::add_report_command(app, exit);
  edgecase::add_compare_command(app, exit);
  edgecase::add_generations_command(app, exit);
  edgecase::add_merge_command(app, exit);
  edgecase::add_record_command(app, exit);
  edgecase::add_web_command(app, exit);
  edgecase::add_render_command(app, exit);
  edgecase::add_explain_command(app, exit);
  edgecase::add_draw_command(app, exit);
  edgecase::add_rules_command(app, exit);
  edgecase::add_profile_command(app, exit);
  edgecase::add_gallery_command(app, exit);
  edgecase::add_new_command(app, exit);
  edgecase::add_validate_command(app, exit);
  edgecase::add_separation_command(app, exit);
  edgecase::add_fuzz_command(app, exit);
  edgecase::add_minimize_command(app, exit);
  edgecase::add_bless_command(app, exit);
  edgecase::add_backends_command(app, exit);
  edgecase::add_bench_command(app, exit);
  edgecase::add_manual_command(app, exit);
  edgecase::add_help_command(app, exit);
  edgecase::add_help_pages(app);
  return static_cast<int>(edgecase::run_program(app, argc, argv, [&] {
    if (app.get_subcommands().empty()) throw CLI::RequiredError("a subcommand, such as run,");
    return exit;
  }));
}
