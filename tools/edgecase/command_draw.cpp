// SPDX-License-Identifier: MIT
//
// edgecase draw: one case under every alternative of a rule, as text or as an SVG picture.
#include <fmt/format.h>

#include <memory>
#include <sstream>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "reports/alternatives_svg.h"
#include "rules/all_rules.h"
#include "run/expectation_check.h"
#include "tools/edgecase/commands.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

struct DrawCommand {
  std::string path;
  std::string rule = "line.algorithm";
  std::string svg;
};

AlternativesPicture draw_all(const Case& one, const Rule& rule, bool as_text) {
  AlternativesPicture picture;
  picture.width = one.scene.target.width;
  picture.height = one.scene.target.height;
  picture.figure = scene_figure(one.scene);
  for (const Alternative& alternative : rule.alternatives) {
    Policy policy;
    policy.rules[rule.id] = alternative.name;
    const Rendering rendering = rasterize(one.scene, policy);
    DrawnAlternative drawn{alternative.name, {}};
    for (const Fragment& fragment : rendering.fragments)
      drawn.pixels.emplace_back(fragment.x, fragment.y);
    picture.alternatives.push_back(std::move(drawn));
    if (as_text)
      fmt::print("{}\n{}\n", alternative.name,
                 draw_hits(hits_of(rendering), picture.width, picture.height));
  }
  return picture;
}

ExitCode draw(const DrawCommand& command) {
  const Rule* rule = find_rule(command.rule);
  if (rule == nullptr || rule->alternatives.empty()) {
    print_error(fmt::format("\"{}\" is no rule with alternatives; `edgecase rules` lists them",
                            command.rule));
    return ExitCode::usage;
  }
  Selection selection;
  selection.paths = {command.path};
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  // Of a case that expands to several, the base case.
  const Case& one = suite.cases.front();
  const AlternativesPicture picture = draw_all(one, *rule, command.svg.empty());
  if (command.svg.empty()) return ExitCode::as_expected;
  std::ostringstream text;
  write_alternatives_svg(picture, text);
  return write_file(command.svg, text.str()) ? ExitCode::as_expected : ExitCode::internal;
}

}  // namespace

void add_draw_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("draw", "Draw a case under every alternative of a rule, exactly");
  auto options = std::make_shared<DrawCommand>();
  command->add_option("case", options->path, "Case file")->required();
  command->add_option("--rule", options->rule, "The rule whose alternatives are drawn")
      ->capture_default_str();
  command->add_option("--svg", options->svg, "File for an SVG picture (default: text)");
  command->callback([options, &exit] { exit = draw(*options); });
}

}  // namespace edgecase
