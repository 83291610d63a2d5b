// SPDX-License-Identifier: MIT
//
// edgecase explain: why exact draws a case as it does, and why a renderer differs.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "raster/rasterizer.h"
#include "reports/text.h"
#include "results/worst_first.h"
#include "rules/all_rules.h"
#include "suite/expectation_check.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/output/block_walks.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/output/pixel_words.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct ExplainCommand {
  std::string path;
  std::vector<std::string> filters;
  std::string pixel;
  bool has_blocks = false;
  std::string blocks = "8";
  std::string svg;
  PolicyOptions policy;
  SuiteRunOptions run;
};

// Returns true if at least one case has the pixel; otherwise prints an error. Variants of a case
// may exchange width and height, so some of a file's cases may lack it.
bool check_pixel(const std::string& text, const Suite& suite) {
  const auto has_pixel = [&](const Case& one) {
    return parse_pixel(text, one.scene.target).has_value();
  };
  if (text.empty() || std::ranges::any_of(suite.cases, has_pixel)) return true;
  const Target target = suite.cases[0].scene.target;
  print_no_pixel(text, target);
  return false;
}

void print_coverage(const Scene& scene, const Policy& policy) {
  const Rendering exact = rasterize(scene, policy);
  if (exact.samples > 1) {
    fmt::print("Samples that are covered, in hexadecimal, bit s for sample s:\n{}",
               draw_masks(masks_of(exact).covered, exact.width, exact.height));
    return;
  }
  if (!exact.passes.empty())
    fmt::print("Fragments of all {} passes together:\n", exact.passes.size());
  fmt::print("{}", draw_hits(hits_of(exact), exact.width, exact.height));
}

void print_blocks(const Scene& scene, const Policy& policy, const BlockSizes& sizes) {
  if (scene.supersampling.empty()) {
    fmt::print("{}", xml_text(block_text(scene, policy, sizes)));
    return;
  }
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k) {
    fmt::print("In {}:\n", text_of_pass(scene.supersampling, k));
    print_blocks(pass_of(scene, k), policy, sizes);
  }
}

// The blocks of a case as a picture; of a supersampled one, those of its first pass.
ExitCode draw_blocks(const Case& one, const Policy& policy, const BlockSizes& sizes,
                     const std::string& file) {
  const bool is_supersampled = !one.scene.supersampling.empty();
  BlocksPicture picture =
      block_picture(is_supersampled ? pass_of(one.scene, 0) : one.scene, policy, sizes);
  if (picture.panels.empty()) {
    print_error(fmt::format("{} has no triangle that is walked by blocks", one.id));
    return ExitCode::usage;
  }
  picture.title = one.title;
  std::ostringstream text;
  write_blocks_svg(picture, text);
  return write_file(file, text.str()) ? ExitCode::as_expected : ExitCode::internal;
}

ExitCode draw_pixel(const Case& one, const Policy& policy, const std::string& pixel,
                    const std::string& file) {
  const auto place = parse_pixel(pixel, one.scene.target);
  if (!place) {
    print_no_pixel(pixel, one.scene.target);
    return ExitCode::usage;
  }
  std::ostringstream text;
  write_pixel_svg(pixel_picture(one, policy, *place), text);
  return write_file(file, text.str()) ? ExitCode::as_expected : ExitCode::internal;
}

ExitCode draw_picture(const Case& one, const Policy& policy, const BlockSizes& sizes,
                      const ExplainCommand& command) {
  if (command.has_blocks) return draw_blocks(one, policy, sizes, command.svg);
  if (!command.pixel.empty()) return draw_pixel(one, policy, command.pixel, command.svg);
  print_error("--svg draws blocks or a pixel; add --blocks, or --pixel X,Y");
  return ExitCode::usage;
}

void print_disagreement(const Disagreement& d, int samples) {
  fmt::print("  ({}, {}){} {}, {}, {}{}\n    {}\n", d.x, d.y,
             names_sample(d, samples) ? fmt::format(" sample {}", d.sample) : "", name_of(d.kind),
             name_of(d.rule),
             d.legality == Legality::illegal ? "NOT allowed" : describe(d.legality),
             d.cause.empty() ? "" : fmt::format(", cause {}", text_of(d.cause)), d.explanation);
  const Ruling* ruling = find_ruling(d.ruling);
  if (ruling == nullptr) return;
  fmt::print("    Ruling {}. {}\n", ruling->number, ruling->text);
  for (const RulingFact& fact : facts_of(*ruling))
    if (!is_legal(d)) fmt::print("      {}: {}\n", fact.name, fact.text);
}

void print_values(const ValueAggregate& values) {
  fmt::print(
      "  {}: {} of {} differ inside what ruling {} permits{}; worst {:.3g} ULP at ({}, {}), "
      "exactly {:.9g}, rendered {:.9g}{}; mean {:.3g} ULP, at most {:.3g} of the attribute's "
      "range\n",
      values.attribute, values.differing.size(), values.compared, values.ruling,
      values.cause.empty() ? "" : ", by " + text_of(values.cause), values.worst_ulp, values.worst.x,
      values.worst.y, values.worst_exact, values.worst_rendered, describe_permitted(values),
      values.mean_ulp, values.worst_relative);
}

