// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "base/threads.h"
#include "diff/compare.h"
#include "model/side_clipping.h"
#include "profile/profile.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostRounds = 8;

std::size_t speaking_for_best(const RuleAnswers& answers) {
  return answers.asked - *std::ranges::min_element(answers.against);
}

// The best alternative: `current` if none is better; of several, a grid of the reported bits.
std::string best_of(const RuleAnswers& answers, const std::string& current, int subpixel_bits) {
  const auto& alternatives = rule_of(answers.rule).alternatives;
  const std::size_t best = speaking_for_best(answers);
  std::optional<std::string> first;
  std::optional<std::string> reported;
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const std::string& name = alternatives[i].name;
    if (answers.speaking_for(i) != best) continue;
    if (name == current) return current;
    if (!first) first = name;
    const Snap* const grid = find_snap(name);
    if (!reported && grid != nullptr && grid->bits == subpixel_bits) reported = name;
  }
  return reported ? *reported : *first;
}

std::string chosen_of(const Choices& choices, RuleId rule) {
  const auto found = choices.find(name_of(rule));
  return found == choices.end() ? "" : found->second;
}

// Whether nothing differs from a policy beyond what inexact arithmetic explains.
bool is_as_told(const Result& result) {
  return count_disagreements(result) == 0 &&
         std::ranges::all_of(result.values, [](const ValueAggregate& values) {
           return values.cause.empty() || values.differing.empty();
         });
}

// How far a rendering is from a policy in what one rule is about, in bits: of the values that are
// permitted, those of their errors in units of the last place; of each other difference as many as
// a number has.
using Distances = std::map<RuleId, std::size_t>;

Distances distances_of(const Result& result) {
  constexpr std::size_t kOfDifference = 32;
  Distances bits;
  for (const Disagreement& one : result.disagreements) bits[one.rule] += kOfDifference;
  for (const CountedDisagreements& many : result.counted)
    bits[many.rule] += kOfDifference * many.count();
  for (const ValueAggregate& values : result.values)
    for (const auto& [exponent, count] : values.ulp_histogram)
      bits[values.rule] += static_cast<std::size_t>(std::max(exponent + 2, 1)) * count;
  return bits;
}

// The rules besides those of coverage that a case names.
std::vector<RuleId> rules_asked_by(const Case& one) {
  std::vector<RuleId> rules;
  for (const std::string& name : one.rules) {
    RuleId id = RuleId::none;
    if (parse_name(name, id) && rule_of(id).alternatives.size() > 1 &&
        rule_of(id).say.in_coverage == nullptr)
      rules.push_back(id);
  }
  return rules;
}

// Compares one rendering under a policy and under what deviates from it.
class Question {
 public:
  Question(const Case& one, const Rendering& rendering, const Policy& policy,
           const RendererInfo& info)
      : rendering_(rendering),
        policy_(policy),
        facts_(facts_of(info, nullptr)),
        asked_(one.scene, facts_.lookups.is_es) {}

  // False if the API of the renderer has the scene in places that are not exact.
  bool is_exact() const { return asked_.is_exact(); }

  Result under(const Policy& policy) const {
    const ResolvedPolicy resolved(policy);
    const Scene& scene = asked_.scene();
    const Rendering exact = rasterize_for_comparison(scene, resolved, rendering_.sample_positions);
    return compare(scene, resolved, exact, rendering_, facts_);
  }

  // Adds the alternatives of a rule that the rendering contradicts: those more than twice as far
  // from it as the nearest, in what the rule changes. Where the farthest is not four times as far
  // as that, arithmetic or another fault hides what is followed.
  void ask(RuleId rule, AlternativeSet& against) const {
    const std::vector<Distances> distances = distances_under_each(rule);
    std::vector<std::size_t> bits(distances.size());
    for (const RuleId subject : values_of<RuleId>()) {
      std::vector<std::size_t> own;
      for (const Distances& one : distances)
        own.push_back(one.contains(subject) ? one.at(subject) : 0);
      if (std::ranges::count(own, own.front()) == std::ssize(own)) continue;
      std::ranges::transform(bits, own, bits.begin(), std::plus());
    }
    const auto [least, most] = std::ranges::minmax(bits);
    if (most < 4 * least || most == 0) return;
    for (std::size_t i = 0; i < bits.size(); ++i)
      if (bits[i] > 2 * least) against.add({rule, static_cast<std::uint8_t>(i)});
  }

 private:
  std::vector<Distances> distances_under_each(RuleId rule) const {
    std::vector<Distances> distances;
    for (const Alternative& alternative : rule_of(rule).alternatives) {
      Policy policy = policy_;
      policy.rules[name_of(rule)] = alternative.name;
      distances.push_back(distances_of(under(policy)));
    }
    return distances;
  }

  const Rendering& rendering_;
  const Policy& policy_;
  const RendererFacts facts_;
  const SceneOfApi asked_;
};

