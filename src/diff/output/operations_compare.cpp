// SPDX-License-Identifier: MIT
#include "diff/output/operations_compare.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/output/operations_causes.h"
#include "diff/output/operations_question.h"
#include "diff/output/test_of_one_sample.h"
#include "rules/all_rules.h"
#include "rules/output/fragment_tests.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// What a renderer reports about one of its samples.
StoredSample stored_at(const Rendering& rendered, PixelPosition pixel, int sample) {
  const std::size_t index = rendered.sample_index(pixel.x, pixel.y, sample);
  const std::vector<std::uint8_t>& colors =
      rendered.samples > 1 ? rendered.sample_pixels : rendered.pixels;
  StoredSample stored;
  if (!colors.empty()) stored.color = colors.data() + 4 * index;
  if (!rendered.depths.empty()) stored.depth = rendered.depths[index];
  if (!rendered.stencils.empty()) stored.stencil = rendered.stencils[index];
  if (!rendered.hits.empty()) stored.hits = rendered.hits[index];
  return stored;
}

// Calls `visit` with the question of every sample, sorted by row, column and sample.
template <class Visit>
void for_each_sample(const ValueContext& context, const Arrivals& arrivals,
                     const Rendering& rendered, const Visit& visit) {
  // Fragments are sorted by row, column and primitive, so they are read along with the pixels.
  auto next = rendered.fragments.begin();
  for (int y = 0; y < rendered.height; ++y) {
    Patience::check();
    for (int x = 0; x < rendered.width; ++x) {
      const auto first = next;
      while (next != rendered.fragments.end() && next->x == x && next->y == y) ++next;
      for (int sample = 0; sample < rendered.samples; ++sample)
        visit(OperationsQuestion(context, arrivals, {first, next}, {x, y}, sample,
                                 stored_at(rendered, {x, y}, sample)));
    }
  }
}

