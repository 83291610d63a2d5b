// SPDX-License-Identifier: MIT
//
// The files that results are written to.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "results/comparison.h"
#include "results/durations.h"
#include "results/generations.h"
#include "results/results_json.h"
#include "tools/edgecase/exit_code.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/results_key.h"

namespace edgecase {

// The results in the file at `path`. Prints an error and returns nothing when there are none;
// `exit` is then `internal` for a file that cannot be read, `usage` for one that holds no results.
std::optional<Results> load_results(const std::string& path, ExitCode& exit,
                                    Cut cut = Cut::refused);

// Adds the results of a file to the generations of drivers. Prints an error and returns false for
// results that are not whole.
bool add_generation_of(const std::string& path, const Results& results, Generations& generations);

// What the files of `edgecase run --timings` hold, together. Nothing, with the error printed and
// the exit code that it deserves, where one cannot be read.
std::optional<Durations> load_durations(const std::vector<std::string>& paths, ExitCode& exit);

// The option of commands that read such files.
void add_timings_option(CLI::App& command, std::vector<std::string>& paths);

// What changed from earlier results to these. Of results that are not of a whole suite, only the
// cases that they hold count. Nothing, with the error printed and the exit code that it deserves,
// where that cannot be said.
std::optional<Comparison> changes_since(Results before, const Results& results, ExitCode& exit);

// --json, --junit, --html and the others; where none is given, results.zst, junit.xml and
// report.html in out/.
struct ReportFiles {
  static constexpr const char* kDefaultJson = "out/results.zst";
  std::string json;
  std::string junit;
  std::string html;
  std::string ctrf;
  std::string markdown;
  std::string annotations;
  std::string csv;
  std::string triptychs;            // a folder
  bool all_details = false;         // of the HTML report, in scripts beside it
  bool open = false;                // the HTML report, when it is written
  Durations durations;              // for JUnit XML and CTRF
  std::optional<Comparison> since;  // what the HTML report tells to have changed
  Generations generations;          // known faults by release, for the HTML report
  const ResultsKey* key = nullptr;  // remembers the results, where it is set
  std::function<void()> results_are_written = [] {};  // called then, before all other files

  // `json_names`: how the option for the results file is called.
  void add_to(CLI::App& command, const std::string& json_names = "--json");
  // Writes what was asked for, "-" meaning standard output. False when something cannot be written;
  // the error is printed and the other files are written all the same.
  bool write(const Results& results) const;
  // The files and folders that write() makes.
  std::vector<WrittenFile> outputs() const;
  // False, with the error printed, where two of them are one file, or a report is one of these
  // results; results may replace those that they are made of.
  bool are_distinct_from(const std::vector<std::string>& results) const;
  // Opens the HTML report if --open asks for it, and says on standard error why it cannot be
  // opened.
  void open_if_asked() const;
  // Is anything written to standard output?
  bool use_standard_output() const;
  // The files that write() makes of results and as HTML; empty where there is none, and for results
  // on standard output.
  std::string json_path() const;
  std::string html_path() const;

 private:
  bool is_none_given() const;
  std::string junit_path() const;
  std::set<std::filesystem::path> folders() const;
};

}  // namespace edgecase
