// SPDX-License-Identifier: MIT
//
// edgecase minimize: the smallest scene in which a renderer shows the same difference as in a case.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "casefile/case_writer.h"
#include "casefile/json/text.h"
#include "model/scene.h"
#include "model/text.h"
#include "reports/text.h"
#include "rules/all_rules.h"
#include "run/invariant_renderer.h"
#include "run/renderers.h"
#include "search/find.h"
#include "search/find_file.h"
#include "search/minimize.h"
#include "search/scene_size.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/project.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct MinimizeCommand {
  std::string path;
  std::string renderer;
  ProjectOption project;
  std::string rule;
  std::string pixel;
  std::string output;
  bool json = false;
  std::size_t max_asks = MinimizeOptions().max_asks;
  double timeout = 10;
  PolicyOptions policy;
};

// The case that a word names; prints an error if it is not exactly one.
std::optional<Case> find_case(const std::string& word, const Selection& selection, ExitCode& exit) {
  Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  exit = ExitCode::usage;
  if (!suite.diagnostics.empty()) return std::nullopt;
  if (suite.cases.size() == 1) return suite.cases[0];
  if (suite.cases.empty()) {
    print_nothing_selected();
    exit = ExitCode::nothing_selected;
    return std::nullopt;
  }
  print_error(fmt::format("{} stands for {} cases; name one of them, for example {}", word,
                          suite.cases.size(), suite.cases.id(suite.cases.size() - 1)));
  return std::nullopt;
}

bool is_about(const Result& result, const Signature& signature, const std::string& rule,
              std::optional<Pixel> pixel) {
  if (rule.empty() && !pixel) return true;
  for (const Disagreement* d : disagreements_of(result, signature))
    if ((rule.empty() || name_of(d->rule) == rule) &&
        (!pixel || (d->x == pixel->x && d->y == pixel->y)))
      return true;
  // Aggregated values are chosen by rule, since they have no pixel.
  return !pixel && !rule.empty() && signature.rule == rule && !signature.attribute.empty();
}

// The worst difference of an answer among those that the options choose: illegal ones are worse
// than contested ones, and these than legal ones, with or without a cause.
std::optional<Signature> choose_signature(const TrialAnswer& answer, const std::string& rule,
                                          std::optional<Pixel> pixel) {
  std::optional<Signature> chosen;
  for (const Signature& signature : answer.signatures) {
    if (!is_about(answer.result, signature, rule, pixel)) continue;
    if (!chosen || signature.legality > chosen->legality) chosen = signature;
  }
  return chosen;
}

// "2 primitives, 8x8, 9 fraction bits".
std::string words_of_size(const Scene& scene) {
  const SceneSize size = size_of(scene);
  const auto words = [](std::int64_t count, const char* one, const char* several) {
    return counted(static_cast<std::size_t>(count), one, several);
  };
  return fmt::format("{}, {}x{}, {}, {}", words(size.primitives, "primitive", "primitives"),
                     scene.target.width, scene.target.height,
                     words(size.fraction_bits, "fraction bit", "fraction bits"),
                     words(size.settings, "setting", "settings"));
}

// A sentence on the difference and the renderer's answer.
std::string why_of(const Result& result, const Signature& signature, const RendererInfo& info) {
  if (result.failure)
    return fmt::format("{} ({}) fails here: {}: {}", info.name, info.device,
                       name_of(result.failure->kind), text_for_file(result.failure->reason));
  const std::string legal = signature.legality == Legality::legal ? "the specification allows it"
                                                                  : describe(signature.legality);
  const auto finds = disagreements_of(result, signature);
  if (!finds.empty()) {
    const Disagreement& d = *finds.front();
    return fmt::format(
        "{} ({}), pixel ({}, {}): {}, {}{}. {}", info.name, info.device, d.x, d.y, name_of(d.kind),
        legal, d.cause.empty() ? "" : fmt::format(", as by {}", text_of(d.cause)), d.explanation);
  }
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty() && values.attribute == signature.attribute)
      return fmt::format(
          "{} ({}), pixel ({}, {}): {} is {:.9g} where exact has {:.9g}, within "
          "what is permitted.",
          info.name, info.device, values.worst.x, values.worst.y, values.attribute,
          values.worst_rendered, values.worst_exact);
  return fmt::format("{} ({}): {}.", info.name, info.device, title_of(signature));
}

