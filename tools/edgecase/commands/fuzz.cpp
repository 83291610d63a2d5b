// SPDX-License-Identifier: MIT
//
// edgecase fuzz: random and mutated scenes until a renderer disagrees.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "casefile/loader.h"
#include "model/scene.h"
#include "reports/text.h"
#include "run/renderers.h"
#include "search/find.h"
#include "search/find_file.h"
#include "search/fuzz.h"
#include "search/fuzz_json.h"
#include "search/scene_size.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/output/progress_line.h"
#include "tools/edgecase/project.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct FuzzCommand {
  std::vector<std::string> renderers;
  ProjectOption project;
  std::vector<std::string> rules;
  std::vector<std::string> surfaces;
  std::vector<std::string> corpus;
  std::vector<std::string> known;
  PolicyOptions policy;
  std::string verdict = "convention";
  std::uint64_t seed = 1;
  std::optional<double> seconds;
  std::optional<std::size_t> count;
  std::optional<std::size_t> finds;
  bool exhaustive = false;
  std::size_t max_asks = FuzzOptions().minimize.max_asks;
  std::string save;
  std::string json;
  double timeout = 10;
  int jobs = 0;
  std::string progress = "auto";
};

Selection suite_selection() {
  Selection selection;
  selection.paths = {default_suite()};
  return selection;
}

// The renderers with their policies; prints an error and returns nothing if one cannot be used.
std::optional<std::vector<FuzzRenderer>> renderers_of(const FuzzCommand& command) {
  if (!are_known(command.renderers)) return std::nullopt;
  const Selection suite = suite_selection();
  const auto profiles = load_profiles(suite, command.renderers);
  if (!profiles) return std::nullopt;
  std::vector<FuzzRenderer> renderers;
  for (const std::string& name : command.renderers) {
    const auto policy = command.policy.load(suite, {name});
    if (!policy) return std::nullopt;
    const RendererOptions options{
        *policy, std::chrono::milliseconds(static_cast<int>(command.timeout * 1000)),
        worker_directory(), &interrupted(), command.project.folders};
    FuzzRenderer renderer;
    renderer.name = split_name(name).name;
    renderer.policy = *policy;
    renderer.profiles = profiles_of(*profiles, renderer.name);
    renderer.make = [name, options] {
      return std::get<std::unique_ptr<Renderer>>(make_renderer(name, options));
    };
    renderers.push_back(std::move(renderer));
  }
  return renderers;
}

// The cases of files and folders; prints an error and returns nothing if they cannot be loaded.
std::optional<std::vector<Case>> cases_of(const std::vector<std::string>& paths) {
  if (paths.empty()) return std::vector<Case>{};
  Suite suite = load_suite(select_cases(paths));
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return std::nullopt;
  return suite.cases.all();
}

// Adds finds from the JSON of an earlier search, or from case files.
bool add_known(const std::string& path, KnownFinds& known) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) {
    const auto text = read_file(path);
    if (!text) return false;
    if (text->find("\"finds\"") != std::string::npos) {
      auto read = read_known_finds(*text);
      if (const auto* message = std::get_if<std::string>(&read)) {
        print_error(fmt::format("{}: {}", path, *message));
        return false;
      }
      for (auto& [renderer, keys] : std::get<KnownKeys>(read))
        for (FindKey& key : keys) known.keys[renderer].push_back(std::move(key));
      return true;
    }
  }
  auto cases = cases_of({path});
  if (!cases) return false;
  for (Case& one : *cases) known.scenes.push_back(std::move(one.scene));
  return true;
}

// Keeps the finite families; prints an error if there are none.
bool keep_those_with_an_end(std::vector<const Family*>& families) {
  std::erase_if(families, [](const Family* family) { return family->scenes == 0; });
  if (!families.empty()) return true;
  std::vector<std::string> names;
  for (const Family& family : all_families())
    if (family.scenes != 0) names.emplace_back(family.name);
  print_error(fmt::format("--exhaustive: none of the families that --rules names has an end; {} do",
                          fmt::join(names, " and ")));
  return false;
}

// Names of the verdicts on something that differs.
std::vector<std::string> names_of_differences() {
  std::vector<std::string> names;
  for (const Verdict verdict : kDrawnVerdicts.subspan(1)) names.emplace_back(name_of(verdict));
  return names;
}

