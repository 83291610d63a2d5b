// SPDX-License-Identifier: MIT
#include "tools/edgecase/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "casefile/json/json_document.h"
#include "casefile/json/text.h"
#include "casefile/loader.h"
#include "casefile/policy_reader.h"
#include "reports/text.h"
#include "results/known_faults.h"
#include "rules/all_rules.h"
#include "run/record.h"
#include "run/renderers.h"
#include "suite/sharding.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/output/whole_file.h"

namespace edgecase {
namespace {

// Bazel runs a test in shards only if it touches the file that this variable names.
void touch_status_file() {
  const char* path = std::getenv("TEST_SHARD_STATUS_FILE");
  if (path != nullptr && *path != '\0' && !write_file(path, ""))
    throw std::runtime_error("the file that TEST_SHARD_STATUS_FILE names cannot be touched");
}

// `text`: "I/N", of the option --`name`.
Shard shard_of_option(const char* name, const std::string& text) {
  const auto shard = parse_shard(text);
  if (!shard)
    throw CLI::ValidationError(
        fmt::format("--{}", name),
        fmt::format("\"{}\" is no {}; write I/N with I from 1 to N, for example 1/4", text, name));
  return *shard;
}

Shard shard_of_environment() {
  const auto choice = shard_of_variables([](const char* name) { return std::getenv(name); });
  if (const auto* fault = std::get_if<std::string>(&choice))
    throw CLI::ValidationError("environment", *fault);
  const auto& [shard, source] = std::get<ShardChoice>(choice);
  if (!source.empty())
    print_error(fmt::format("{} ask for shard {}/{}: only that share of the cases is taken", source,
                            shard.index + 1, shard.count));
  return shard;
}

// The names of the policies in a folder, in order: "cs184", "direct3d-11", "opengl" and so on.
std::vector<std::string> policy_names(const std::filesystem::path& folder) {
  std::set<std::string> names = {"opengl"};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
  return {names.begin(), names.end()};
}

// A path that cannot be accessed counts as no file.
bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

// A file of the selection's suite or, if that lacks it, the installed suite's.
std::filesystem::path suite_file(const Selection& selection, const std::filesystem::path& name) {
  const std::filesystem::path own = suite_folder(selection) / name;
  const std::filesystem::path installed = installed_suite() / name;
  return !is_file(own) && is_file(installed) ? installed : own;
}

// The file of a policy: the path itself, or a name in the suite's folder.
std::optional<std::filesystem::path> policy_file(const std::string& policy,
                                                 const Selection& selection) {
  if (is_file(policy)) return policy;
  if (policy.find('/') == std::string::npos) {
    const auto named = suite_file(selection, "policies/" + policy + ".json");
    if (is_file(named)) return named;
  }
  // If the suite has no policies, those of the installed suite are used.
  const auto folder = suite_file(selection, "policies/cs184.json").parent_path();
  const auto names = policy_names(folder);
  const std::string nearest = nearest_name(policy, names);
  print_error(
      fmt::format("there is no policy \"{}\"; {}write the path of a policy file, or one of {}",
                  policy, nearest.empty() ? "" : fmt::format("did you mean {}? ", quote(nearest)),
                  fmt::join(names, ", ")));
  return std::nullopt;
}

// The file with the profile of a renderer.
std::filesystem::path profile_file(const std::string& renderer, const Selection& selection) {
  return suite_file(selection,
                    std::filesystem::path("profiles") / file_name_about(known_name_of(renderer)));
}

// The files of that name, by the folder of their release; "" is of no release. Those of the
// selection's suite come before those of the installed suite.
std::map<std::string, std::filesystem::path> profile_files(const std::string& name,
                                                           const Selection& selection) {
  std::map<std::string, std::filesystem::path> files;
  for (const auto& suite : {suite_folder(selection), installed_suite()}) {
    const std::filesystem::path folder = suite / "profiles";
    if (is_file(folder / name)) files.emplace("", folder / name);
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
      if (is_file(entry.path() / name))
        files.emplace(entry.path().filename().string(), entry.path() / name);
  }
  return files;
}

std::optional<Policy> read_policy(const std::filesystem::path& file) {
  if (leads_out_of_suite(file)) {
    print_error(fmt::format("{}: {}; {}", file.string(), kLeadsOut, kLeadsOutRemedy));
    return std::nullopt;
  }
  LoadedPolicy loaded = load_policy(file, known_rules());
  print_diagnostics(loaded.diagnostics);
  return std::move(loaded.value);
}

// The file that `--policy` names.
std::optional<std::filesystem::path> find_policy(const std::string& policy,
                                                 const Selection& selection,
                                                 const std::vector<std::string>& renderers) {
  if (policy != "profile") return policy_file(policy, selection);
  if (renderers.size() != 1) {
    print_error("--policy profile is the profile of one renderer; name one with --against");
    return std::nullopt;
  }
  const auto file = profile_file(renderers.front(), selection);
  if (is_file(file)) return file;
  print_error(
      fmt::format("{0} has no profile yet; measure it with `edgecase profile --against {0} "
                  "--policy-file {1}`",
                  renderers.front(), file.string()));
  return std::nullopt;
}

// The ids that a suite's list names.
NamedCases core_of(const Selection& selection) {
  const auto file = suite_file(selection, kCoreList);
  std::istringstream in(read_text_file(file, kMaxFileBytes).text.value_or(""));
  NamedCases named;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') named.ids.insert(line);
  if (named.ids.empty())
    throw CLI::ValidationError(
        "--suite", fmt::format("{} lists no case; `edgecase separation --cover -o {}` makes it",
                               file.string(), file.string()));
  return named;
}

}  // namespace

Selection select_cases(const std::vector<std::string>& words) {
  const std::string suite = default_suite();
  return selection_of(words.empty() ? std::vector{suite} : words, suite);
}

void print_no_rule(const std::string& id) {
  std::vector<std::string> ids;
  for (const Rule& rule : all_rules()) ids.push_back(name_of(rule.id));
  const std::string nearest = nearest_name(id, ids);
  print_error(fmt::format("there is no rule \"{}\"; {}`edgecase rules` prints all", id,
                          nearest.empty() ? "" : fmt::format("did you mean {}? ", quote(nearest))));
}

void add_repeatable(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                    const std::string& description) {
  // One value each time, so that CLI11 does not read the glob "[ab]" as a list in brackets.
  command.add_option(name, values, description)
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void SelectionOptions::add_to(CLI::App& command, bool with_shard) {
  command.add_option("paths", paths,
                     "Case files and folders, ids of cases, globs of ids (default: the folder "
                     "cases, or the installed suite)");
  command
      .add_option("--suite", suite,
                  "Only a few cases: core, which tells apart whatever the whole suite tells apart")
      ->check(CLI::IsMember({"core"}));
  add_repeatable(command, "--filter", filters,
                 "Only cases whose id matches this shell glob; repeatable");
  add_repeatable(command, "--exclude", excludes,
                 "Leave out cases whose id matches this glob; repeatable");
  add_repeatable(command, "--tag", tags, "Only cases with this tag; repeatable");
  command.add_option("--sample", sample,
                     "I/N: only every N-th of the cases, from the I-th on, I from 1");
  obeys_variables = with_shard;
  if (with_shard)
    command.add_option("--shard", shard,
                       "I/N: only the I-th of N shares, I from 1 (default: from TEST_TOTAL_SHARDS "
                       "and TEST_SHARD_INDEX, or CI_NODE_TOTAL and CI_NODE_INDEX)");
}

Selection SelectionOptions::selection() const {
  Selection result = select_cases(paths);
  result.filters = filters;
  result.excludes = excludes;
  result.tags = tags;
  if (!suite.empty()) result.only = core_of(result);
  if (!sample.empty()) result.sample = shard_of_option("sample", sample);
  if (obeys_variables) {
    touch_status_file();
    result.shard = shard.empty() ? shard_of_environment() : shard_of_option("shard", shard);
  }
  return result;
}

void PolicyOptions::add_to(CLI::App& command) {
  command
      .add_option("--policy", policy,
                  "Rules of the exact side: opengl, a name in the suite's folder policies, a file, "
                  "or profile, the rules that the renderer was measured to follow")
      ->capture_default_str();
  command.add_flag("--no-latitude", no_latitude,
                   "Grant no latitude: every difference is a violation");
}

void add_strict_option(CLI::App& command, bool& strict) {
  command.add_flag(
      "--strict", strict,
      "Count contested differences as unexpected, like violations, unless they are known");
}

void add_known_option(CLI::App& command, std::vector<std::string>& paths) {
  add_repeatable(command, "--known", paths,
                 "File of known faults, or folder of them, repeatable (default: the suite's folder "
                 "known)");
}

std::optional<Policy> PolicyOptions::load(const Selection& selection,
                                          const std::vector<std::string>& renderers) const {
  Policy result;
  if (policy != "opengl") {
    const auto file = find_policy(policy, selection, renderers);
    auto read = file ? read_policy(*file) : std::nullopt;
    if (!read) return std::nullopt;
    result = std::move(*read);
  }
  if (no_latitude) result.latitude = Latitude::none;
  return result;
}

std::optional<Profiles> load_profiles(const Selection& selection,
                                      const std::vector<std::string>& renderers) {
  Profiles profiles;
  for (const std::string& renderer : renderers) {
    const std::string name = file_name_about(known_name_of(renderer));
    for (const auto& [release, file] : profile_files(name, selection)) {
      auto read = read_policy(file);
      if (!read) return std::nullopt;
      profiles[split_name(renderer).name].add(release, std::move(*read));
    }
  }
  return profiles;
}

std::filesystem::path suite_folder(const Selection& selection) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path given =
      selection.paths.empty() ? fs::path(default_suite()) : selection.paths.front();
  const fs::path first = fs::absolute(given, error).lexically_normal();
  for (fs::path folder = first; folder.has_relative_path(); folder = folder.parent_path())
    if (folder.filename() == "cases") return folder;
  return fs::is_directory(first, error) ? first : first.parent_path();
}

bool is_whole_suite(const Selection& selection) {
  namespace fs = std::filesystem;
  if (selection.only || !selection.diagnostics.empty() || !selection.filters.empty() ||
      !selection.excludes.empty() || !selection.tags.empty() || selection.sample.count > 1)
    return false;
  const fs::path folder = suite_folder(selection);
  return std::any_of(selection.paths.begin(), selection.paths.end(), [&](const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error) && fs::equivalent(path, folder, error);
  });
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    print_to_stderr(one_line(to_string(diagnostic)) + "\n");
}