// The rules of the new case: those of its difference, or the original's.
std::vector<std::string> rules_of(const Minimized& minimized, const Signature& signature,
                                  const Case& original) {
  std::vector<std::string> rules;
  if (!signature.rule.empty()) rules.push_back(signature.rule);
  for (const Disagreement* d : disagreements_of(minimized.result, signature))
    if (std::ranges::find(rules, name_of(d->rule)) == rules.end())
      rules.push_back(name_of(d->rule));
  return rules.empty() ? original.rules : rules;
}

CaseWords words_for(const Minimized& minimized, const Signature& signature, const Case& original,
                    RendererInfo info) {
  info.name = text_for_file(info.name);
  info.device = text_for_file(info.device);
  CaseWords words;
  words.title = beginning_of(fmt::format("{}: {}", info.name, title_of(signature)), kMostTitle);
  words.why =
      fmt::format("Minimised from {}. {}", original.id, why_of(minimized.result, signature, info));
  words.rules = rules_of(minimized, signature, original);
  words.spec = original.spec;
  words.origin = original.origin;
  return words;
}

const char* ending_words(MinimizeEnd end) {
  switch (end) {
    case MinimizeEnd::finished:
      return "";
    case MinimizeEnd::exhausted:
      return "; not finished, --max-asks is reached";
    case MinimizeEnd::stopped:
      return "; interrupted";
    case MinimizeEnd::not_reproduced:
      return "; the renderer did not show it again";
  }
  return "";
}

