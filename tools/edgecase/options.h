// SPDX-License-Identifier: MIT
//
// Options that several subcommands share, and what they mean.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "casefile/policy_reader.h"
#include "model/policy.h"
#include "run/selection.h"

namespace edgecase {

inline constexpr const char* kToolName = "edgecase " EDGECASE_VERSION;

// Every rule of the catalogue, with its alternatives.
std::vector<KnownRule> known_rules();

// An option that takes one value each time it is given, so that "--filter GLOB PATH" ends with a
// path.
void add_repeatable(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                    const std::string& description);

// What words select: paths, ids of the default suite, and globs of them (run/named_cases.h).
// Without words the default suite.
Selection select_cases(const std::vector<std::string>& words);

// "there is no rule "line.snab"; did you mean "line.snap"? `edgecase rules` prints all".
void print_no_rule(const std::string& id);

// Which cases: PATH…, --filter, --exclude, --tag, --shard.
struct SelectionOptions {
  std::vector<std::string> paths;
  std::vector<std::string> filters;
  std::vector<std::string> excludes;
  std::vector<std::string> tags;
  std::string shard;
  bool obeys_variables = false;  // set by add_to

  void add_to(CLI::App& command, bool with_shard);
  // The selection, `cases` where no path is given; throws CLI::ValidationError for a bad --shard
  // and, where `--shard` is an option and not given, for bad variables of CI systems. Says on
  // standard error when variables decide, and touches the file by which Bazel learns that they do.
  Selection selection() const;
};

// --policy NAME|FILE and --no-latitude.
struct PolicyOptions {
  std::string policy = "opengl";
  bool no_latitude = false;

  void add_to(CLI::App& command);
  // `opengl`, a file, the name of a file in the suite's folder `policies`, or `profile`: what the
  // suite's folder `profiles` has of the one renderer that is named. Prints what is wrong and
  // returns nothing when the policy cannot be had.
  std::optional<Policy> load(const Selection& selection,
                             const std::vector<std::string>& renderers = {}) const;
};

// What each renderer is measured to follow, by name, from the suite's folder `profiles`. One that
// is not there is no error: its differences are then explained without a profile. Prints what is
// wrong with a file and returns nothing.
std::optional<std::map<std::string, Policy>> load_profiles(
    const Selection& selection, const std::vector<std::string>& renderers);

// The folder of known faults, below the suite's.
constexpr const char* kKnownFolder = "known";

// The folder whose known faults and policies belong to these paths: the nearest `cases`, or the
// first folder given.
std::filesystem::path suite_folder(const Selection& selection);

// Are these all cases of the suite's folder, or a shard of them, with nothing filtered out?
bool is_whole_suite(const Selection& selection);

// --strict and --known, of commands that say what is unexpected.
void add_strict_option(CLI::App& command, bool& strict);
void add_known_option(CLI::App& command, std::vector<std::string>& paths);

// Prints diagnostics, one a line, to standard error. Here and below control characters are shown
// as one_line() and xml_text() show them: files and programs that others wrote must not speak to a
// terminal.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

// Prints a text to standard error. Never throws: an exit code says that it could not be written.
void print_to_stderr(const std::string& text);

// Prints "edgecase: message" to standard error.
void print_error(const std::string& message);

// Says that the selection has no case.
void print_nothing_selected();

// A pixel of a target, x to the right and y up.
struct Pixel {
  int x = 0;
  int y = 0;
};

// "X,Y" inside the target, or none.
std::optional<Pixel> parse_pixel(const std::string& text, const Target& target);

// Says that --pixel is none of this target.
void print_no_pixel(const std::string& text, const Target& target);

// Opens a file, or pipe, to be read; prints an error and returns nothing when it cannot be.
std::optional<std::ifstream> open_file(const std::filesystem::path& path);

// Reads a whole file, or pipe, of at most 2 GiB; prints an error and returns nothing when it cannot
// be read.
std::optional<std::string> read_file(const std::filesystem::path& path);

// Writes a file that is whole at any time (output/whole_file.h), its folder made if need be; false,
// with the error printed, when it cannot be.
bool write_file(const std::filesystem::path& path, const std::string& text);

// The same for what is too long to be held as one text: `write` writes into the file.
bool write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

// Should output to `descriptor` be coloured? `choice`: auto, always or never.
bool use_color(const std::string& choice, int descriptor);

}  // namespace edgecase