void print_result(const Result& result, const RendererInfo& info, std::optional<Pixel> pixel,
                  int samples) {
  fmt::print("{} ({}): {}\n", info.name, one_line(info.device), name_of(result.verdict));
  if (result.failure)
    fmt::print("  {}: {}\n", name_of(result.failure->kind), one_line(result.failure->reason));
  for (const Disagreement* d : worst_first(result))
    if (!pixel || (pixel->x == d->x && pixel->y == d->y)) print_disagreement(*d, samples);
  for (const std::string& line : describe_counted(result)) fmt::print("  {}\n", line);
  for (const ValueAggregate& values : result.values) print_values(values);
}

// Prints the renderers' results for a case.
ExitCode print_results(const Case& one, const Policy& policy, const Selection& selection,
                       const ExplainCommand& command, std::optional<Pixel> pixel) {
  const auto profiles = load_profiles(selection, command.run.renderers);
  if (!profiles) return ExitCode::usage;
  Suite single;
  single.cases = {one};
  SuiteRunOptions options = command.run;
  options.invariance = true;
  const auto results = run_against(single, policy, *profiles, options);
  if (!results) return ExitCode::usage;
  if (results->cases.empty()) {
    print_error("interrupted before the renderers had answered");
    return ExitCode::unexpected;
  }
  ExitCode exit = ExitCode::as_expected;
  const CaseResults answered = results->cases[0];
  for (std::size_t r = 0; r < results->renderers.size(); ++r) {
    const Result& result = answered.results[r];
    print_result(result, results->renderers[r], pixel, one.scene.target.samples);
    if (result.failure) exit = ExitCode::renderer;
  }
  return exit;
}

ExitCode explain(const ExplainCommand& command) {
  Selection selection = select_cases({command.path});
  selection.filters = command.filters;
  if (!are_distinct({{"--svg", command.svg}}, selection.paths)) return ExitCode::usage;
  const auto policy = command.policy.load(selection, command.run.renderers);
  if (!policy) return ExitCode::usage;
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (suite.cases.empty()) {
    print_nothing_selected();
    return ExitCode::nothing_selected;
  }
  if (!check_pixel(command.pixel, suite)) return ExitCode::usage;
  const auto sizes = parse_block_sizes(command.blocks);
  if (!sizes) {
    print_error(
        fmt::format("--blocks \"{}\" names no sides of blocks; write 2, 4, 8, 16 or 32, or some of "
                    "them with commas between, larger ones first",
                    command.blocks));
    return ExitCode::usage;
  }
  // Of a case that expands to several, the base case, or the first that the filters select.
  if (!command.svg.empty())
    if (const ExitCode drawn = draw_picture(suite.cases[0], *policy, *sizes, command);
        drawn != ExitCode::as_expected)
      return drawn;
  ExitCode exit = ExitCode::as_expected;
  for (const Case& one : suite.cases) {
    std::optional<Pixel> pixel;
    if (!command.pixel.empty()) {
      pixel = parse_pixel(command.pixel, one.scene.target);
      if (!pixel) continue;
    }
    fmt::print("{}: {}\n{}\n", one_line(one.id), one_line(one.title), xml_text(one.why));
    print_coverage(one.scene, *policy);
    if (command.has_blocks) print_blocks(one.scene, *policy, *sizes);
    if (pixel) fmt::print("{}", xml_text(pixel_words(one.scene, *policy, *pixel)));
    if (command.run.renderers.empty()) continue;
    exit = worse(exit, print_results(one, *policy, selection, command, pixel));
    // If a case does not run, the others still do; an error or an interruption ends the command.
    if (exit != ExitCode::as_expected && exit != ExitCode::renderer) return exit;
  }
  return exit;
}

}  // namespace

void add_explain_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "explain", "Say why pixels of a case are drawn, and why a renderer differs");
  auto options = std::make_shared<ExplainCommand>();
  command->add_option("case", options->path, "Case file, or id of a case")->required();
  add_repeatable(*command, "--filter", options->filters,
                 "Only the cases of the file whose id matches this glob; repeatable");
  command->add_option("--pixel", options->pixel, "X,Y: only this pixel, y up");
  CLI::Option* blocks =
      command
          ->add_option(
              "--blocks", options->blocks,
              "Show how a walk over blocks of this side in pixels (8, or a list such as 32,8) "
              "accepts, rejects or tests each block of a triangle")
          ->expected(0, 1);
  command->add_option("--svg", options->svg,
                      "File for an SVG picture of the blocks, or of the pixel");
  options->policy.add_to(*command);
  options->run.add_to(*command);
  command->callback([options, blocks, command, &exit] {
    options->run.take_project(*command, false);
    options->has_blocks = blocks->count() > 0;
    if (options->blocks.empty()) options->blocks = "8";
    exit = explain(*options);
  });
}

}  // namespace edgecase
