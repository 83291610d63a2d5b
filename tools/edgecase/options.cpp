// SPDX-License-Identifier: MIT
#include "tools/edgecase/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "casefile/policy_reader.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// A number that must be one: "3" of "I/N".
std::optional<int> to_number(const std::string& text) {
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || value < 0 || value > 1'000'000) return std::nullopt;
  return static_cast<int>(value);
}

std::optional<int> environment_number(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? to_number(value) : std::nullopt;
}

// "I/N" with I from 1, or what CI systems say: Bazel counts from 0, GitLab from 1.
Shard parse_shard(const std::string& text) {
  if (!text.empty()) {
    const std::size_t slash = text.find('/');
    const auto index = to_number(text.substr(0, slash));
    const auto count =
        slash != std::string::npos ? to_number(text.substr(slash + 1)) : std::nullopt;
    if (!index || !count || *index < 1 || *index > *count)
      throw CLI::ValidationError("--shard", fmt::format("\"{}\" is no shard; write I/N with I from "
                                                        "1 to N, for example 1/4",
                                                        text));
    return {*index - 1, *count};
  }
  const auto bazel_count = environment_number("TEST_TOTAL_SHARDS");
  const auto bazel_index = environment_number("TEST_SHARD_INDEX");
  if (bazel_count && bazel_index && *bazel_index < *bazel_count)
    return {*bazel_index, *bazel_count};
  const auto gitlab_count = environment_number("CI_NODE_TOTAL");
  const auto gitlab_index = environment_number("CI_NODE_INDEX");
  if (gitlab_count && gitlab_index && *gitlab_index >= 1 && *gitlab_index <= *gitlab_count)
    return {*gitlab_index - 1, *gitlab_count};
  return {};
}

std::vector<KnownRule> known_rules() {
  std::vector<KnownRule> result;
  for (const Rule& rule : all_rules()) {
    KnownRule known{rule.id, {}};
    for (const Alternative& alternative : rule.alternatives)
      known.alternatives.push_back(alternative.name);
    result.push_back(std::move(known));
  }
  return result;
}

// The names of the policies in a folder: "cs184, direct3d-11, ...".
std::string policy_names(const std::filesystem::path& folder) {
  std::set<std::string> names = {"opengl"};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
  return fmt::format("{}", fmt::join(names, ", "));
}

// The file that a policy's name stands for: itself, or one in the folder.
std::optional<std::filesystem::path> policy_file(const std::string& policy,
                                                 const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::is_regular_file(policy, error)) return policy;
  const std::filesystem::path named = folder / (policy + ".json");
  if (policy.find('/') == std::string::npos && std::filesystem::is_regular_file(named, error))
    return named;
  print_error(
      fmt::format("there is no policy \"{}\"; write the path of a policy file, or one of {}",
                  policy, policy_names(folder)));
  return std::nullopt;
}

// The first choice of a policy that OpenGL does not allow, as "rule=alternative"; empty: none.
std::string illegal_choice(const Policy& policy) {
  std::vector<const Choices*> all = {&policy.rules};
  for (const auto& [surface, choices] : policy.surfaces) all.push_back(&choices);
  for (const Choices* choices : all)
    for (const auto& [id, name] : *choices)
      if (find_alternative(*find_rule(id), name)->openness == Openness::illegal)
        return id + "=" + name;
  return "";
}

// What agrees with such a policy need not agree with OpenGL, and must not be called so.
bool may_grant_latitude(const Policy& policy, const std::filesystem::path& file) {
  const std::string choice = illegal_choice(policy);
  if (policy.latitude == Latitude::none || choice.empty()) return true;
  print_error(
      fmt::format("{}: {} is not what OpenGL allows, so the policy cannot grant OpenGL's "
                  "latitude; write \"latitude\": \"none\", or run with --strict",
                  file.string(), choice));
  return false;
}

}  // namespace

void add_repeatable(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                    const std::string& description) {
  command.add_option(name, values, description)->allow_extra_args(false);
}

void SelectionOptions::add_to(CLI::App& command, bool with_shard) {
  command.add_option("paths", paths, "Case files and folders of them (default: cases)");
  add_repeatable(command, "--filter", filters,
                 "Only cases whose id matches this shell glob; repeatable");
  add_repeatable(command, "--exclude", excludes,
                 "Not the cases whose id matches this glob; repeatable");
  add_repeatable(command, "--tag", tags, "Only cases with this tag; repeatable");
  if (with_shard)
    command.add_option(
        "--shard", shard,
        "I/N: only the I-th of N shares; TEST_TOTAL_SHARDS and CI_NODE_TOTAL work too");
}

Selection SelectionOptions::selection() const {
  Selection result;
  for (const std::string& path : paths) result.paths.emplace_back(path);
  if (result.paths.empty()) result.paths.emplace_back("cases");
  result.filters = filters;
  result.excludes = excludes;
  result.tags = tags;
  result.shard = parse_shard(shard);
  return result;
}

void PolicyOptions::add_to(CLI::App& command) {
  command
      .add_option(
          "--policy", policy,
          "Rules of the exact side: opengl, a name in the suite's folder policies, or a file")
      ->capture_default_str();
  command.add_flag("--strict", strict, "Grant no latitude: every difference is a violation");
}

std::optional<Policy> PolicyOptions::load(const Selection& selection) const {
  Policy result;
  if (policy != "opengl") {
    const auto file = policy_file(policy, suite_folder(selection) / "policies");
    if (!file) return std::nullopt;
    LoadedPolicy loaded = load_policy(*file, known_rules());
    print_diagnostics(loaded.diagnostics);
    if (!loaded.value) return std::nullopt;
    result = std::move(*loaded.value);
    if (!strict && !may_grant_latitude(result, *file)) return std::nullopt;
  }
  if (strict) result.latitude = Latitude::none;
  return result;
}

std::filesystem::path suite_folder(const Selection& selection) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path first = fs::absolute(selection.paths.front(), error).lexically_normal();
  for (fs::path folder = first; folder.has_relative_path(); folder = folder.parent_path())
    if (folder.filename() == "cases") return folder;
  return fs::is_directory(first, error) ? first : first.parent_path();
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    fmt::print(stderr, "{}\n", to_string(diagnostic));
}

void print_error(const std::string& message) {
  fmt::print(stderr, "edgecase: {}\n", message);
}

void print_nothing_selected() {
  print_error("no case is selected; `edgecase run --list` prints the ids of all");
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in || std::filesystem::is_directory(path)) {
    print_error(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
    return std::nullopt;
  }
  return text.str();
}

bool write_file(const std::filesystem::path& path, const std::string& text) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (out) return true;
  print_error(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
  return false;
}

bool use_color(const std::string& choice, int descriptor) {
  if (choice == "always") return true;
  if (choice == "never" || std::getenv("NO_COLOR") != nullptr) return false;
  return isatty(descriptor) != 0;
}

}  // namespace edgecase