class OperationsComparison {
 public:
  OperationsComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context),
        rendered_(rendered),
        arrivals_(context),
        chosen_(context.choices),
        is_standard_(is_standard(chosen_)),
        aggregates_(context.scene, chosen_),
        causes_(context.scene, chosen_),
        excused_causes_(context.scene, standard_choices()) {}

  void run(Result& result) {
    for_each_sample(context_, arrivals_, rendered_,
                    [&](const OperationsQuestion& question) { compare(question); });
    excuse_tests_of_one();
    aggregates_.flush(result);
    for (const OperationsQuestion& question : missed_) causes_.add(question);
    if (are_unconverted()) {
      report_unconverted(result);
    } else {
      weigh_causes();
      report(missed_, causes_.take(), chosen_, result);
      if (std::vector<Cause> common = causes_.common(); !common.empty())
        result.evidence.push_back({kAllValues, std::move(common), {}, ""});
    }
    report(excused_, excused_causes_.take(), standard_choices(), result);
  }

 private:
  void compare(const OperationsQuestion& question) {
    aggregates_.count(question.stored);
    const ExactSample exact = question.exact(chosen_);
    const bool agrees = is_exact(exact, question.stored);
    if (agrees && (is_standard_ || context_.latitude == Latitude::none)) return;
    const OperationsReason reason = reason_for(question);
    if (reason != OperationsReason::none) {
      if (!agrees) aggregates_.add(question, reason, exact);
      return;
    }
    (agrees ? excused_ : missed_).push_back(question);
    if (agrees) excused_causes_.add(question);
  }

  // Calls `visit` with the questions of each pixel, by row and column.
  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    std::vector<OperationsQuestion> pixel;
    for_each_sample(context_, arrivals_, rendered_, [&](const OperationsQuestion& question) {
      pixel.push_back(question);
      if (pixel.size() < static_cast<std::size_t>(rendered_.samples)) return;
      visit(pixel);
      pixel.clear();
    });
  }

  // The missed pixels that tests of one sample for all account for; nothing if some other pixel
  // shows that this sample is not the one that is tested.
  std::optional<std::vector<PixelPosition>> pixels_by_test_of(int tested) const {
    std::vector<PixelPosition> pixels;
    bool is_refuted = false;
    auto missed = missed_.begin();
    for_each_pixel([&](const std::vector<OperationsQuestion>& pixel) {
      const PixelPosition at = pixel.front().pixel;
      const bool is_missed = missed != missed_.end() && missed->pixel == at;
      while (missed != missed_.end() && missed->pixel == at) ++missed;
      if (is_refuted || !may_test_one_sample(pixel)) return;
      const bool agrees = agrees_by_test_of(pixel, tested);
      if (agrees && is_missed) pixels.push_back(at);
      is_refuted = !agrees && !is_missed;
    });
    return is_refuted ? std::nullopt : std::optional(std::move(pixels));
  }

  // Ruling 35: samples that one sample's tests account for, the same one in the whole case, are
  // permitted.
  void excuse_tests_of_one() {
    if (missed_.empty() || rendered_.samples == 1) return;
    std::vector<PixelPosition> most;
    for (int tested = 0; tested < rendered_.samples; ++tested) {
      const auto pixels = pixels_by_test_of(tested);
      if (pixels && pixels->size() > most.size()) most = *pixels;
    }
    std::vector<OperationsQuestion> left;
    for (const OperationsQuestion& question : missed_) {
      if (std::ranges::find(most, question.pixel) == most.end())
        left.push_back(question);
      else
        aggregates_.add(question, OperationsReason::test_of_one, question.exact(chosen_));
    }
    missed_.swap(left);
  }

  // True if comparing depths before their conversion accounts for all samples (ruling 55).
  bool are_unconverted() const {
    if (missed_.empty() || bits_of(context_.scene.target.depth) == 0) return false;
    RuleChoices unconverted;
    unconverted.output.depth = DepthTestMethod::unconverted;
    const auto agrees = [&](const OperationsQuestion& question) {
      return question.agrees(unconverted, kAllPermitted);
    };
    if (!std::ranges::all_of(missed_, agrees)) return false;
    bool all = true;
    for_each_sample(context_, arrivals_, rendered_,
                    [&](const OperationsQuestion& question) { all = all && agrees(question); });
    return all;
  }

  void report_unconverted(Result& result) const {
    for (const OperationsQuestion& question : missed_) {
      Disagreement d = disagreement(
          question, alternative_id(RuleId::depth_test, name_of(DepthTestMethod::unconverted)),
          chosen_);
      d.ruling = kRulingOnUnconvertedDepth;
      add_disagreement(result, std::move(d));
    }
  }

  // Weighs causes by a limited number of samples that agree.
  void weigh_causes() {
    constexpr std::size_t kMostWeighed = 4096;
    if (!causes_.is_ambiguous()) return;
    auto missed = missed_.begin();
    std::size_t weighed = 0;
    for_each_sample(context_, arrivals_, rendered_, [&](const OperationsQuestion& question) {
      if (missed != missed_.end() && missed->pixel == question.pixel &&
          missed->sample == question.sample) {
        ++missed;
      } else if (!question.fragments().empty() && weighed < kMostWeighed) {
        ++weighed;
        causes_.weigh(question);
      }
    });
  }

  // Samples that agree with the policy and break the specification are compared with the latter.
  void report(const std::vector<OperationsQuestion>& questions, const std::vector<Cause>& causes,
              const RuleChoices& choice, Result& result) const {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      Disagreement d = disagreement(questions[i], causes[i], choice);
      contest(questions[i], d);
      d.policy_agrees = &questions == &excused_;
      if (d.policy_agrees) d.explanation += ". The policy has it as the renderer does";
      add_disagreement(result, std::move(d));
    }
  }

  // A fault with a named cause is not a matter of precision.
  static void contest(const OperationsQuestion& question, Disagreement& d) {
    if (!d.cause.empty() && d.cause.rule() != RuleId::blend_rounding) return;
    const int ruling = contested_ruling(question);
    if (ruling == 0) return;
    d.ruling = ruling;
    d.rule = ruling == kRulingOnDepthCodes ? RuleId::framebuffer_depth : RuleId::blend_rounding;
  }

  static Disagreement disagreement(const OperationsQuestion& question, const Cause& cause,
                                   const RuleChoices& choice) {
    const RuleId named = cause.rule();
    // Consequences of an ignored switch are reported with it, under the rule that they break.
    const RuleId rule =
        named == RuleId::none || named == RuleId::sample_enable ? broken_rule(question) : named;
    Disagreement d = value_disagreement(question.pixel, -1, rule);
    d.sample = question.sample;
    d.cause = cause;
    d.explanation = explain_operations(question, choice);
    set_values(question.exact(choice), question.stored, d);
    return d;
  }

  // Sets the values of the first plane that differs.
  static void set_values(const ExactSample& exact, const StoredSample& stored, Disagreement& d) {
    if (!has_color(exact, stored)) {
      d.exact.assign(exact.color.begin(), exact.color.end());
      d.rendered.assign(stored.color, stored.color + 4);
    } else if (stored.depth && *stored.depth != exact.depth) {
      d.exact = {exact.depth};
      d.rendered = {*stored.depth};
    } else if (stored.stencil && *stored.stencil != exact.stencil) {
      d.exact = {static_cast<double>(exact.stencil)};
      d.rendered = {static_cast<double>(*stored.stencil)};
    } else if (stored.hits) {
      d.exact = {static_cast<double>(exact.hits)};
      d.rendered = {static_cast<double>(*stored.hits)};
    }
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const Arrivals arrivals_;
  const RuleChoices& chosen_;
  const bool is_standard_;
  OperationsAggregates aggregates_;
  OperationsCauses causes_;
  OperationsCauses excused_causes_;
  std::vector<OperationsQuestion> missed_;
  std::vector<OperationsQuestion> excused_;
};

}  // namespace

