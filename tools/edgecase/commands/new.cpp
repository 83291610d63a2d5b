// SPDX-License-Identifier: MIT
//
// edgecase new: begins a case file from coordinates, from a case or a result, or from the simplest
// case about a rule. The file is well formed; its author corrects the texts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "casefile/scaffold.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "suite/example_case.h"
#include "suite/expectation_check.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

struct NewCommand {
  std::string file;
  std::vector<std::string> rules;
  std::string from;
  std::string results;
  std::vector<std::string> draws;
  std::string size;
  int samples = 1;
  std::string surface;
  std::string depth;
  std::string title;
  std::string why;
  std::string suite = default_suite();
  bool drawing = false;
  bool force = false;
};

// The text of a new file, and a description of its origin.
struct Begun {
  std::string text;
  std::string source;
};

bool is_known(const std::vector<std::string>& rules) {
  for (const std::string& rule : rules)
    if (find_rule(rule) == nullptr) {
      print_no_rule(rule);
      return false;
    }
  return true;
}

// The path from the file to its suite's schema; empty if it lies in no suite.
std::string schema_path(const std::string& file) {
  std::error_code error;
  const fs::path folder = fs::absolute(file, error).lexically_normal().parent_path();
  for (fs::path above = folder; above.has_relative_path(); above = above.parent_path())
    if (fs::exists(above / "case.schema.json", error))
      return (above / "case.schema.json").lexically_relative(folder).generic_string();
  return "";
}

// The default title of a case: the name of its file.
std::string name_of_file(const NewCommand& command) {
  return command.file == "-" ? "New case" : fs::path(command.file).stem().string();
}

// The default texts of a case about rules.
CaseWords words_about(const std::vector<std::string>& rules, const NewCommand& command) {
  const Rule& rule = *find_rule(rules.front());
  CaseWords words;
  words.schema = schema_path(command.file);
  words.title = fmt::format("{}: {}", name_of_file(command), rule.title);
  words.why = "Say what is hard about this scene, and why it must come out as it does.";
  words.rules = rules;
  const bool is_section = rule.spec.find_first_of("0123456789") == 0;
  words.spec = (is_section ? "GL 4.6 core, " : "") + rule.spec;
  return words;
}

void put_in(const NewCommand& command, CaseWords& words) {
  if (!command.title.empty()) words.title = command.title;
  if (!command.why.empty()) words.why = command.why;
  if (!command.rules.empty()) words.rules = command.rules;
}

// The default rule of a case with this primitive.
std::string usual_rule(const std::string& primitive) {
  if (primitive.starts_with("point")) return "point.ownership";
  return primitive.starts_with("line") ? "line.diamond-exit" : "triangle.fill-rule";
}

// Parses "WIDTHxHEIGHT"; prints an error and returns nothing for any other text.
std::optional<std::pair<int, int>> parse_size(const std::string& text) {
  int width = 0;
  int height = 0;
  char rest = '\0';
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2)
    return std::pair(width, height);
  print_error(
      fmt::format("--size \"{}\" is no size; write WIDTHxHEIGHT in pixels, like 8x8", text));
  return std::nullopt;
}

std::optional<Begun> begin_with_coordinates(const NewCommand& command) {
  Scaffold scaffold;
  for (const std::string& text : command.draws) {
    auto draw = parse_scaffold_draw(text);
    if (const auto* message = std::get_if<std::string>(&draw)) {
      print_error(fmt::format("--draw: {}", *message));
      return std::nullopt;
    }
    scaffold.draws.push_back(std::get<ScaffoldDraw>(std::move(draw)));
  }
  scaffold.width = scaffold.height = least_target(scaffold.draws);
  if (!command.size.empty()) {
    const auto size = parse_size(command.size);
    if (!size) return std::nullopt;
    std::tie(scaffold.width, scaffold.height) = *size;
  }
  scaffold.samples = command.samples;
  scaffold.surface = command.surface;
  scaffold.depth = command.depth;
  const auto rules = command.rules.empty()
                         ? std::vector{usual_rule(scaffold.draws.front().primitive)}
                         : command.rules;
  scaffold.words = words_about(rules, command);
  put_in(command, scaffold.words);
  return Begun{scaffold_text(scaffold), "coordinates"};
}

