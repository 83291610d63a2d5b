// SPDX-License-Identifier: MIT
//
// edgecase gallery: pictures under policies, beside OpenGL's exact ones and a renderer's.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>

#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/output/gallery_pages.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

struct GalleryCommand {
  std::vector<std::string> names;
  std::string renderer;
  std::string folder = "out/gallery";
  std::string suite = default_suite();
  SuiteRunOptions run;
};

std::vector<fs::path> galleries_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  // Sorted by name without suffix, so that a name precedes those that begin with it.
  std::ranges::sort(files, {}, [](const fs::path& file) { return file.stem(); });
  return files;
}

// The files of the named galleries, or of all; prints an error for each that does not exist.
std::vector<fs::path> gallery_files(const GalleryCommand& command, ExitCode& exit) {
  const fs::path folder = fs::path(command.suite) / "galleries";
  if (command.names.empty()) return galleries_in(folder);
  std::vector<fs::path> files;
  for (const std::string& name : command.names) {
    std::error_code error;
    const fs::path named = folder / (name + ".json");
    if (fs::is_regular_file(name, error)) {
      files.emplace_back(name);
    } else if (name.find('/') == std::string::npos && fs::is_regular_file(named, error)) {
      files.push_back(named);
    } else {
      std::vector<std::string> known;
      for (const fs::path& file : galleries_in(folder)) known.push_back(file.stem().string());
      print_error(
          fmt::format("there is no gallery \"{}\"; write the path of a gallery file, or one of {}",
                      name, fmt::join(known, ", ")));
      exit = worse(exit, ExitCode::usage);
    }
  }
  return files;
}

std::vector<LoadedPictures> load_all(const GalleryCommand& command, ExitCode& exit) {
  std::vector<LoadedPictures> galleries;
  std::set<std::string> names;
  for (const fs::path& file : gallery_files(command, exit)) {
    auto loaded = load_pictures(file, command.suite);
    if (!loaded) {
      exit = worse(exit, ExitCode::usage);
    } else if (names.insert(loaded->name).second) {
      galleries.push_back(std::move(*loaded));
    } else {
      print_error(
          fmt::format("two galleries are called {}; write them one after the other", loaded->name));
      exit = worse(exit, ExitCode::usage);
    }
  }
  return galleries;
}

// A picture that cannot be drawn is missing from its page; the others are written.
ExitCode exit_code_of_failures(const Results& results) {
  for (const CaseOutline& one : results.cases.outlines())
    for (const ResultOutline& answer : one.answers)
      if (answer.failure && answer.failure->kind != FailureKind::unsupported)
        return ExitCode::renderer;
  return ExitCode::as_expected;
}

ExitCode write_page(const GalleryCommand& command, const std::vector<LoadedPictures>& all,
                    const LoadedPictures& one, const Results& results) {
  GalleryPage page = gallery_page(one, results);
  for (const LoadedPictures& other : all)
    page.links.push_back({other.gallery.title, other.name == one.name ? "" : other.name + ".html"});
  std::ostringstream text;
  write_gallery(page, text);
  const fs::path path = fs::path(command.folder) / (one.name + ".html");
  if (!write_file(path, text.str())) return ExitCode::internal;
  fmt::print("Gallery: {}\n", path.string());
  return exit_code_of_failures(results);
}

ExitCode gallery(GalleryCommand command) {
  if (!command.renderer.empty()) command.run.renderers = {command.renderer};
  if (!are_known(command.run.named())) return ExitCode::usage;
  ExitCode exit = ExitCode::as_expected;
  const std::vector<LoadedPictures> all = load_all(command, exit);
  if (all.empty() && exit == ExitCode::as_expected) {
    print_error(fmt::format("{}/galleries holds no gallery", command.suite));
    return ExitCode::nothing_selected;
  }
  Selection selection;
  selection.paths = {command.suite};
  const auto profiles = load_profiles(selection, command.run.named());
  if (!profiles) return ExitCode::usage;
  for (const LoadedPictures& one : all) {
    Suite suite;
    suite.cases = one.cases;
    const auto results = run_against(suite, {}, *profiles, command.run);
    if (!results) return ExitCode::usage;
    if (results->interrupted) return worse(exit, ExitCode::unexpected);
    exit = worse(exit, write_page(command, all, one, *results));
  }
  return exit;
}

}  // namespace

void add_gallery_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "gallery", "Write HTML pages that show policies in pictures, beside OpenGL's");
  auto options = std::make_shared<GalleryCommand>();
  command->add_option("galleries", options->names,
                      "Names of galleries, or files (default: all of the suite)");
  command->add_option(
      "--against", options->renderer,
      "Renderer whose pictures stand beside those of the policies (default: that of `run`)");
  command->add_option("--html", options->folder, "Folder for the pages")->capture_default_str();
  command->add_option("--suite", options->suite, "Folder with cases, policies and galleries")
      ->capture_default_str();
  command->add_option("--timeout", options->run.timeout, "Seconds per case")
      ->check(in_range(0.01, 3600.0));
  command->add_option("--progress", options->run.progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
  options->run.project.add_to(*command);
  command->callback([options, command, &exit] {
    options->run.project.take(*command, options->renderer, {});
    exit = gallery(*options);
  });
}

}  // namespace edgecase
