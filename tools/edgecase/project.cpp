// SPDX-License-Identifier: MIT
#include "tools/edgecase/project.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <functional>

#include "casefile/json/text.h"
#include "model/renderer.h"
#include "run/renderers.h"
#include "tools/edgecase/file_safety.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/trust.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = "edgecase.toml";
constexpr const char* kNoFile = "/dev/null";  // as --config: no project
const std::vector<std::string> kOutputs = {"json",     "junit",       "html", "ctrf",
                                           "markdown", "annotations", "csv",  "triptychs"};

// Reads a parsed file into a project.
class ProjectReader {
 public:
  ProjectReader(const fs::path& file, Project& project) : file_(file), project_(project) {}

  void read(const toml::table& table) {
    const Keys keys = {
        {"cases", [&](const auto& node) { read_cases(texts("cases", node)); }},
        {"known", [&](const auto& node) { read_known(texts("known", node)); }},
        {"policy",
         [&](const auto& node) { options("--policy") = {own_file(text("policy", node))}; }},
        {"renderers", [&](const auto& node) { read_renderers(node); }},
        {"outputs", [&](const auto& node) { read_outputs(node); }},
    };
    read_keys("", table, keys);
    // `edgecase bless` reads the results that `edgecase run` writes.
    options("results") = options("--json");
  }

 private:
  using Keys = std::map<std::string, std::function<void(const toml::node&)>>;

  [[noreturn]] void fail(const toml::source_position& at, const std::string& what) const {
    throw ProjectError(fmt::format("{}:{}: {}", file_.string(), at.line, what));
  }

  std::vector<std::string>& options(const std::string& name) { return project_.options[name]; }

