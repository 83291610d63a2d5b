// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/report_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <iostream>
#include <map>
#include <utility>
#include <variant>

#include "reports/annotations.h"
#include "reports/ctrf.h"
#include "reports/disagreements_csv.h"
#include "reports/junit.h"
#include "reports/summary_markdown.h"
#include "results/results_json.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/folder_lock.h"
#include "tools/edgecase/output/html_report.h"
#include "tools/edgecase/output/open_report.h"
#include "tools/edgecase/output/triptych_files.h"

namespace edgecase {
namespace {

bool write_one(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path.empty()) return true;
  if (path != "-") return write_file(path, write);
  write(std::cout);
  return true;
}

void write_and_remember(const Results& results, const ResultsKey* key, std::ostream& out) {
  if (key == nullptr) return write_packed_results(results, out);
  CodedStream coded(out, *key);
  write_packed_results(results, coded);
  key->remember(coded.code());
}

// On GitHub, annotations are for files of the repository, wherever in it the command runs. Without
// what GitHub sets, the path as it was given.
std::string path_in_repository(const std::string& file) {
  const char* const workspace = std::getenv("GITHUB_WORKSPACE");
  if (workspace == nullptr || *workspace == '\0') return file;
  const std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path inside = path.lexically_relative(workspace);
  return inside.empty() || *inside.begin() == ".." ? file : inside.string();
}

}  // namespace

std::optional<Results> load_results(const std::string& path, ExitCode& exit, Cut cut) {
  auto file = open_file(path);
  if (!file) {
    exit = ExitCode::internal;
    return std::nullopt;
  }
  auto read = read_results(*file, cut);
  if (auto* results = std::get_if<Results>(&read)) return std::move(*results);
  exit = ExitCode::usage;
  print_error(fmt::format("{}: {}", path, std::get<std::string>(read)));
  return std::nullopt;
}

bool add_generation_of(const std::string& path, const Results& results, Generations& generations) {
  const auto fault = add_generation(generations, results);
  if (fault)
    print_error(fmt::format("{}: {}; run `edgecase run` without a selection", path, *fault));
  return !fault;
}

std::optional<Durations> load_durations(const std::vector<std::string>& paths, ExitCode& exit) {
  Durations all;
  for (const std::string& path : paths) {
    auto file = open_file(path);
    exit = ExitCode::internal;
    if (!file) return std::nullopt;
    auto read = read_durations(*file);
    exit = ExitCode::usage;
    if (const auto* fault = std::get_if<std::string>(&read)) {
      print_error(fmt::format("{}: {}", path, *fault));
      return std::nullopt;
    }
    for (auto& [id, by_renderer] : std::get<Durations>(read)) all[id].merge(by_renderer);
  }
  return all;
}

std::optional<Comparison> changes_since(Results before, const Results& results, ExitCode& exit) {
  if (!is_whole(results)) {
    std::set<std::string> ids;
    for (const CaseOutline& one : results.cases.outlines()) ids.insert(one.id);
    before.cases.erase_if([&](const CaseOutline& one) { return !ids.contains(one.id); });
  }
  exit = ExitCode::usage;
  auto compared = compare_results(before, results);
  if (auto* comparison = std::get_if<Comparison>(&compared)) return std::move(*comparison);
  print_error(std::get<std::string>(compared));
  return std::nullopt;
}

void add_timings_option(CLI::App& command, std::vector<std::string>& paths) {
  add_repeatable(command, "--timings", paths,
                 "File that `edgecase run --timings` wrote, for JUnit XML and CTRF; repeatable");
}

void ReportFiles::add_to(CLI::App& command, const std::string& json_names) {
  command.add_option(json_names, json,
                     "File for the results: lines of JSON, packed by Zstandard; - for standard "
                     "output, as they are");
  command.add_option("--junit", junit, "File for JUnit XML");
  command.add_option("--html", html, "File for the HTML report");
  command.add_option("--ctrf", ctrf, "File for CTRF JSON, the Common Test Report Format");
  command.add_option("--markdown", markdown,
                     "File for a summary in Markdown, at most 1 MB: $GITHUB_STEP_SUMMARY");
  command.add_option("--annotations", annotations,
                     "File for GitHub annotations of the ten case files with the worst results; - "
                     "prints them for a step of a workflow");
  command.add_option("--csv", csv,
                     "File for every disagreement as a row of comma-separated values");
  command.add_option("--triptychs", triptychs,
                     "Folder for PNG files, RENDERER/CASE.png: exact, difference and rendered of "
                     "each case that differs");
  command.add_flag("--all-details", all_details,
                   "Write what the HTML report has no room for into scripts beside it");
  command.add_flag("--open", open, "Open the HTML report in a browser when it is written");
}

