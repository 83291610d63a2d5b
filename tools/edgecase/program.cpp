// SPDX-License-Identifier: MIT
#include "tools/edgecase/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>

#include "kernels/kernels.h"
#include "reports/text.h"
#include "results/shelf.h"
#include "tools/edgecase/help/usage_errors.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/project.h"

namespace edgecase {

bool begin_program() {
  // What scenes take is used again, as far as 32 MB: pages that the system gives anew are cleared
  // first, which took a twentieth of a run's time. More is given back once it is freed.
  mallopt(M_MMAP_THRESHOLD, 1 << 24);
  mallopt(M_TRIM_THRESHOLD, 1 << 25);
  mallopt(M_TOP_PAD, 1 << 22);
  // Exceeding a limit on the size of files is reported as an error and does not kill the program.
  std::signal(SIGXFSZ, SIG_IGN);
  const char* const name = std::getenv("EDGECASE_KERNELS");
  if (name == nullptr || *name == '\0' || use_kernels(name)) return true;
  print_error(fmt::format("EDGECASE_KERNELS=\"{}\" is nothing to draw with; this machine has {}",
                          name, fmt::join(kernel_names(), ", ")));
  return false;
}

ExitCode run_program(CLI::App& app, int argc, char** argv, const std::function<ExitCode()>& run) {
  ExitCode exit = ExitCode::as_expected;
  try {
    app.parse(argc, argv);
    exit = run();
  } catch (const CLI::ParseError& error) {
    // Help and the version are thrown too, with code 0.
    if (error.get_exit_code() == 0) {
      app.exit(error);
    } else {
      print_to_stderr(usage_error(app, error));
      exit = ExitCode::usage;
    }
  } catch (const ProjectError& error) {
    print_to_stderr(one_line(error.what()) + "\n");
    exit = ExitCode::usage;
  } catch (const ShelfError& error) {
    print_error(error.what());
    exit = ExitCode::internal;
  } catch (const std::exception& error) {
    print_error(std::string("internal error: ") + error.what());
    exit = ExitCode::internal;
  }
  if (!std::cout.flush() || std::fflush(stdout) != 0) {
    print_error(std::string("cannot write standard output: ") + std::strerror(errno));
    exit = worse(exit, ExitCode::internal);
  }
  if (std::fflush(stderr) != 0 || std::ferror(stderr) != 0) exit = worse(exit, ExitCode::internal);
  return exit;
}

}  // namespace edgecase
