// SPDX-License-Identifier: MIT
//
// edgecase validate: checks the form and layout of case files, and their drawings against exact,
// without OpenGL.
#include <fmt/format.h>

#include <memory>
#include <set>

#include "casefile/case_reader.h"
#include "casefile/json/json_layout.h"
#include "casefile/policy_reader.h"
#include "model/text.h"
#include "raster/rasterizer.h"
#include "reports/text.h"
#include "rules/all_rules.h"
#include "suite/expectation_check.h"
#include "suite/selection.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

struct ValidateCommand {
  SelectionOptions selection;
  bool check_format = false;
  bool format = false;
  std::string schema;  // the schema to print; empty: none
};

// The files of the cases, in the order of their ids, each with its text.
std::map<std::filesystem::path, SharedText> files_of(const Suite& suite) {
  std::map<std::filesystem::path, SharedText> files;
  for (const Case& one : suite.cases) files.emplace(one.file, one.source);
  return files;
}

// Prints the files whose layout is not a suite's; if `write`, rewrites them. Returns the number of
// files left with another layout; nothing if one cannot be written.
std::optional<std::size_t> lay_out_files(const Suite& suite, bool write) {
  std::size_t left = 0;
  for (const auto& [file, source] : files_of(suite)) {
    const JsonDocument document = parse_json(*source, file.string());
    const std::string text = laid_out(*document.root);
    if (text == *source) continue;
    if (!write) {
      fmt::print("{}: not laid out; `edgecase validate --format` does it\n",
                 one_line(file.string()));
      ++left;
      continue;
    }
    if (!write_file(file, text)) return std::nullopt;
    fmt::print("{}: laid out\n", one_line(file.string()));
  }
  return left;
}

std::size_t print_unmet(const Suite& suite) {
  std::size_t unmet = 0;
  for (const Case& one : suite.cases) {
    const Policy policy;
    for (const std::string& drawing :
         unmet_drawings(one, policy.name, rasterize(one.scene, policy))) {
      print_to_stderr(xml_text(drawing));
      ++unmet;
    }
  }
  return unmet;
}

std::string schema_of(const std::string& files) {
  if (files == "gallery") return gallery_schema();
  return files == "policy" ? policy_schema(known_rules()) : case_schema();
}

ExitCode validate(const ValidateCommand& command) {
  if (!command.schema.empty()) {
    fmt::print("{}", schema_of(command.schema));
    return ExitCode::as_expected;
  }
  const Suite suite = load_suite(command.selection.selection());
  print_diagnostics(suite.diagnostics);
  if (suite.is_misspelt) return ExitCode::usage;
  for (const Diagnostic& note : suite.notes) fmt::print("{}\n", one_line(to_string(note)));
  const std::size_t unmet = print_unmet(suite);
  std::size_t disorderly = 0;
  if (command.format || command.check_format) {
    const auto left = lay_out_files(suite, command.format);
    if (!left) return ExitCode::internal;
    disorderly = *left;
  }
  fmt::print(
      "{} well formed, {}, {} not met\n", counted(suite.cases.size(), "case is", "cases are"),
      counted(suite.diagnostics.size(), "fault", "faults"), counted(unmet, "drawing", "drawings"));
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (unmet > 0 || disorderly > 0) return ExitCode::unexpected;
  if (!suite.cases.empty()) return ExitCode::as_expected;
  print_nothing_selected();
  return ExitCode::nothing_selected;
}

}  // namespace

void add_validate_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("validate", "Check case files and their drawings, without OpenGL");
  auto options = std::make_shared<ValidateCommand>();
  options->selection.add_to(*command, false);
  CLI::Option* check = command->add_flag("--check-format", options->check_format,
                                         "Also report files whose layout is not that of a suite");
  command->add_flag("--format", options->format, "Rewrite such files in the layout of a suite")
      ->excludes(check);
  command
      ->add_option("--schema", options->schema,
                   "Print the JSON schema of case, gallery or policy files, and check nothing")
      ->check(CLI::IsMember({"case", "gallery", "policy"}));
  command->callback([options, &exit] { exit = validate(*options); });
}

}  // namespace edgecase
