// SPDX-License-Identifier: MIT
//
// edgecase report: reports from a results file, without rendering anything.
#include <fmt/format.h>

#include <memory>

#include "tools/edgecase/commands.h"
#include "tools/edgecase/report_files.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

ExitCode report(const std::string& path, const ReportFiles& files) {
  auto results = load_results(path);
  if (!results) return ExitCode::usage;
  load_sources(*results);
  return files.write(*results) ? ExitCode::as_expected : ExitCode::internal;
}

}  // namespace

void add_report_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("report", "Write reports from a results file, without rendering");
  auto path = std::make_shared<std::string>();
  auto files = std::make_shared<ReportFiles>();
  command->add_option("results", *path, "Results file of `edgecase run`")->required();
  files->add_to(*command);
  command->callback([path, files, &exit] { exit = report(*path, *files); });
}

}  // namespace edgecase