// Returns true if the author chose the case's colours, and not the loader.
bool says_colors(const Case& one) {
  return one.source->find("\"color\"") != std::string::npos ||
         one.source->find("\"clear\"") != std::string::npos;
}

std::optional<Begun> begin_with_scene(const Case& one, const CaseWords& words) {
  CaseText written = case_text(one.scene, words);
  print_diagnostics(written.diagnostics);
  if (!written.diagnostics.empty()) return std::nullopt;
  if (!says_colors(one)) written.text = without_colors(written.text);
  return Begun{std::move(written.text), one.id};
}

std::optional<Begun> begin_with_example(const NewCommand& command) {
  const auto found = simplest_case(command.suite, command.rules.front());
  if (!found) {
    print_error(
        fmt::format("no case in \"{}\" is about {} or a rule near it; give coordinates "
                    "with --draw, or another suite with --suite",
                    command.suite, command.rules.front()));
    return std::nullopt;
  }
  CaseWords words = words_about(command.rules, command);
  put_in(command, words);
  return begin_with_scene(found->example, words);
}

// The case of this id among those of its file.
std::optional<Case> find_case(LoadedCases loaded, const std::string& id) {
  print_diagnostics(loaded.diagnostics);
  if (!loaded.diagnostics.empty()) return std::nullopt;
  const auto found =
      std::ranges::find_if(loaded.cases, [&](const Case& one) { return one.id == id; });
  if (found != loaded.cases.end()) return std::move(*found);
  print_error(
      fmt::format("the file of \"{}\" has no such case; `edgecase run --list` lists ids", id));
  return std::nullopt;
}

std::string file_id(const std::string& id) {
  return id.substr(0, id.find(':'));
}

// Finds a case by path or id; of several cases of a file, the base case, whose id comes first.
std::optional<Case> find_in_suite(const NewCommand& command) {
  Suite suite = load_suite(selection_of(std::array{command.from}, command.suite));
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return std::nullopt;
  if (!suite.cases.empty()) return suite.cases[0];
  print_nothing_selected();
  return std::nullopt;
}

// The answers of a run's renderers: a sentence for each that differs.
std::string answers_of(const Results& results, const CaseResults& one) {
  std::string text;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const Result& result = one.results[r];
    if (result.verdict == Verdict::agree) continue;
    const std::string what = result.failure ? result.failure->reason
                             : result.disagreements.empty()
                                 ? "values differ"
                                 : result.disagreements.front().explanation;
    text += fmt::format(" {}: {}: {}", results.renderers[r].name, name_of(result.verdict), what);
  }
  return text;
}

// The case of the results, and its renderers' answers.
std::optional<std::pair<Case, std::string>> find_in_results(const NewCommand& command) {
  ExitCode ignored = ExitCode::as_expected;  // a missing case is the user's mistake, reported below
  const auto results = load_results(command.results, ignored);
  if (!results) return std::nullopt;
  const auto found = results->cases.find(command.from);
  if (!found) {
    print_error(fmt::format("{} has no case \"{}\"", command.results, command.from));
    return std::nullopt;
  }
  const CaseResults answered = results->cases[*found];
  auto one = find_case(load_cases(answered.file, file_id(answered.id)), answered.id);
  if (!one) return std::nullopt;
  return std::pair(std::move(*one), answers_of(*results, answered));
}

std::optional<Begun> begin_with_case(const NewCommand& command) {
  std::optional<Case> one;
  std::string answers;
  if (command.results.empty()) {
    one = find_in_suite(command);
  } else if (auto found = find_in_results(command)) {
    one = std::move(found->first);
    answers = std::move(found->second);
  }
  if (!one) return std::nullopt;
  CaseWords words;
  words.schema = schema_path(command.file);
  words.title = fmt::format("{}: after {}", name_of_file(command), one->id);
  words.why = one->why + answers;
  words.rules = one->rules;
  words.spec = one->spec;
  words.origin = one->origin;
  words.tags = one->tags;
  put_in(command, words);
  return begin_with_scene(*one, words);
}