// "textures/bias" of "textures/bias/sum:s=2".
std::string folder_of(const std::string& id) {
  const std::string file = id.substr(0, id.find(':'));
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "" : file.substr(0, slash);
}

// Of a primitive that no alternative draws by itself, all of the rules of coverage that it is asked
// about.
void add_unexplained(const Case& one, const Result& result, AlternativeSet& against) {
  const auto primitives = primitives_of(one.scene);
  for (const Result::Evidence& evidence : result.evidence) {
    if (evidence.primitive < 0 ||
        std::ranges::any_of(evidence.causes, [](const Cause& cause) { return cause.size() == 1; }))
      continue;
    const CoverageTraits traits =
        coverage_traits(primitives[static_cast<std::size_t>(evidence.primitive)], one.scene.target);
    for (const RuleId rule : coverage_rules()) {
      if (!rule_of(rule).say.in_coverage(traits) ||
          std::ranges::find(one.rules, name_of(rule)) == one.rules.end())
        continue;
      for (std::size_t i = 0; i < rule_of(rule).alternatives.size(); ++i)
        against.add({rule, static_cast<std::uint8_t>(i)});
    }
  }
}

// What the answers of a round say on one surface.
struct Gathered {
  RendererInfo renderer;  // of an answer
  std::size_t cases = 0;
  std::size_t drawn = 0;
  std::size_t as_told = 0;
  std::pair<std::string, std::string> first_refusal;  // the id of the case, and why
  RuleAnswersGatherer rules;
  std::map<std::string, RuleAnswersGatherer> by_folder;
  std::map<Cause, std::size_t> together;  // in how many drawings alternatives draw only together

  void note(const std::string& id, const Outcome& outcome,
            const std::optional<Contradiction>& found) {
    ++cases;
    if (const auto* failure = std::get_if<Failure>(&outcome)) {
      if (first_refusal.second.empty() || id < first_refusal.first)
        first_refusal = {id, fmt::format("{}: {}", name_of(failure->kind), failure->reason)};
      return;
    }
    ++drawn;
    if (found->is_as_told) ++as_told;
    rules.add(found->against);
    by_folder[folder_of(id)].add(found->against);
    for (const Cause& cause : found->together) ++together[cause];
  }
};

// The choices that most answers speak for, those before of all other rules.
Choices spoken_for(const Gathered& gathered, const Choices& before) {
  Choices choices = before;
  for (const RuleAnswers& answers : gathered.rules.answers())
    if (speaking_for_best(answers) > 0)
      choices[name_of(answers.rule)] =
          best_of(answers, chosen_of(before, answers.rule), gathered.renderer.subpixel_bits);
  return choices;
}

// The choices with the alternatives that most drawings follow together, and none by itself.
Choices followed_together(const Gathered& gathered, const Choices& before) {
  Choices choices = before;
  const auto most = std::ranges::max_element(gathered.together, {},
                                             [](const auto& counted) { return counted.second; });
  if (most == gathered.together.end()) return choices;
  for (const AlternativeId& part : most->first.parts)
    choices[name_of(part.rule)] = rule_of(part.rule).alternatives[part.index].name;
  return choices;
}

using Renderers = std::vector<std::unique_ptr<Renderer>>;

// Draws and asks all cases again in each round.
class Rounds {
 public:
  // What is given must outlive this.
  Rounds(const CaseStore& cases, const Renderers& renderers, const MeasureOptions& options)
      : cases_(cases),
        renderers_(renderers),
        options_(options),
        slices_(cut_cases(cases, {kSliceWeight})) {}

  Gathered ask(const Policy& policy) {
    Gathered gathered;
    next_ = done_ = 0;
    run_threads(std::min(renderers_.size(), slices_.size()), [&](std::size_t thread) {
      for (std::size_t i = next_++; i < slices_.size(); i = next_++)
        ask(slices_[i], *renderers_[thread], policy, gathered);
    });
    return gathered;
  }

 private:
  static constexpr std::size_t kSliceWeight = 100'000;

  void ask(const CaseSlice& slice, Renderer& renderer, const Policy& policy, Gathered& gathered) {
    std::vector<Case> cases;
    for (std::size_t i = slice.begin; i < slice.end; ++i) cases.push_back(cases_[i]);
    std::vector<Task> tasks;
    for (const Case& one : cases) tasks.push_back({one.id, &one.scene});
    renderer.render(tasks, [&](std::size_t index, const Outcome& outcome) {
      if (options_.stop != nullptr && options_.stop->load()) throw MeasurementStopped{};
      std::optional<Contradiction> found;
      if (const auto* rendering = std::get_if<Rendering>(&outcome))
        found = contradiction_of(cases[index], *rendering, policy, renderer.info());
      const std::lock_guard lock(mutex_);
      if (gathered.cases == 0) gathered.renderer = renderer.info();
      gathered.note(cases[index].id, outcome, found);
      if (options_.progress) options_.progress(++done_, cases_.size());
    });
  }

