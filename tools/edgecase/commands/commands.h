// SPDX-License-Identifier: MIT
//
// The subcommands: each adds itself to the command line and, when chosen, sets the exit code.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/edgecase/exit_code.h"

namespace edgecase {

void add_run_command(CLI::App& app, ExitCode& exit);
void add_render_command(CLI::App& app, ExitCode& exit);
void add_explain_command(CLI::App& app, ExitCode& exit);
void add_rules_command(CLI::App& app, ExitCode& exit);
void add_backends_command(CLI::App& app, ExitCode& exit);
void add_new_command(CLI::App& app, ExitCode& exit);
void add_validate_command(CLI::App& app, ExitCode& exit);
void add_bless_command(CLI::App& app, ExitCode& exit);
void add_merge_command(CLI::App& app, ExitCode& exit);
void add_compare_command(CLI::App& app, ExitCode& exit);
void add_generations_command(CLI::App& app, ExitCode& exit);
void add_report_command(CLI::App& app, ExitCode& exit);
void add_separation_command(CLI::App& app, ExitCode& exit);
void add_draw_command(CLI::App& app, ExitCode& exit);
void add_profile_command(CLI::App& app, ExitCode& exit);
void add_gallery_command(CLI::App& app, ExitCode& exit);
void add_fuzz_command(CLI::App& app, ExitCode& exit);
void add_minimize_command(CLI::App& app, ExitCode& exit);
void add_record_command(CLI::App& app, ExitCode& exit);
void add_web_command(CLI::App& app, ExitCode& exit);
void add_bench_command(CLI::App& app, ExitCode& exit);
void add_manual_command(CLI::App& app, ExitCode& exit);
void add_help_command(CLI::App& app, ExitCode& exit);

}  // namespace edgecase