void print_to_stderr(const std::string& text) {
  // A failure cannot be reported anywhere; run_program() turns it into an exit code.
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_error(const std::string& message) {
  print_to_stderr(fmt::format("edgecase: {}\n", xml_text(message)));
}

void print_nothing_selected() {
  print_error("no case is selected; `edgecase run --list` prints the ids of all");
}

std::optional<std::ifstream> open_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code ignored;
  // Reading a file of the system that tells no size, such as /proc/kmsg, may take for ever.
  if (in && std::filesystem::is_regular_file(path, ignored) &&
      std::filesystem::file_size(path, ignored) == 0)
    in.setstate(std::ios::eofbit);
  if (in && !std::filesystem::is_directory(path, ignored)) return in;
  print_error(fmt::format("cannot read {}: {}", path.string(), std::strerror(in ? EISDIR : errno)));
  return std::nullopt;
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  TextFile read = read_text_file(path, kMaxFileBytes);
  if (!read.text)
    print_error(fmt::format("cannot read {}: {}; {}", path.string(), read.message, read.remedy));
  return std::move(read.text);
}

bool write_file(const std::filesystem::path& path, const std::string& text) {
  return write_file(path, [&text](std::ostream& out) { out << text; });
}

bool write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& write) {
  const std::string fault = write_whole_file(path, write);
  if (!fault.empty()) print_error(fault);
  return fault.empty();
}

bool use_color(const std::string& choice, int descriptor) {
  if (choice == "always") return true;
  if (choice == "never" || std::getenv("NO_COLOR") != nullptr) return false;
  return isatty(descriptor) != 0;
}

std::optional<Pixel> parse_pixel(const std::string& text, const Target& target) {
  Pixel pixel;
  char rest = '\0';
  if (std::sscanf(text.c_str(), "%d,%d%c", &pixel.x, &pixel.y, &rest) == 2 && pixel.x >= 0 &&
      pixel.y >= 0 && pixel.x < target.width && pixel.y < target.height)
    return pixel;
  return std::nullopt;
}

void print_no_pixel(const std::string& text, const Target& target) {
  print_error(
      fmt::format("--pixel \"{}\" is no pixel of this target; write X,Y with X from 0 to {} "
                  "and Y from 0 (bottom) to {}",
                  text, target.width - 1, target.height - 1));
}

}  // namespace edgecase