// The options without progress and stop; prints an error and returns nothing if they are wrong.
std::optional<FuzzOptions> options_of(const FuzzCommand& command) {
  FuzzOptions options;
  options.seed = command.seed;
  auto families = select_families(command.rules);
  if (const auto* message = std::get_if<std::string>(&families)) {
    print_error("--rules: " + *message);
    return std::nullopt;
  }
  options.families = std::get<std::vector<const Family*>>(std::move(families));
  options.exhaustive = command.exhaustive;
  if (options.exhaustive && !keep_those_with_an_end(options.families)) return std::nullopt;
  if (!command.surfaces.empty()) options.surfaces.clear();
  for (const std::string& name : command.surfaces) {
    Surface surface = Surface::fbo;
    parse_name(name, surface);
    options.surfaces.push_back(surface);
  }
  auto corpus = cases_of(command.corpus);
  if (!corpus) return std::nullopt;
  for (Case& one : *corpus) options.corpus.push_back({one.id, std::move(one.scene)});
  for (const std::string& path : command.known)
    if (!add_known(path, options.known)) return std::nullopt;
  parse_name(command.verdict, options.least);
  options.count = command.count;
  options.finds = command.finds;
  if (command.seconds)
    options.time = std::chrono::milliseconds(static_cast<std::int64_t>(*command.seconds * 1000));
  options.minimize.max_asks = command.max_asks;
  options.jobs =
      command.jobs > 0 ? command.jobs : static_cast<int>(std::thread::hardware_concurrency());
  options.stop = &interrupted();
  return options;
}

// The path from a folder to the suite's schema; empty if the folder is in no suite.
std::string schema_for(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::string up = "../";
  for (fs::path above = fs::absolute(folder, error).lexically_normal(); above.has_relative_path();
       above = above.parent_path(), up += "../") {
    if (fs::exists(above.parent_path() / "case.schema.json", error)) return up + "case.schema.json";
    if (above.filename() == "cases") break;
  }
  return "";
}

// Returns true if the file exists and has the same scene. An existing file is never overwritten.
bool is_saved_already(const std::filesystem::path& path, const Scene& scene) {
  const LoadedCases loaded = load_cases(path, "find");
  if (loaded.cases.size() == 1 && same_scene(loaded.cases.front().scene, scene)) return true;
  print_error(fmt::format("{} exists and holds another scene; it was left as it is, move it away",
                          path.string()));
  return false;
}

// Writes the finds and returns the path of each; empty for one that was not written.
std::vector<std::string> save(const FuzzCommand& command, const FuzzReport& report,
                              ExitCode& exit) {
  std::vector<std::string> files;
  const std::filesystem::path folder = command.save;
  for (const Find& find : report.finds) {
    files.emplace_back();
    const FindFile file = find_file(find, command.seed, schema_for(folder));
    if (!file.diagnostics.empty()) {
      print_diagnostics(file.diagnostics);
      print_error("no case file can say this find's scene: " + title_of(find));
      continue;
    }
    const std::filesystem::path path = folder / file.name;
    std::error_code error;
    const bool exists = std::filesystem::exists(path, error);
    const bool is_there = exists ? is_saved_already(path, find.scene) : write_file(path, file.text);
    if (is_there) files.back() = path.string();
    if (!is_there) exit = worse(exit, ExitCode::internal);
  }
  return files;
}

