// SPDX-License-Identifier: MIT
//
// edgecase draw: one case as text or SVG, under every alternative of a rule, or as exact and a
// renderer draw it.
#include <fmt/format.h>

#include <memory>
#include <sstream>
#include <utility>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "reports/alternatives_svg.h"
#include "reports/difference_svg.h"
#include "rules/all_rules.h"
#include "suite/expectation_check.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/project.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct DrawCommand {
  std::string path;
  std::vector<std::string> filters;
  std::string rule = "line.algorithm";
  std::string renderer;
  ProjectOption project;
  std::string pane;
  std::string svg;
};

AlternativesPicture draw_all(const Case& one, const Rule& rule, bool as_text) {
  AlternativesPicture picture;
  picture.width = one.scene.target.width;
  picture.height = one.scene.target.height;
  picture.figure = scene_figure(one.scene);
  for (const Alternative& alternative : rule.alternatives) {
    Policy policy;
    policy.rules[name_of(rule.id)] = alternative.name;
    std::vector<int> hits = hits_of(rasterize(one.scene, policy));
    if (as_text)
      fmt::print("{}\n{}\n", alternative.name, draw_hits(hits, picture.width, picture.height));
    picture.alternatives.push_back({alternative.name, std::move(hits)});
  }
  return picture;
}

ExitCode deliver(const DrawCommand& command, const std::string& svg) {
  return write_file(command.svg, svg) ? ExitCode::as_expected : ExitCode::internal;
}

ExitCode draw_alternatives(const DrawCommand& command, const Case& one) {
  const Rule* rule = find_rule(command.rule);
  if (rule == nullptr) {
    print_no_rule(command.rule);
    return ExitCode::usage;
  }
  if (rule->alternatives.empty()) {
    print_error(fmt::format(
        "the rule {0} has no alternatives to draw; `edgecase rules {0}` prints it", command.rule));
    return ExitCode::usage;
  }
  const AlternativesPicture picture = draw_all(one, *rule, command.svg.empty());
  if (command.svg.empty()) return ExitCode::as_expected;
  std::ostringstream text;
  write_alternatives_svg(picture, text);
  return deliver(command, text.str());
}

// Those that are only counted (Result::counted) are drawn once more, or once less.
void add_counted_hits(const Result& result, int width, std::vector<int>& hits) {
  for (const CountedDisagreements& counted : result.counted) {
    if (counted.kind == DisagreementKind::value) continue;
    const int more = counted.kind == DisagreementKind::missing ? -1 : 1;
    for (const PixelRun& run : counted.runs)
      for (int x = run.begin; x < run.end; ++x)
        hits[static_cast<std::size_t>(run.y * width + x)] += more;
  }
}

DifferencePicture difference_of(const Case& one, const Policy& policy, const Results& results) {
  const CaseResults answered = results.cases[0];
  const Result& result = answered.results.front();
  DifferencePicture picture;
  picture.width = one.scene.target.width;
  picture.height = one.scene.target.height;
  picture.title = one.title;
  picture.renderer = results.renderers.front().name;
  picture.exact_hits = hits_of(rasterize(one.scene, policy));
  picture.rendered_hits = rendered_hits(picture.exact_hits, picture.width, result.disagreements);
  add_counted_hits(result, picture.width, picture.rendered_hits);
  picture.figure = scene_figure(one.scene);
  picture.disagreements = result.disagreements;
  picture.verdict = result.verdict;
  return picture;
}

ExitCode draw_difference(const DrawCommand& command, const Selection& selection, const Case& one) {
  SuiteRunOptions run;
  run.renderers = {command.renderer};
  run.project = command.project;
  run.progress = "never";
  const auto profiles = load_profiles(selection, run.renderers);
  if (!profiles) return ExitCode::usage;
  Suite single;
  single.cases = {one};
  const Policy policy;
  const auto results = run_against(single, policy, *profiles, run);
  if (!results) return ExitCode::usage;
  if (results->cases.empty()) return ExitCode::unexpected;
  if (const auto& failure = results->cases.outline(0).answers.front().failure) {
    print_error(
        fmt::format("{}: {}: {}", command.renderer, name_of(failure->kind), failure->reason));
    return ExitCode::renderer;
  }
  const DifferencePicture picture = difference_of(one, policy, *results);
  if (command.svg.empty()) {
    fmt::print("exact\n{}\n{}\n{}\n", draw_hits(picture.exact_hits, picture.width, picture.height),
               picture.renderer, draw_hits(picture.rendered_hits, picture.width, picture.height));
    return ExitCode::as_expected;
  }
  std::ostringstream text;
  if (const auto pane = pane_named(command.pane))
    write_pane_svg(picture, *pane, text);
  else
    write_difference_svg(picture, text);
  return deliver(command, text.str());
}

ExitCode draw(const DrawCommand& command) {
  Selection selection = select_cases({command.path});
  selection.filters = command.filters;
  if (!are_distinct({{"--svg", command.svg}}, selection.paths)) return ExitCode::usage;
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (suite.cases.empty()) {
    print_nothing_selected();
    return ExitCode::nothing_selected;
  }
  // If the file expands to several cases: the base case, or the first that the filters select.
  const Case one = suite.cases[0];
  if (command.renderer.empty()) return draw_alternatives(command, one);
  return draw_difference(command, selection, one);
}

}  // namespace

void add_draw_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "draw", "Draw a case under every alternative of a rule, or beside a renderer");
  auto options = std::make_shared<DrawCommand>();
  command->add_option("case", options->path, "Case file, or id of a case")->required();
  add_repeatable(*command, "--filter", options->filters,
                 "Only the cases of the file whose id matches this glob; repeatable");
  CLI::Option* rule =
      command->add_option("--rule", options->rule, "Rule whose alternatives are drawn")
          ->capture_default_str();
  CLI::Option* against = command
                             ->add_option("--against", options->renderer,
                                          "Renderer to draw beside exact, with the difference")
                             ->excludes(rule);
  CLI::Option* svg =
      command->add_option("--svg", options->svg, "File for an SVG picture (default: text)");
  command->add_option("--pane", options->pane, "One pane of that picture alone, without words")
      ->check(CLI::IsMember({"exact", "difference", "renderer"}))
      ->needs(against, svg);
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderer, {});
    exit = draw(*options);
  });
}

}  // namespace edgecase