std::string json_text(const Minimized& minimized, const Signature& signature, const Case& original,
                      const RendererInfo& info, const std::string& text) {
  const auto size = [](const Scene& scene) {
    const SceneSize size_of_scene = size_of(scene);
    return nlohmann::ordered_json{{"primitives", size_of_scene.primitives},
                                  {"width", scene.target.width},
                                  {"height", scene.target.height},
                                  {"fraction_bits", size_of_scene.fraction_bits},
                                  {"settings", size_of_scene.settings}};
  };
  const nlohmann::ordered_json json{{"tool", kToolName},
                                    {"renderer", info.name},
                                    {"case", original.id},
                                    {"signature",
                                     {{"title", title_of(signature)},
                                      {"rule", signature.rule},
                                      {"kind", signature.kind},
                                      {"surface", signature.surface},
                                      {"legality", name_of(signature.legality)},
                                      {"cause", signature.cause},
                                      {"situation", signature.situation},
                                      {"attribute", signature.attribute},
                                      {"failure", signature.failure}}},
                                    {"from", size(original.scene)},
                                    {"to", size(minimized.scene)},
                                    {"finished", minimized.end == MinimizeEnd::finished},
                                    {"asks", minimized.asks},
                                    {"minimized", nlohmann::ordered_json::parse(text)}};
  // Bytes of the renderer's name that are not UTF-8 are replaced.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

ExitCode deliver(const MinimizeCommand& command, const Case& original, const Minimized& minimized,
                 const Signature& signature, const Trial& trial) {
  const RendererInfo& info = trial.info();
  CaseWords words = words_for(minimized, signature, original, info);
  words.invariant = trial.asks_for_images();
  const CaseText written = case_text(minimized.scene, words);
  if (written.text.empty()) {
    print_diagnostics(written.diagnostics);
    print_error("no case file can say the minimised scene");
    return ExitCode::usage;
  }
  print_to_stderr(fmt::format(
      "{}: {}\n  from {}\n  to {}: {}\n  {}{}\n", one_line(original.id), title_of(signature),
      words_of_size(original.scene), words_of_size(minimized.scene), scene_text(minimized.scene),
      counted(minimized.asks, "scene asked", "scenes asked"), ending_words(minimized.end)));
  const std::string text =
      command.json ? json_text(minimized, signature, original, info, written.text) : written.text;
  if (command.output.empty())
    fmt::print("{}", text);
  else if (!write_file(command.output, text))
    return ExitCode::internal;
  return minimized.end == MinimizeEnd::stopped ? ExitCode::unexpected : ExitCode::as_expected;
}

// Images of the scenes are drawn only where the scenes alone do not show the find.
void choose_images(Trial& trial, const Scene& scene, const Signature& signature) {
  trial.ask_for_images(false);
  const TrialAnswer alone = trial.ask(scene);
  trial.ask_for_images(std::ranges::find(alone.signatures, signature) == alone.signatures.end());
}

// Returns true if the renderer draws anything at all; otherwise its failure at a case is no find.
bool is_at_work(Trial& trial) {
  Scene nothing;
  nothing.target.width = nothing.target.height = 1;
  nothing.viewport = {0, 0, 1, 1};
  trial.ask_for_images(false);
  return !trial.ask(nothing).result.failure;
}

// The difference that the options choose; prints an error if there is none.
std::optional<Signature> find_signature(const MinimizeCommand& command, const Case& original,
                                        const TrialAnswer& answer, std::optional<Pixel> pixel,
                                        Trial& trial, ExitCode& exit) {
  const auto chosen = choose_signature(answer, command.rule, pixel);
  const auto& failure = answer.result.failure;
  if (chosen && (!failure || is_at_work(trial))) return chosen;
  if (failure) {
    print_error(fmt::format("{} does not render {}: {}: {}", command.renderer, original.id,
                            name_of(failure->kind), failure->reason));
    exit = ExitCode::renderer;
    return std::nullopt;
  }
  exit = ExitCode::nothing_selected;
  if (answer.signatures.empty()) {
    print_error(fmt::format("nothing to minimise: {} agrees with exact on {} under this policy",
                            command.renderer, original.id));
    return std::nullopt;
  }
  std::string shown;
  for (const Signature& signature : answer.signatures) shown += "\n  " + title_of(signature);
  print_error(
      fmt::format("nothing to minimise: nothing of what {} shows of {} is at this rule or "
                  "pixel; it shows{}",
                  original.id, command.renderer, shown));
  return std::nullopt;
}

ExitCode minimize_case(const MinimizeCommand& command, const Case& original,
                       const TrialOptions& options) {
  std::optional<Pixel> pixel;
  if (!command.pixel.empty()) {
    pixel = parse_pixel(command.pixel, original.scene.target);
    if (!pixel) {
      print_no_pixel(command.pixel, original.scene.target);
      return ExitCode::usage;
    }
  }
  auto made = make_renderer(
      command.renderer,
      {options.policy, std::chrono::milliseconds(static_cast<int>(command.timeout * 1000)),
       worker_directory(), &interrupted(), command.project.folders});
  InvariantRenderer renderer(std::move(std::get<std::unique_ptr<Renderer>>(made)));
  Trial trial(renderer, options);
  trial.ask_for_images(true);
  const InterruptGuard guard;
  try {
    ExitCode exit = ExitCode::as_expected;
    const TrialAnswer answer = trial.ask(original.scene);
    const auto signature = find_signature(command, original, answer, pixel, trial, exit);
    if (!signature) return exit;
    choose_images(trial, original.scene, *signature);
    const Minimized minimized = minimize(original.scene, *signature, trial, {command.max_asks});
    return deliver(command, original, minimized, *signature, trial);
  } catch (const SearchStopped&) {
    print_error("interrupted before anything was found");
    return ExitCode::unexpected;
  }
}

ExitCode run_minimize(const MinimizeCommand& command) {
  const Selection selection = select_cases({command.path});
  if (!are_distinct({{"--output", command.output}}, selection.paths)) return ExitCode::usage;
  const auto policy = command.policy.load(selection, {command.renderer});
  if (!policy || !are_known({command.renderer})) return ExitCode::usage;
  const auto profiles = load_profiles(selection, {command.renderer});
  if (!profiles) return ExitCode::usage;
  if (!command.rule.empty() && find_rule(command.rule) == nullptr) {
    print_no_rule(command.rule);
    return ExitCode::usage;
  }
  ExitCode exit = ExitCode::as_expected;
  const auto original = find_case(command.path, selection, exit);
  if (!original) return exit;
  TrialOptions options;
  options.policy = *policy;
  options.profiles = profiles_of(*profiles, split_name(command.renderer).name);
  options.stop = &interrupted();
  return minimize_case(command, *original, options);
}

}  // namespace

void add_minimize_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "minimize", "Find the smallest scene that shows the same difference as a case");
  auto options = std::make_shared<MinimizeCommand>();
  command
      ->add_option("case", options->path,
                   "Case file, or id of a case; path:axis=value is one of a sweep")
      ->required();
  command->add_option("--against", options->renderer, "Renderer, as `run` names them")->required();
  command->add_option(
      "--rule", options->rule,
      "Id of the rule whose difference is minimized (default: the worst difference)");
  command->add_option("--pixel", options->pixel,
                      "X,Y: minimize the difference at this pixel, y up");
  command->add_option("-o,--output", options->output,
                      "File to write the case to (default: standard output)");
  command->add_flag("--json", options->json, "Print the case and what was done as JSON");
  command
      ->add_option("--max-asks", options->max_asks,
                   "Most scenes that the renderer is asked to draw")
      ->check(in_range(1, 10'000'000))
      ->capture_default_str();
  command->add_option("--timeout", options->timeout, "Seconds per scene")
      ->check(in_range(0.01, 3600.0));
  options->policy.add_to(*command);
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderer, {"--policy"});
    exit = run_minimize(*options);
  });
}

}  // namespace edgecase