void compare_operations(const ValueContext& context, const Rendering& rendered, Result& result) {
  OperationsComparison(context, rendered).run(result);
}

SamplePlanes samples_by_operations(const ValueContext& context, const Rendering& rendered,
                                   AlphaEnds ends) {
  const std::size_t size = rendered.pixels.size() * static_cast<std::size_t>(rendered.samples);
  SamplePlanes planes{std::vector<std::uint8_t>(size, 255), std::vector<std::uint8_t>(size),
                      std::vector<std::uint8_t>(size)};
  const Arrivals arrivals(context);
  const RuleChoices& chosen = context.choices;
  OperationsFreedom freedom = kAllPermitted;
  if (ends == AlphaEnds::open) freedom.alpha = OutcomeScope::any;
  for_each_sample(context, arrivals, rendered, [&](const OperationsQuestion& question) {
    std::vector<PermittedSample> states = question.states({}, freedom);
    const auto is_left = [&](const PermittedSample& state) {
      return agrees(state, question.stored, question.target().depth);
    };
    // Other reported planes narrow the states down.
    if (std::ranges::any_of(states, is_left)) std::erase_if(states, std::not_fn(is_left));
    const Rgba8 nearest = question.exact(chosen).color;
    const std::size_t index =
        4 * rendered.sample_index(question.pixel.x, question.pixel.y, question.sample);
    for (std::size_t c = 0; c < 4; ++c) {
      planes.nearest[index + c] = nearest[c];
      for (const PermittedSample& state : states) {
        const auto [low, high] = state.color.permitted[c];
        planes.low[index + c] =
            static_cast<std::uint8_t>(std::min<int>(planes.low[index + c], low));
        planes.high[index + c] =
            static_cast<std::uint8_t>(std::max<int>(planes.high[index + c], high));
      }
    }
  });
  return planes;
}

}  // namespace edgecase
