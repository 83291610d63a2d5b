// SPDX-License-Identifier: MIT
//
// The files that results are written to.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "results/results.h"

namespace edgecase {

// The results in the file at `path`; prints an error and returns nothing when there are none.
std::optional<Results> load_results(const std::string& path);

// --json, --junit and --html; where none is given, results.json, junit.xml and report.html in out/.
struct ReportFiles {
  std::string json;
  std::string junit;
  std::string html;

  void add_to(CLI::App& command);
  // Writes what was asked for, "-" meaning standard output. False when something cannot be written;
  // the error is printed and the other files are written all the same.
  bool write(const Results& results) const;
  // The HTML file that write() makes, or empty.
  std::string html_path() const;
};

}  // namespace edgecase
