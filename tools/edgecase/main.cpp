// SPDX-License-Identifier: MIT
//
// The `edgecase` command: one file per subcommand, nothing but arguments and output here.
#include <CLI/CLI.hpp>
#include <exception>

#include "tools/edgecase/commands.h"
#include "tools/edgecase/options.h"

int main(int argc, char** argv) {
  using edgecase::ExitCode;
  CLI::App app{
      "Renders JSON-described test cases exactly and with real OpenGL, and says for every "
      "disagreement which rule it is about, why, and whether the specification allows it."};
  app.name("edgecase");
  app.set_version_flag("--version", edgecase::kToolName);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 as expected, 1 something unexpected, 2 usage or case error,\n"
      "3 input, output or internal error, 4 renderer missing or failing, 5 nothing selected.");
  ExitCode exit = ExitCode::as_expected;
  edgecase::add_run_command(app, exit);
  edgecase::add_render_command(app, exit);
  edgecase::add_explain_command(app, exit);
  edgecase::add_rules_command(app, exit);
  edgecase::add_backends_command(app, exit);
  edgecase::add_validate_command(app, exit);
  edgecase::add_bless_command(app, exit);
  edgecase::add_report_command(app, exit);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : static_cast<int>(ExitCode::usage);
  } catch (const std::exception& error) {
    edgecase::print_error(std::string("internal error: ") + error.what());
    return static_cast<int>(ExitCode::internal);
  }
  return static_cast<int>(exit);
}