  void read_keys(const std::string& table_name, const toml::table& table, const Keys& keys) const {
    std::vector<std::string> known;
    for (const auto& [name, read] : keys) known.push_back(name);
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const auto found = keys.find(name);
      if (found != keys.end()) {
        found->second(node);
        continue;
      }
      const std::string nearest = nearest_name(name, known);
      fail(key.source().begin,
           fmt::format("{} has no key {}; {}it has {}",
                       table_name.empty() ? "a project" : "[" + table_name + "]", quote(name),
                       nearest.empty() ? "" : fmt::format("did you mean {}? ", quote(nearest)),
                       fmt::join(known, ", ")));
    }
  }

  std::string text(const std::string& key, const toml::node& node) const {
    const auto* value = node.as_string();
    if (value == nullptr || value->get().empty())
      fail(node.source().begin, fmt::format("{} is {}; write a text, such as {} = \"…\"",
                                            quote(key), kind_of(node), key));
    return value->get();
  }

  // A text, or a list of texts.
  std::vector<std::string> texts(const std::string& key, const toml::node& node) const {
    if (node.is_string()) return {text(key, node)};
    const toml::array* const list = node.as_array();
    if (list == nullptr || list->empty())
      fail(node.source().begin,
           fmt::format("{} is {}; write a text, or a list of texts", quote(key), kind_of(node)));
    std::vector<std::string> values;
    for (const toml::node& one : *list) values.push_back(text(key, one));
    return values;
  }

  void read_cases(const std::vector<std::string>& cases) {
    for (const std::string& one : cases) options("paths").push_back(own_file(one));
  }

  // `edgecase bless` writes to a folder, which may be missing before.
  void read_known(const std::vector<std::string>& known) {
    for (const std::string& one : known) {
      const bool is_folder = !one.ends_with(".json");
      if (is_folder && options("--folder").empty()) {
        options("--folder") = {path(one)};
        project_.refused["--folder"] = fault_of_output("known", one);
      }
      std::error_code error;
      if (!is_folder || fs::is_directory(path(one), error)) options("--known").push_back(path(one));
    }
  }

  const toml::table& table(const std::string& key, const toml::node& node) const {
    const toml::table* const found = node.as_table();
    if (found == nullptr)
      fail(node.source().begin,
           fmt::format("{} is {}; write a table: [{}]", quote(key), kind_of(node), key));
    return *found;
  }

  void read_renderers(const toml::node& node) {
    for (const auto& [key, value] : table("renderers", node)) {
      const std::string name(key.str());
      if (!is_own_name(name))
        fail(key.source().begin,
             fmt::format("{} is no name for a renderer of yours; write at most 64 letters, digits, "
                         "'.', '-' and '_', a letter or digit first, and not exact",
                         quote(name)));
      std::string address = text(name, value);
      if (address.starts_with(kRecordingPrefix))
        address = std::string(kRecordingPrefix) + path(address.substr(kRecordingPrefix.size()));
      project_.renderers[name] = address;
    }
  }

  void read_outputs(const toml::node& node) {
    Keys keys;
    for (const std::string& name : kOutputs)
      keys[name] = [this, name](const toml::node& value) {
        const std::string given = text(name, value);
        const std::string fault = given == "-" ? "" : fault_of_output(name, given);
        if (!fault.empty()) fail(value.source().begin, fault);
        options("--" + name) = {given == "-" ? given : path(given)};
      };
    read_keys("outputs", table("outputs", node), keys);
  }

  // A path in the file, relative to the working folder.
  std::string path(const std::string& text) const {
    if (fs::path(text).is_absolute()) return text;
    std::error_code error;
    return fs::absolute(project_.folder / text, error)
        .lexically_normal()
        .lexically_proximate(fs::current_path(error))
        .string();
  }

  // Why a command does not write to this path, which has to be in the project's folder, whatever
  // links say; empty: it does.
  std::string fault_of_output(const std::string& key, const std::string& given) const {
    const fs::path folder_of_file = project_.file.parent_path();
    const auto folder = without_links(folder_of_file);
    const auto place = without_links((folder_of_file / given).lexically_normal());
    const bool is_inside =
        folder && place && std::ranges::mismatch(*folder, *place).in1 == folder->end();
    if (fs::path(given).is_relative() && is_inside) return "";
    return fmt::format(
        "{} = {} is outside of the project's folder; name a path in it, or give {} "
        "on the command line",
        key, quote(given), key == "known" ? "--folder" : "--" + key);
  }

  // The path of a file or folder of the project, if it exists; otherwise the text is a name, an id
  // or a glob.
  std::string own_file(const std::string& text) const {
    std::error_code error;
    return fs::exists(project_.folder / text, error) ? path(text) : text;
  }

  static std::string kind_of(const toml::node& node) {
    if (node.is_string()) return "an empty text";
    if (node.is_array()) return node.as_array()->empty() ? "an empty list" : "a list";
    if (node.is_table()) return "a table";
    if (node.is_boolean()) return "true or false";
    return node.is_number() ? "a number" : "a date or time";
  }

  const fs::path& file_;
  Project& project_;
};

// The nearest project file from the working folder upward, relative to it; empty: there is none.
fs::path nearest_file() {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  for (fs::path folder = here; !error; folder = folder.parent_path()) {
    if (fs::is_regular_file(folder / kFileName, error))
      return folder == here ? fs::path(kFileName) : (folder / kFileName).lexically_relative(here);
    if (!folder.has_relative_path()) break;
    error.clear();
  }
  return {};
}

// The library follows dotted keys by recursion, so that one of many parts would overflow the stack.
std::string text_of_project(const fs::path& file) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 16;
  constexpr std::ptrdiff_t kMostDots = 2000;
  const TextFile read = read_text_file(file, kMostBytes);
  if (!read.text || read.text->empty())
    throw ProjectError(
        fmt::format("{}: it cannot be read, or is empty: {}; name the file of a project with "
                    "--config",
                    file.string(), read.text ? "it has no byte" : read.message));
  if (std::count(read.text->begin(), read.text->end(), '.') > kMostDots)
    throw ProjectError(
        fmt::format("{}: it has more than {} dots, in keys and texts together; name "
                    "folders in place of many files",
                    file.string(), kMostDots));
  return *read.text;
}