  const CaseStore& cases_;
  const Renderers& renderers_;
  const MeasureOptions& options_;
  const std::vector<CaseSlice> slices_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

SurfaceProfile profile_of(Surface surface, const Gathered& gathered) {
  SurfaceProfile profile{surface,
                         gathered.cases,
                         gathered.drawn,
                         gathered.as_told,
                         gathered.first_refusal.second,
                         gathered.rules.answers(),
                         {}};
  for (const auto& [folder, rules] : gathered.by_folder)
    if (auto answers = rules.answers(); !answers.empty())
      profile.by_folder.emplace(folder, std::move(answers));
  return profile;
}

// What is known of a surface; `last`: the choices of the last round.
Choices known_of(const SurfaceProfile& surface, const Choices& last, int subpixel_bits) {
  Choices choices;
  for (const RuleAnswers& answers : surface.rules)
    if (remaining_of(answers) != kNoneKnown)
      choices[name_of(answers.rule)] =
          best_of(answers, chosen_of(last, answers.rule), subpixel_bits);
  return choices;
}

// The choices of the first surface apply to all; others list their deviations.
void add_choices(Surface surface, Choices choices, Policy& policy) {
  if (policy.rules.empty()) {
    policy.rules = std::move(choices);
    return;
  }
  std::erase_if(choices, [&](const auto& choice) {
    const auto first = policy.rules.find(choice.first);
    return first != policy.rules.end() && first->second == choice.second;
  });
  if (!choices.empty()) policy.surfaces[surface] = std::move(choices);
}

}  // namespace

Contradiction contradiction_of(const Case& one, const Rendering& rendering, const Policy& policy,
                               const RendererInfo& info) {
  const Question question(one, rendering, policy, info);
  Contradiction found;
  if (!question.is_exact()) return found;
  const Result result = question.under(policy);
  found.is_as_told = is_as_told(result);
  contradicted_by(result).for_each([&](AlternativeId id) {
    if (rule_of(id.rule).say.in_coverage != nullptr) found.against.add(id);
  });
  for (const Result::Evidence& evidence : result.evidence)
    for (const Cause& cause : evidence.causes)
      if (cause.size() > 1) found.together.insert(cause);
  add_unexplained(one, result, found.against);
  for (const RuleId rule : rules_asked_by(one)) question.ask(rule, found.against);
  return found;
}

CaseStore cases_that_tell(const CaseStore& all, std::size_t of_each_rule) {
  constexpr std::size_t kHeavy = 3'000;  // CaseStore::weight
  std::map<std::pair<std::string, Surface>, std::vector<std::size_t>> naming;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.weight(i) > kHeavy) continue;
    const Case one = all[i];
    for (const std::string& rule : one.rules) naming[{rule, one.scene.target.surface}].push_back(i);
  }
  std::set<std::size_t> chosen;
  for (const auto& [rule, indices] : naming) {
    const std::size_t count = std::min(of_each_rule, indices.size());
    for (std::size_t i = 0; i < count; ++i) chosen.insert(indices[i * indices.size() / count]);
  }
  CaseStore cases;
  for (const std::size_t index : chosen) cases.push_back(all[index]);
  return cases;
}

Profile measure(const CaseStore& cases, const MakeRenderer& make_renderer,
                const MeasureOptions& options) {
  Renderers renderers;
  for (int i = 0; i < std::max(options.jobs, 1); ++i) renderers.push_back(make_renderer());
  std::map<Surface, CaseStore> on;
  for (const Case& one : cases) on[one.scene.target.surface].push_back(one);

  Profile profile;
  profile.policy.name = options.name;
  Policy policy;  // of one round; another surface begins where the one before ended
  for (const auto& [surface, own] : on) {
    Rounds rounds(own, renderers, options);
    Gathered gathered = rounds.ask(policy);
    std::size_t asked = 1;
    while (asked < kMostRounds) {
      Policy next = policy;
      next.rules = spoken_for(gathered, policy.rules);
      const bool is_spoken_for = next.rules != policy.rules;
      if (!is_spoken_for) next.rules = followed_together(gathered, policy.rules);
      if (next.rules == policy.rules) break;
      Gathered then = rounds.ask(next);
      ++asked;
      if (!is_spoken_for && then.as_told <= gathered.as_told) break;
      policy = std::move(next);
      gathered = std::move(then);
    }
    profile.rounds = std::max(profile.rounds, asked);
    if (profile.surfaces.empty()) profile.renderer = gathered.renderer;
    profile.surfaces.push_back(profile_of(surface, gathered));
    add_choices(surface,
                known_of(profile.surfaces.back(), policy.rules, gathered.renderer.subpixel_bits),
                profile.policy);
  }
  profile.renderer.name = options.name;
  return profile;
}

}  // namespace edgecase