// The text with the drawing of exact, for its author to check by hand.
std::optional<std::string> drawn(const std::string& text, const Case& one) {
  const Rendering exact = rasterize(one.scene, Policy{});
  if (one.scene.target.samples > 1 || !one.scene.supersampling.empty()) {
    print_error("--drawing draws targets of one sample without supersampling");
    return std::nullopt;
  }
  const std::string drawing =
      draw_hits(hits_of(exact), one.scene.target.width, one.scene.target.height);
  std::vector<std::string> rows;
  std::string row;
  for (const char c : drawing) {
    if (c != '\n') row += c;
    if (c == '\n' && !row.empty()) rows.push_back(std::exchange(row, ""));
  }
  if (!row.empty()) rows.push_back(row);
  return with_drawing(text, rows);
}

bool is_sound(const NewCommand& command) {
  if (command.file != "-" && fs::path(command.file).extension() != ".json") {
    print_error(
        fmt::format("\"{}\" is no name of a case file; it must end with .json", command.file));
    return false;
  }
  if (command.rules.empty() && command.from.empty() && command.draws.empty()) {
    print_error(
        "nothing to begin with; give --draw \"lines 0.5,0.5 6,1.5\", --from CASE or --rule RULE");
    return false;
  }
  std::error_code error;
  if (command.file != "-" && !command.force && fs::exists(command.file, error)) {
    print_error(
        fmt::format("{} exists; choose another name, or overwrite it with --force", command.file));
    return false;
  }
  return is_known(command.rules);
}

ExitCode make_new(const NewCommand& command) {
  if (!is_sound(command)) return ExitCode::usage;
  auto begun = !command.draws.empty()  ? begin_with_coordinates(command)
               : !command.from.empty() ? begin_with_case(command)
                                       : begin_with_example(command);
  if (!begun) return ExitCode::usage;
  const LoadedCases loaded = load_cases_text(begun->text, command.file, "new");
  print_diagnostics(loaded.diagnostics);
  if (!loaded.diagnostics.empty()) return ExitCode::usage;
  if (command.drawing) {
    auto text = drawn(begun->text, loaded.cases.front());
    if (!text) return ExitCode::usage;
    begun->text = std::move(*text);
  }
  if (command.file == "-") {
    fmt::print("{}", begun->text);
    return ExitCode::as_expected;
  }
  if (!write_file(command.file, begun->text)) return ExitCode::internal;
  fmt::print("{}: written, from {}. Put its words right{}; then `edgecase run {}` judges it.\n",
             command.file, begun->source,
             command.drawing ? " and check the drawing by hand: it is what exact draws" : "",
             command.file);
  return ExitCode::as_expected;
}

}  // namespace

void add_new_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "new", "Write a new case file: from coordinates, a case, a result or a rule");
  auto options = std::make_shared<NewCommand>();
  command
      ->add_option("file", options->file, "File to write, ending with .json; - for standard output")
      ->required();
  add_repeatable(*command, "--rule", options->rules,
                 "Rule that the case is about; repeatable. Without --from and --draw the file "
                 "begins with the suite's simplest case about the rule");
  CLI::Option* from =
      command->add_option("--from", options->from, "Case file or id of a case to begin with");
  command
      ->add_option("--results", options->results,
                   "Results file that holds the case which --from names")
      ->needs(from);
  add_repeatable(*command, "--draw", options->draws,
                 "Draw, repeatable: a primitive and its vertices, \"lines 0.5,0.5 6,1+1/2\"");
  CLI::Option* draw = command->get_option("--draw")->excludes(from);
  command->add_option("--size", options->size, "Size of the target, WIDTHxHEIGHT")->needs(draw);
  command->add_option("--samples", options->samples, "Samples per pixel")
      ->check(in_range(1, 16))
      ->needs(draw);
  command->add_option("--surface", options->surface, "Surface: fbo or window")->needs(draw);
  command->add_option("--depth", options->depth, "Format of the depth buffer")->needs(draw);
  command->add_option("--title", options->title, "Title, one line");
  command->add_option("--why", options->why, "Why the result must be as it is");
  command->add_option("--suite", options->suite, "Suite that ids and examples are looked up in")
      ->capture_default_str();
  command->add_flag("--drawing", options->drawing,
                    "Include the drawing of exact, which you check by hand");
  command->add_flag("--force", options->force, "Overwrite the file");
  command->callback([options, &exit] { exit = make_new(*options); });
}

}  // namespace edgecase
