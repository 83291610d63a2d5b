// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/delivery.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "tools/edgecase/options.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {

ExitCode deliver_results(const Results& results, const ReportFiles& files, const std::string& color,
                         std::optional<RunCost> cost) {
  const ExitCode exit = exit_code_of(results);
  if (exit == ExitCode::nothing_selected) {
    print_nothing_selected();
    return exit;
  }
  const bool to_stdout = files.use_standard_output();
  write_summary(results, use_color(color, to_stdout ? STDERR_FILENO : STDOUT_FILENO),
                to_stdout ? std::cerr : std::cout, cost);
  if (files.since)
    write_changes(*files.since, use_color(color, to_stdout ? STDERR_FILENO : STDOUT_FILENO),
                  to_stdout ? std::cerr : std::cout);
  if (!files.write(results)) return worse(exit, ExitCode::internal);
  const std::string html = files.html_path();
  if (!to_stdout && !html.empty()) fmt::print("\nReport: {}\n", html);
  files.open_if_asked();
  return exit;
}

}  // namespace edgecase