std::string counts_of(const std::map<Verdict, std::size_t>& finds) {
  std::vector<std::string> words;
  for (auto count = finds.rbegin(); count != finds.rend(); ++count)
    words.push_back(fmt::format("{} {}", count->second, name_of(count->first)));
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

std::string plural(std::int64_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void print_summary(const FuzzReport& report, const FuzzWords& words, double seconds) {
  std::map<Verdict, std::size_t> verdicts;
  for (std::size_t i = 0; i < report.finds.size(); ++i) {
    const Find& find = report.finds[i];
    ++verdicts[find.verdict];
    const SceneSize size = size_of(find.scene);
    const std::string file = i < words.files.size() ? words.files[i] : "";
    fmt::print(
        "{:<10}  {}: {}\n            {}, {}x{}, {}{}, shown by {}{}{}\n", name_of(find.verdict),
        find.renderer, title_of(find), plural(size.primitives, "primitive"),
        find.scene.target.width, find.scene.target.height, plural(size.fraction_bits, "bit"),
        size.fraction_bits == find.least_bits ? ", as few as can show it" : "",
        plural(static_cast<std::int64_t>(find.scenes), "scene"), file.empty() ? "" : ", ", file);
  }
  for (std::size_t r = 0; r < report.renderers.size(); ++r) {
    const FuzzedRenderer& renderer = report.renderers[r];
    fmt::print("{}: {} drawn, {} not drawn", words.renderers[r], renderer.drawn,
               renderer.not_drawn);
    if (renderer.failure)
      fmt::print(" ({}: {})", name_of(renderer.failure->kind), one_line(renderer.failure->reason));
    if (renderer.known > 0)
      fmt::print(", {} met again", plural(static_cast<std::int64_t>(renderer.known), "known find"));
    fmt::print("\n");
  }
  fmt::print("{} in {:.0f} s, {:.0f} per second; finds: {}\n",
             plural(static_cast<std::int64_t>(report.scenes), "scene"), seconds,
             static_cast<double>(report.scenes) / std::max(seconds, 1e-3), counts_of(verdicts));
}

ExitCode fuzz_exit_code(const FuzzReport& report) {
  ExitCode exit = report.finds.empty() ? ExitCode::as_expected : ExitCode::unexpected;
  for (const FuzzedRenderer& renderer : report.renderers)
    if (renderer.drawn == 0 && renderer.failure) exit = worse(exit, ExitCode::renderer);
  return exit;
}

ExitCode run_fuzz(FuzzCommand command) {
  if (command.renderers.empty()) command.renderers = {kDefaultRenderer};
  const auto renderers = renderers_of(command);
  if (!renderers) return ExitCode::usage;
  auto options = options_of(command);
  if (!options) return ExitCode::usage;
  ProgressLine progress(command.progress, "scenes");
  options->progress = [&](const FuzzProgress& done) {
    progress.update(done.scenes, "; finds: " + counts_of(done.finds));
  };
  const InterruptGuard guard;
  const auto start = std::chrono::steady_clock::now();
  const FuzzReport report = fuzz(*renderers, *options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  progress.clear();

  ExitCode exit = fuzz_exit_code(report);
  FuzzWords words{kToolName, command.policy.policy, command.seed, {}, {}};
  for (const FuzzRenderer& renderer : *renderers) words.renderers.push_back(renderer.name);
  if (!command.save.empty()) words.files = save(command, report, exit);
  if (command.json != "-") print_summary(report, words, seconds.count());
  if (command.json == "-")
    fmt::print("{}", fuzz_json(report, words));
  else if (!command.json.empty() && !write_file(command.json, fuzz_json(report, words)))
    exit = worse(exit, ExitCode::internal);
  return exit;
}

}  // namespace

void add_fuzz_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "fuzz", "Search random and mutated scenes for disagreements, and minimize each");
  auto options = std::make_shared<FuzzCommand>();
  add_repeatable(*command, "--against", options->renderers,
                 "Renderer, as `run` names them; repeatable");
  command
      ->add_option("--rules", options->rules,
                   "Families of scenes, ids of rules that scenes are about, or globs of them; "
                   "separated by commas (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--seed", options->seed, "Number that fixes the scenes")
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "Stop after so many seconds")
      ->check(in_range(0.1, 1e8));
  command->add_option("--count", options->count, "Stop after so many scenes")
      ->check(in_range(std::size_t{1}, std::size_t{1'000'000'000'000}));
  command->add_flag("--exhaustive", options->exhaustive,
                    "Render every scene of the finite families, such as grid-lines; then stop");
  command->add_option("--finds", options->finds, "Stop after so many finds")
      ->check(in_range(std::size_t{1}, std::size_t{1'000'000}));
  add_repeatable(*command, "--corpus", options->corpus,
                 "Case file, folder, id or glob of ids whose scenes are mutated, too; repeatable");
  command->get_option("--exhaustive")->excludes(command->get_option("--corpus"));
  add_repeatable(*command, "--known", options->known,
                 "Known finds, which are only counted: the JSON of an earlier search, a case file "
                 "or a folder; repeatable");
  options->policy.add_to(*command);
  command->add_option("--verdict", options->verdict, "The least verdict that makes a find")
      ->check(CLI::IsMember(names_of_differences()))
      ->capture_default_str();
  add_repeatable(*command, "--surface", options->surfaces,
                 "fbo or window; repeatable (default: both)");
  command->get_option("--surface")->check(CLI::IsMember({"fbo", "window"}));
  command
      ->add_option("--max-asks", options->max_asks,
                   "Most scenes that a renderer is asked to draw while one find is minimized")
      ->check(in_range(1, 10'000'000))
      ->capture_default_str();
  command->add_option("--save", options->save, "Folder to write each find to, as a case file");
  command->add_option("--json", options->json, "Write everything as JSON; - for standard output");
  command->add_option("--timeout", options->timeout, "Seconds per scene")
      ->check(in_range(0.01, 3600.0));
  command->add_option("--jobs", options->jobs, "Threads (default: one per processor)")
      ->check(in_range(1, 256));
  command->add_option("--progress", options->progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderers, {"--policy"}, true);
    exit = run_fuzz(*options);
  });
}

}  // namespace edgecase
