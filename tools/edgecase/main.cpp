// SPDX-License-Identifier: MIT
//
// The `edgecase` command: one file per subcommand, nothing but arguments and output here.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>

#include "kernels/kernel_use.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/help/help_pages.h"
#include "tools/edgecase/help/usage_errors.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

// False, with the error printed, where EDGECASE_KERNELS asks for what there is not.
bool use_kernels_of_environment() {
  const char* const name = std::getenv("EDGECASE_KERNELS");
  if (name == nullptr || *name == '\0' || use_kernels(name)) return true;
  print_error(fmt::format("EDGECASE_KERNELS=\"{}\" is nothing to draw with; this machine has {}",
                          name, fmt::join(kernel_names(), ", ")));
  return false;
}

}  // namespace
}  // namespace edgecase

int main(int argc, char** argv) {
  using edgecase::ExitCode;
  // A limit on the size of files is an error of what is written, to be told, and no death.
  std::signal(SIGXFSZ, SIG_IGN);
  if (!edgecase::use_kernels_of_environment()) return static_cast<int>(ExitCode::usage);
  CLI::App app{
      "Renders test cases exactly and with real OpenGL. Explains every disagreement: the rule that "
      "it concerns, the cause, and whether the specification allows it."};
  app.name("edgecase");
  app.set_version_flag("--version", edgecase::kToolName);
  // At most one: were one required, a misspelt one would be reported as none.
  app.require_subcommand(0, 1);
  app.footer(
      "`edgecase help run` prints the options of run, and examples.\n\n"
      "Exit codes: 0 as expected, 1 something unexpected, 2 usage or case error, "
      "3 input, output or internal error, 4 renderer missing or failing, 5 nothing selected.\n\n"
      "Results do not depend on the processor. The variable EDGECASE_KERNELS names the SIMD target "
      "of the fast kernels; none turns them off.");
  ExitCode exit = ExitCode::as_expected;
  // Group by group, in the order in which help lists them.
  edgecase::add_run_command(app, exit);
  edgecase::add_report_command(app, exit);
  edgecase::add_compare_command(app, exit);
  edgecase::add_merge_command(app, exit);
  edgecase::add_record_command(app, exit);
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
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) throw CLI::RequiredError("a subcommand, such as run,");
  } catch (const CLI::ParseError& error) {
    // Help and the version come this way too, with the code 0.
    if (error.get_exit_code() == 0) {
      app.exit(error);
    } else {
      edgecase::print_to_stderr(edgecase::usage_error(app, error));
      exit = ExitCode::usage;
    }
  } catch (const std::exception& error) {
    edgecase::print_error(std::string("internal error: ") + error.what());
    exit = ExitCode::internal;
  }
  if (!std::cout.flush() || std::fflush(stdout) != 0) {
    edgecase::print_error(std::string("cannot write standard output: ") + std::strerror(errno));
    exit = edgecase::worse(exit, ExitCode::internal);
  }
  if (std::fflush(stderr) != 0 || std::ferror(stderr) != 0)
    exit = edgecase::worse(exit, ExitCode::internal);
  return static_cast<int>(exit);
}