void ReportFiles::open_if_asked() const {
  if (!open) return;
  const std::string path = html_path();
  if (path.empty())
    print_error("--open opens the HTML report, and none is written; add --html FILE");
  else if (const std::string fault = open_in_browser(path); !fault.empty())
    print_error(fmt::format("--open: {}; open {} in a browser", fault, path));
}

bool ReportFiles::is_none_given() const {
  return json.empty() && junit.empty() && html.empty() && ctrf.empty() && markdown.empty() &&
         annotations.empty() && csv.empty() && triptychs.empty();
}

bool ReportFiles::use_standard_output() const {
  const auto paths = {&json, &junit, &html, &ctrf, &markdown, &annotations, &csv};
  return std::any_of(paths.begin(), paths.end(),
                     [](const std::string* path) { return *path == "-"; });
}

std::string ReportFiles::json_path() const {
  if (is_none_given()) return kDefaultJson;
  return json == "-" ? "" : json;
}

std::string ReportFiles::html_path() const {
  return is_none_given() ? "out/report.html" : html;
}

std::string ReportFiles::junit_path() const {
  return is_none_given() ? "out/junit.xml" : junit;
}

std::vector<WrittenFile> ReportFiles::outputs() const {
  return {{"--json", json_path()}, {"--html", html_path()},   {"--junit", junit_path()},
          {"--ctrf", ctrf},        {"--markdown", markdown},  {"--annotations", annotations},
          {"--csv", csv},          {"--triptychs", triptychs}};
}

bool ReportFiles::are_distinct_from(const std::vector<std::string>& results) const {
  std::vector<WrittenFile> reports = outputs();
  if (!are_distinct(reports, {})) return false;
  reports.erase(reports.begin());
  return are_distinct(reports, {results.begin(), results.end()});
}

// Of all that is no standard output. The folder of triptychs is one entry of its own folder: it is
// made only when there is a triptych.
std::set<std::filesystem::path> ReportFiles::folders() const {
  std::set<std::filesystem::path> found;
  for (const auto& [option, path] : outputs()) {
    if (path.empty() || path == "-") continue;
    const std::filesystem::path written = path;
    const std::filesystem::path entry =
        written.has_filename() ? written : written.parent_path();  // "pictures/" is "pictures"
    const std::filesystem::path folder = entry.parent_path();
    found.insert(folder.empty() ? "." : folder);
  }
  return found;
}

bool ReportFiles::write(const Results& results) const {
  const FolderLock lock(folders());
  const bool none = is_none_given();
  bool wrote = true;
  std::future<std::vector<HtmlFile>> page;  // made while the results are written
  if (!html_path().empty())
    page = std::async(std::launch::async, [&] {
      return make_html_report(results, since, generations, html_path(), all_details);
    });
  const auto add = [&wrote](const std::string& path,
                            const std::function<void(std::ostream&)>& write) {
    wrote = write_one(path, write) && wrote;
  };
  add(none ? kDefaultJson : json, [&](std::ostream& out) {
    json == "-" ? write_results(results, out) : write_and_remember(results, key, out);
  });
  if (wrote) results_are_written();
  add(junit_path(), [&](std::ostream& out) { write_junit(results, durations, out); });
  add(ctrf, [&](std::ostream& out) { write_ctrf(results, durations, out); });
  add(markdown, [&](std::ostream& out) { write_markdown_summary(results, out); });
  add(annotations, [&](std::ostream& out) { write_annotations(results, path_in_repository, out); });
  add(csv, [&](std::ostream& out) { write_disagreements_csv(results, out); });
  if (page.valid()) wrote = write_html_report(page.get(), html_path()) && wrote;
  return (triptychs.empty() || write_triptychs(results, triptychs)) && wrote;
}

}  // namespace edgecase
