// SPDX-License-Identifier: MIT
//
// Options that several subcommands share, and their meanings.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/policy.h"
#include "run/profiles.h"
#include "suite/selection.h"

namespace edgecase {

inline constexpr const char* kToolName = "edgecase " EDGECASE_VERSION;

// Values from `least` to `most`, both included; a fault is worded alike by every CLI11.
template <class T>
CLI::Validator in_range(T least, T most) {
  const CLI::Range range(least, most);
  return {[range, least, most](std::string& value) {
            return range(value).empty()
                       ? std::string()
                       : fmt::format("Value {} not in range {} to {}", value, least, most);
          },
          range.get_description()};
}

// An option with exactly one value each time it is given, so that "--filter GLOB PATH" ends with a
// path.
void add_repeatable(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                    const std::string& description);

// The selection of words, which are paths, ids of the default suite, or globs of ids
// (suite/selection.h). Without words, the default suite.
Selection select_cases(const std::vector<std::string>& words);

// "there is no rule "line.snab"; did you mean "line.snap"? `edgecase rules` prints all".
void print_no_rule(const std::string& id);

// The options that select cases: PATH…, --suite, --filter, --exclude, --tag, --sample, --shard.
struct SelectionOptions {
  std::vector<std::string> paths;
  std::string suite;  // "core": the cases that the suite's file core.txt lists; empty: all
  std::vector<std::string> filters;
  std::vector<std::string> excludes;
  std::vector<std::string> tags;
  std::string sample;
  std::string shard;
  bool obeys_variables = false;  // set by add_to

  void add_to(CLI::App& command, bool with_shard);
  // The selection; without a path, `cases`. Throws CLI::ValidationError for a --suite without a
  // list, a bad --sample or --shard and, if that is an option and not given, for bad variables of
  // CI systems. If variables select a shard, prints so to standard error, and touches the file that
  // Bazel requires.
  Selection selection() const;
};

// --policy NAME|FILE and --no-latitude.
struct PolicyOptions {
  std::string policy = "opengl";
  bool no_latitude = false;

  void add_to(CLI::App& command);
  // `opengl`, a file, the name of a file in the suite's folder `policies`, or `profile`: the
  // profile of the only named renderer in the suite's folder `profiles`. Prints an error and
  // returns nothing if the policy cannot be read.
  std::optional<Policy> load(const Selection& selection,
                             const std::vector<std::string>& renderers = {}) const;
};

// The renderers' profiles, from the suite's folder `profiles`: NAME.json there, and of a release
// that has its own in a folder of the release's name (release_folder_of). A missing one is no
// error: differences are explained without a profile. Prints an error and returns nothing for a
// faulty file.
std::optional<Profiles> load_profiles(const Selection& selection,
                                      const std::vector<std::string>& renderers);

// The list of the core's cases in the suite's folder: an id a line, and lines that begin with '#'.
constexpr const char* kCoreList = "core.txt";

// The folder of known faults, below the suite's.
constexpr const char* kKnownFolder = "known";

// The folder with the known faults and policies for these paths: the nearest `cases`, or the first
// given folder.
std::filesystem::path suite_folder(const Selection& selection);

// True if the selection is the whole suite, or a shard of it, without filters.
bool is_whole_suite(const Selection& selection);

// --strict and --known, for commands that report unexpected results.
void add_strict_option(CLI::App& command, bool& strict);
void add_known_option(CLI::App& command, std::vector<std::string>& paths);

// Prints diagnostics to standard error, one a line. Here and below control characters are made
// visible by one_line() and xml_text(), so that foreign files and programs cannot control a
// terminal.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

// Prints a text to standard error. Never throws: a failure becomes an exit code.
void print_to_stderr(const std::string& text);

// Prints "edgecase: message" to standard error.
void print_error(const std::string& message);

// Prints that the selection has no case.
void print_nothing_selected();

// A pixel of a target, x to the right and y up.
struct Pixel {
  int x = 0;
  int y = 0;
};

// Parses "X,Y"; nothing for any other text, or a pixel outside the target.
std::optional<Pixel> parse_pixel(const std::string& text, const Target& target);

// Prints that --pixel is no pixel of this target.
void print_no_pixel(const std::string& text, const Target& target);

// Opens a file or pipe for reading; prints an error and returns nothing if it cannot.
std::optional<std::ifstream> open_file(const std::filesystem::path& path);

// Reads a whole regular file of at most 16 MiB (casefile/json/text.h); prints an error and returns
// nothing if it cannot.
std::optional<std::string> read_file(const std::filesystem::path& path);

// Writes a file that is complete at any time (output/whole_file.h), and creates its folder if
// necessary. Prints an error and returns false if it cannot.
bool write_file(const std::filesystem::path& path, const std::string& text);

// The same for contents too long for one text: `write` writes into the file.
bool write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

// Whether output to `descriptor` is coloured. `choice`: auto, always or never.
bool use_color(const std::string& choice, int descriptor);

}  // namespace edgecase