// The project of a file that is not read yet. Throws ProjectError where others can write the file
// and the user has not named it.
Project project_at(const fs::path& file, bool is_named) {
  Project project;
  // The same from every working folder.
  project.file = without_links(file.parent_path()).value_or("/") / file.filename();
  project.folder = file.parent_path();
  const std::string fault = how_others_can_write(project.file);
  project.is_writable_by_others = !fault.empty();
  if (!is_named && !fault.empty())
    throw ProjectError(
        fmt::format("{}: it is not used unasked, since {}; use it with --config {}, or none with "
                    "--config {}",
                    project.file.string(), fault, file.string(), kNoFile));
  return project;
}

}  // namespace

void Project::give(CLI::App& command, const std::vector<std::string>& wanted) const {
  for (const auto& [name, values] : options) {
    const bool is_wanted =
        wanted == kEveryOption || std::ranges::find(wanted, name) != wanted.end();
    CLI::Option* const option = command.get_option_no_throw(name);
    if (!is_wanted || option == nullptr || option->count() > 0 || values.empty()) continue;
    const auto refusal = refused.find(name);
    if (refusal != refused.end() && !refusal->second.empty())
      throw ProjectError(fmt::format("{}: {}", file.string(), refusal->second));
    for (const std::string& value : values) option->add_result(value);
    option->run_callback();
  }
}

void Project::refuse_misspelt(const std::string& renderer) const {
  std::vector<std::string> names;
  for (const auto& [name, address] : renderers) names.push_back(name);
  const std::string nearest = nearest_name(renderer, names);
  if (is_own_name(renderer) && !nearest.empty())
    throw ProjectError(fmt::format("there is no renderer {}; did you mean {}? The project has {}",
                                   quote(renderer), quote(nearest), fmt::join(names, ", ")));
}

void ProjectOption::add_config_to(CLI::App& command) {
  command
      .add_option("--config", config,
                  "Settings of a project: cases, renderers, policy, known faults, outputs "
                  "(default: the nearest edgecase.toml, from here upward)")
      ->envname("EDGECASE_CONFIG");
}

void ProjectOption::add_to(CLI::App& command) {
  add_config_to(command);
  command.add_flag("--trust", is_trusted,
                   "Run the programs and libraries that the project's file names, without asking; "
                   "remembered until the file changes");
}

void ProjectOption::take(CLI::App& command, std::vector<std::string>& named,
                         const std::vector<std::string>& wanted, bool asks_all) {
  const auto project = find_project(config);
  if (!project) return;
  project->give(command, wanted);
  if (named.empty() && asks_all)
    for (const auto& [name, address] : project->renderers) named.push_back(name);
  bool is_foreign = false;
  for (std::string& renderer : named) {
    const auto own = project->renderers.find(renderer);
    if (own == project->renderers.end()) {
      project->refuse_misspelt(renderer);
      continue;
    }
    renderer = fmt::format("{}={}", own->first, own->second);
    folders[own->first] = project->folder.string();
    is_foreign = is_foreign || is_foreign_code(own->second);
  }
  if (is_foreign && runs) require_trust(*project, is_trusted);
}

void ProjectOption::take(CLI::App& command, std::string& named,
                         const std::vector<std::string>& wanted) {
  std::vector<std::string> all = {named};
  take(command, all, wanted);
  named = all.front();
}

std::optional<Project> find_project(const std::string& config) {
  if (config == kNoFile) return std::nullopt;
  const fs::path file = config.empty() ? nearest_file() : fs::path(config);
  if (file.empty()) return std::nullopt;
  Project project = project_at(file, !config.empty());
  project.text = text_of_project(file);
  try {
    ProjectReader(file, project).read(toml::parse(project.text, file.string()));
  } catch (const toml::parse_error& error) {
    throw ProjectError(fmt::format("{}:{}: {}; https://toml.io explains the format", file.string(),
                                   error.source().begin.line, error.description()));
  }
  print_error(fmt::format("the project is {}", project.file.string()));
  return project;
}

}  // namespace edgecase
