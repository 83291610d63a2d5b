// SPDX-License-Identifier: MIT
#include "tools/edgecase/earlier_results.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "casefile/json/text.h"
#include "results/results_json.h"
#include "tools/edgecase/git_index.h"
#include "tools/edgecase/journal.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {
namespace {

bool is_in_ci() {
  const char* const value = std::getenv("CI");
  return value != nullptr && *value != '\0';
}

bool is_of_another_user(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) != 0 || status.st_uid != geteuid();
}

// Why a file that nobody named is not believed; empty: it is. `is_own`: it has its code.
std::string doubt_about(const std::string& path, bool is_own, const UserKey& key) {
  if (is_in_ci()) return "CI is set";
  if (is_of_another_user(path)) return "it belongs to another user";
  if (const auto* fault = std::get_if<std::string>(&key.made)) return *fault;
  if (!is_own) return "it is not as a run of yours wrote it";
  if (may_be_tracked(path)) return "git tracks it";
  return "";
}

bool is_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

// Larger files are no results that are worth it.
std::optional<std::string> contents_of(const std::string& path) {
  constexpr std::size_t kMost = std::size_t{1} << 28;  // bytes
  return read_text_file(path, kMost).text;
}

ExitCode refuse(const std::string& path, const std::string& results, const std::string& doubt) {
  print_error(
      fmt::format("--resume does not go on with {}, which nobody has named: {}; if you trust it, "
                  "name the results with --json {}, or else remove it",
                  path, doubt, results));
  return ExitCode::usage;
}

std::variant<EarlierRun, ExitCode> run_of_journal(const std::string& path, bool is_named,
                                                  const UserKey& key) {
  const std::string journal = journal_of(path).string();
  auto read = read_journal(journal, key.get(), is_named);
  if (const auto* fault = std::get_if<std::string>(&read)) {
    print_error(*fault);
    return ExitCode::usage;
  }
  auto& [run, is_own] = std::get<JournalRead>(read);
  if (!is_named && (run || !is_own))
    if (const std::string doubt = doubt_about(journal, is_own, key); !doubt.empty())
      return refuse(journal, path, doubt);
  return EarlierRun{std::move(run), is_own};
}

}  // namespace

FoundResults own_results(const std::string& path, const UserKey& key) {
  if (!is_file(path)) return {};
  std::optional<std::string> contents;
  if (key.get() != nullptr && !is_in_ci()) contents = contents_of(path);
  const bool is_own =
      contents && key.get()->remembers(ResultsKey::Coder(*key.get()).add(*contents).code());
  FoundResults found{std::nullopt, doubt_about(path, is_own, key)};
  if (!found.doubt.empty()) return found;
  auto read = read_results(*contents, Cut::kept);
  if (auto* results = std::get_if<Results>(&read)) found.results = std::move(*results);
  return found;
}

std::variant<EarlierRun, ExitCode> run_to_resume(const std::string& path, bool is_named,
                                                 const UserKey& key) {
  if (is_file(journal_of(path).string())) return run_of_journal(path, is_named, key);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return EarlierRun{std::nullopt, true};
  if (!is_named) {
    auto [results, doubt] = own_results(path, key);
    if (results) return EarlierRun{MergePart{path, std::move(*results)}, true};
    return refuse(path, path, doubt.empty() ? "it is no results file" : doubt);
  }
  ExitCode exit = ExitCode::as_expected;
  auto results = load_results(path, exit, Cut::kept);
  if (!results) return exit;
  return EarlierRun{MergePart{path, std::move(*results)}, false};
}

}  // namespace edgecase
