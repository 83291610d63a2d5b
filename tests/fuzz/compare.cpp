// SPDX-License-Identifier: MIT
//
// Answers that lie, compared. The input chooses a scene of the suite or of the generator, by which
// policy its right answer is drawn, how it is spoilt (spoils.h), which reader it goes through, and
// by which policy it is judged. So most answers are read, and reach all that compares, judges,
// writes and reads results.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "casefile/loader.h"
#include "diff/compare.h"
#include "diff/display_data.h"
#include "generate/random_scenes.h"
#include "raster/rasterizer.h"
#include "recording/recording.h"
#include "results/results_json.h"
#include "rules/all_rules.h"
#include "run/comparing.h"
#include "run/judging.h"
#include "tests/fuzz/choices.h"
#include "tests/fuzz/spoils.h"
#include "tests/fuzz/target.h"
#include "wire/answer_line.h"
#include "wire/message.h"
#include "wire/request_line.h"

namespace {

using namespace edgecase;
using nlohmann::json;

// Larger scenes show nothing that these do not, and take all of a run's time.
constexpr std::size_t kMostSamples = 1024;
constexpr std::size_t kMostTexels = 4096;
constexpr std::size_t kMostVertices = 64;

// Of sweeps some hundred cases differ in numbers alone.
constexpr std::size_t kMostOfFile = 16;

bool is_small(const Scene& scene) {
  const Target& target = scene.target;
  const std::size_t samples = static_cast<std::size_t>(target.width) *
                              static_cast<std::size_t>(target.height) *
                              static_cast<std::size_t>(target.samples);
  std::size_t texels = 0;
  for (const auto& texture : scene.textures)
    for (const TextureLevel& level : texture->levels) texels += level.texels.size() / 4;
  std::size_t vertices = 0;
  for (const Draw& draw : scene.draws) vertices += draw.vertices.size();
  return samples * std::max<std::size_t>(1, scene.supersampling.size()) <= kMostSamples &&
         texels <= kMostTexels && vertices <= kMostVertices;
}

// ------------------------------------------------------------------------------------------ scenes

// The files of the suite by a number made of their ids, so that an input stands for the same one
// when others are added.
const std::map<std::uint32_t, CaseFile>& suite_files() {
  static const std::map<std::uint32_t, CaseFile> files = [] {
    const std::vector<std::filesystem::path> paths{EDGECASE_ROOT "/cases"};
    std::map<std::uint32_t, CaseFile> by_number;
    for (const CaseFile& file : find_cases(paths).cases) {
      std::uint32_t number = 0x811c9dc5;  // FNV-1a
      for (const char c : file.id) number = (number ^ static_cast<unsigned char>(c)) * 0x01000193;
      by_number.emplace(number, file);
    }
    return by_number;
  }();
  promise(!files.empty(), "there is a suite");
  return files;
}

std::vector<Case> small_cases_of(const CaseFile& file) {
  std::vector<Case> small;
  const auto outline = outline_cases(file.file, file.id);
  if (!outline || !is_small(outline->first.scene)) return small;
  if (outline->names.size() > 4096) return {outline->first};
  std::vector<Case> all = load_cases(file.file, file.id).cases;
  const std::size_t step = std::max<std::size_t>(1, all.size() / kMostOfFile);
  for (std::size_t i = 0; i < all.size(); i += step)
    if (is_small(all[i].scene)) small.push_back(std::move(all[i]));
  return small;
}

const Case* case_of_suite(ByteChoices& choices) {
  static std::map<std::uint32_t, std::vector<Case>> known;
  const auto number = static_cast<std::uint32_t>(choices.below(std::size_t{1} << 16) << 16);
  auto file = suite_files().lower_bound(number);
  if (file == suite_files().end()) file = suite_files().begin();
  auto found = known.find(file->first);
  if (found == known.end()) {
    if (known.size() == 256) known.clear();
    found = known.emplace(file->first, small_cases_of(file->second)).first;
  }
  const std::vector<Case>& cases = found->second;
  const std::size_t of_file = choices.below(256);
  return cases.empty() ? nullptr : &cases[of_file % cases.size()];
}

Scene generated_scene(std::size_t kind, std::uint64_t seed, std::uint64_t index) {
  static const SamplePositions four{{Fixed::from_raw(24576), Fixed::from_raw(8192)},
                                    {Fixed::from_raw(57344), Fixed::from_raw(24576)},
                                    {Fixed::from_raw(8192), Fixed::from_raw(40960)},
                                    {Fixed::from_raw(40960), Fixed::from_raw(57344)}};
  if (kind < 3) return random_scene({seed, values_of<PrimitiveKind>()[kind], Surface::fbo}, index);
  if (kind < 7) return random_output_scene({seed, values_of<OutputKind>()[kind - 3]}, index);
  switch (kind) {
    case 7:
      return random_wide_line(seed, Surface::window, index);
    case 8:
      return shared_edge_scene(seed, Surface::fbo, index);
    case 9:
      return random_joint_scene(seed, Surface::fbo, index);
    case 10:
      return random_fan_scene(seed, Surface::window, index);
    case 11:
      return random_snap_scene(seed, Surface::fbo, index);
    default:
      return random_multisampled_scene(seed, MultisampledKind::triangle, four, index);
  }
}

const Case* generated_case(ByteChoices& choices) {
  static Case generated;
  const std::size_t kind = choices.below(13);
  const std::uint64_t seed = choices.byte();
  generated = {};
  generated.id = "generated";
  for (std::uint64_t index = 0; index < 16; ++index) {
    generated.scene = generated_scene(kind, seed, index);
    if (is_small(generated.scene)) return &generated;
  }
  return nullptr;
}

// ---------------------------------------------------------------------------------------- policies

// OpenGL's own, or one with a few other choices.
Policy policy_of(ByteChoices& choices) {
  static const std::vector<KnownRule> rules = [] {
    std::vector<KnownRule> with_choice = known_rules();
    std::erase_if(with_choice, [](const KnownRule& rule) { return rule.alternatives.empty(); });
    return with_choice;
  }();
  Policy policy;
  const std::size_t count = choices.below(8);
  for (std::size_t i = 4; i < count; ++i) {
    const KnownRule& rule = choices.one_of(rules);
    policy.rules[rule.id] = choices.one_of(rule.alternatives);
  }
  if (count > 3 && choices.below(8) == 7) policy.latitude = Latitude::none;
  return policy;
}

// ----------------------------------------------------------------------------------------- answers

// Of the scene: what is wrong with it is found at once, and is no matter of comparing.
constexpr const char* kDigest = "0123456789abcdef";

// What a renderer claims of itself, all of which its answers may spoil.
RendererInfo usual_claims() {
  RendererInfo claims;
  claims.vendor = "vendor";
  claims.version = "4.6";
  claims.device = "device";
  claims.subpixel_bits = 8;
  claims.traits = {{"api", "OpenGL"},
                   {"max_texture_lod_bias", "16"},
                   {"point_size_steps", "1 to 64 by 0.125"},
                   {"sampled_line_width_steps", "1 to 16 by 0.125"}};
  return claims;
}

// Through bytes as between workers and the program, of which some are spoilt.
std::variant<Answer, WireError> through_message(const Answer& answer, const Scene& scene,
                                                ByteChoices& choices, std::size_t& spoils) {
  constexpr std::uint64_t kOfRequest = 62;
  const RendererInfo* claims = answer.claims ? &*answer.claims : nullptr;
  std::string message = answer_message(kOfRequest, answer.outcome, false, claims);
  const auto whole = parse_answer_message(message, kOfRequest, scene, false);
  promise(std::holds_alternative<Answer>(whole), "what is read as a line is read as a message");
  for (std::size_t left = choices.below(4); left > 0; --left, ++spoils) {
    const std::size_t at = choices.below(message.size());
    message[at] = static_cast<char>(choices.byte());
  }
  return parse_answer_message(message, kOfRequest, scene, false);
}

std::variant<Answer, WireError> through_recording(const Answer& answer, const Scene& scene) {
  const Outcome outcome = recording::outcome_of(recording::stored_line(answer.outcome), scene);
  promise(outcome.index() == answer.outcome.index(), "what is read is read again when recorded");
  return Answer{outcome, answer.claims};
}

// The answer as the program has it after reading; nothing where it is refused. `spoils`: in how
// many places it is spoilt, which may be more on the way.
std::optional<Answer> read(const json& spoilt, const Scene& scene, ByteChoices& choices,
                           std::size_t& spoils) {
  auto parsed = parse_answer(spoilt.dump(), kDigest, scene);
  if (const auto* answer = std::get_if<Answer>(&parsed)) {
    const std::size_t way = choices.below(4);
    if (way == 2) parsed = through_message(Answer(*answer), scene, choices, spoils);
    if (way == 3) parsed = through_recording(Answer(*answer), scene);
  }
  if (const auto* error = std::get_if<WireError>(&parsed)) {
    promise(!error->message.empty(), "a refusal has a reason");
    promise(spoils > 0, "an answer that is not spoilt is read");
    return std::nullopt;
  }
  return std::get<Answer>(std::move(parsed));
}

// ----------------------------------------------------------------------------------------- results

CaseResults results_of(const Case& one, const ExactSide& exact, Result result) {
  CaseResults results;
  results.id = one.id;
  results.file = "cases/one.json";
  results.surface = name_of(one.scene.target.surface);
  results.width = one.scene.target.width;
  results.height = one.scene.target.height;
  results.pixels = exact.pixels;
  results.samples = exact.samples;
  results.fragments = exact.rendering.fragments.size();
  results.figure = scene_figure(one.scene);
  results.results.push_back(std::move(result));
  return results;
}

void write_and_read(const Results& results) {
  std::ostringstream first;
  write_results(results, first);
  const auto again = read_results(first.str());
  promise(std::holds_alternative<Results>(again), "results that are written are read");
  std::ostringstream second;
  write_results(std::get<Results>(again), second);
  promise(first.str() == second.str(), "as the same");
}

void check_counts(const Rendering& rendering, const Result& result) {
  const PixelCounts& counts = result.pixel_counts;
  const std::size_t pixels = rendering.pixels.size() / 4;
  promise(counts[Verdict::agree] <= pixels && counts.same <= pixels,
          "no more pixels agree than there are");
  promise(counts.all() == pixels, "each pixel counts once");
}

// What is shown must be exact's where nothing differs. Asked for by a variable of the environment,
// EDGECASE_FUZZ_AGREEMENT; of OpenGL's own policy alone, since others may choose values that differ
// by less than a float32 tells.
void check_agreement(const Rendering& exact, const Rendering& rendered) {
  static const bool is_asked = std::getenv("EDGECASE_FUZZ_AGREEMENT") != nullptr;
  if (!is_asked) return;
  const auto is_exact = [](const auto& reported, const auto& wanted) {
    return reported.empty() || reported == wanted;
  };
  promise(rendered.pixels == exact.pixels, "an answer that agrees has exact's pixels");
  promise(is_exact(rendered.sample_pixels, exact.sample_pixels), "and exact's samples");
  promise(is_exact(rendered.depths, exact.depths), "and exact's depths");
  promise(is_exact(rendered.stencils, exact.stencils), "and exact's stencils");
}

void compare_and_judge(const Case& one, const Policy& policy, const Answer& answer,
                       bool must_not_be_blamed) {
  const auto* rendering = std::get_if<Rendering>(&answer.outcome);
  if (rendering == nullptr) return;
  RunOptions options;
  options.policy = policy;
  CaseComparison comparison(1, options);
  RendererInfo info = answer.claims.value_or(RendererInfo{});
  info.name = "exec:liar";
  Result result = comparison.compare_outcome(0, one, answer.outcome, info);
  promise(!result.failure, "comparing does not fail");

  Results results;
  results.tool = "edgecase";
  results.policy = policy.name;
  results.latitude = policy.latitude;
  results.renderers = {info};
  results.cases.push_back(results_of(one, comparison.exact(0, one.scene), std::move(result)));
  judge_all(results);
  write_and_read(results);

  const CaseResults judged = results.cases[0];
  const Verdict verdict = judged.results[0].verdict;
  check_counts(*rendering, judged.results[0]);
  if (must_not_be_blamed) promise(verdict < Verdict::contested, "a right answer is not blamed");
  if (verdict == Verdict::agree && policy.rules.empty())
    check_agreement(rasterize_for_comparison(one.scene, policy, rendering->sample_positions),
                    *rendering);
}

// What the input stands for, where EDGECASE_FUZZ_SHOW is set: to see what a find is about.
void show(const Case& one, const Policy& drawn, const Policy& judged, const json& answer) {
  static const bool is_asked = std::getenv("EDGECASE_FUZZ_SHOW") != nullptr;
  if (!is_asked) return;
  fmt::print(stderr, "case {}\nscene {}\n", one.id, scene_json(one.scene));
  for (const Policy* policy : {&drawn, &judged})
    fmt::print(stderr, "{} by {}\n", policy == &drawn ? "drawn" : "judged",
               fmt::join(policy->rules, ", "));
  fmt::print(stderr, "answer {}\n", answer.dump());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteChoices choices({data, size});
  const Case* found = choices.below(8) == 7 ? generated_case(choices) : case_of_suite(choices);
  if (found == nullptr) return 0;
  Case one = *found;
  if (choices.below(8) == 7) one.tags.emplace_back(kRampTag);
  const Policy drawn = policy_of(choices);
  const Policy judged = policy_of(choices);
  const RendererInfo claims = usual_claims();
  json answer = json::parse(answer_line(kDigest, rasterize(one.scene, drawn), &claims));
  tell_less(answer, choices);
  answer.erase("digest");
  std::size_t spoils = choices.below(5);
  for (std::size_t i = 0; i < spoils; ++i) spoil(answer, choices);
  answer["digest"] = kDigest;
  show(one, drawn, judged, answer);
  const auto reported = read(answer, one.scene, choices, spoils);
  const bool is_right = spoils == 0 && drawn.rules.empty() && judged.rules.empty() &&
                        judged.latitude == Latitude::opengl;
  if (reported) compare_and_judge(one, judged, *reported, is_right);
  return 0;
}
