// SPDX-License-Identifier: MIT
#include "diff/output/operations_question.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "rules/output/blending.h"
#include "rules/values/framebuffer.h"

namespace edgecase {

ExactSample OperationsQuestion::exact(const RuleChoices& choice) const {
  ExactSample held = cleared_sample<ExactNumbers>(target());
  for (const Arrival& arrival : arrivals(choice, Tracked::exact))
    arrive(arrival, {target(), choice.output}, held);
  return held;
}

std::vector<PermittedSample> OperationsQuestion::states(const RuleChoices& choice,
                                                        OperationsFreedom freedom) const {
  return replayed(arrivals(choice), {target(), choice.output, freedom});
}

bool OperationsQuestion::agrees(const RuleChoices& choice, OperationsFreedom freedom,
                                ComparedPlanes planes) const {
  return any_agrees(states(choice, freedom), stored, target().depth, planes);
}

bool OperationsQuestion::yields(const RuleChoices& choice) const {
  OperationsFreedom freedom = kAllPermitted;
  if (choice.samples.alpha_to_coverage != SampleChoice{}.alpha_to_coverage)
    freedom.alpha = OutcomeScope::exact;
  if (choice.triangles.facing != FacingMethod::as_set) freedom.facing = OutcomeScope::exact;
  return agrees(choice, freedom);
}

OperationsReason reason_for(const OperationsQuestion& question) {
  const RuleChoices& lawful = standard_choices();
  OperationsFreedom freedom;
  if (question.agrees(lawful, freedom)) return OperationsReason::conversion;
  freedom.depth_test = OutcomeScope::permitted;
  if (question.agrees(lawful, freedom)) return OperationsReason::depth_test;
  freedom.facing = OutcomeScope::permitted;
  if (question.agrees(lawful, freedom)) return OperationsReason::facing;
  freedom.alpha = OutcomeScope::permitted;
  return question.agrees(lawful, freedom) ? OperationsReason::alpha : OperationsReason::none;
}

namespace {

// The tests and stages that can decide the outcome of the arrivals.
struct Stages {
  bool depth_test = false;
  bool stencil_test = false;
  bool alpha = false;
};

Stages stages_of(std::span<const Arrival> arrivals, const Target& target) {
  Stages stages;
  for (const Arrival& arrival : arrivals) {
    const FragmentOperations& operations = *arrival.operations;
    if (target.depth != DepthFormat::none && operations.depth.function != CompareFunction::always)
      stages.depth_test = true;
    if (target.stencil != StencilFormat::none && operations.stencil) stages.stencil_test = true;
    if (arrival.may_be_dropped || !arrival.is_kept) stages.alpha = true;
  }
  return stages;
}

// True if the same fragments in reverse order, or with two neighbours exchanged, yield what is
// stored.
bool agrees_in_another_order(const OperationsQuestion& question) {
  const RuleChoices& lawful = standard_choices();
  const OutputRules rules{question.target(), lawful.output, kAllPermitted};
  std::vector<Arrival> arrivals = question.arrivals(lawful);
  const auto agree = [&] {
    return any_agrees(replayed(arrivals, rules), question.stored, question.target().depth);
  };
  for (std::size_t i = 0; i + 1 < arrivals.size(); ++i) {
    std::swap(arrivals[i], arrivals[i + 1]);
    if (agree()) return true;
    std::swap(arrivals[i], arrivals[i + 1]);
  }
  std::ranges::reverse(arrivals);
  return arrivals.size() > 2 && agree();
}

// True if the draws' masks with their components in another order yield what is stored.
bool agrees_with_masks_in_another_order(const OperationsQuestion& question) {
  const RuleChoices& lawful = standard_choices();
  const OutputRules rules{question.target(), lawful.output, kAllPermitted};
  std::vector<Arrival> arrivals = question.arrivals(lawful);
  std::vector<FragmentOperations> operations;
  for (const Arrival& arrival : arrivals) operations.push_back(*arrival.operations);
  for (std::size_t i = 0; i < arrivals.size(); ++i) arrivals[i].operations = &operations[i];
  const std::vector<FragmentOperations> given = operations;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end())) {
    for (std::size_t i = 0; i < given.size(); ++i)
      for (std::size_t c = 0; c < 4; ++c)
        operations[i].color_mask[c] = given[i].color_mask[order[c]];
    if (any_agrees(replayed(arrivals, rules), question.stored, question.target().depth))
      return true;
  }
  return false;
}

RuleId broken_color_rule(const OperationsQuestion& question) {
  RuleChoices unmasked;
  unmasked.output.blend.mask = ColorMaskMethod::ignored;
  if (question.agrees(unmasked, kAllPermitted)) return RuleId::color_mask;
  if (agrees_with_masks_in_another_order(question)) return RuleId::color_mask;
  return question.exact({}).blended ? RuleId::blend_equation : RuleId::framebuffer_unorm8;
}

// The rule of the first stage in doubt, if no single plane is to blame.
RuleId first_stage(const Stages& stages, const OperationsQuestion& question) {
  if (stages.depth_test) return RuleId::depth_test;
  if (stages.stencil_test) return RuleId::stencil_test;
  if (stages.alpha) return RuleId::sample_alpha_to_coverage;
  const bool hits_alone = question.agrees({}, kAllPermitted, {true, true, true, false});
  return hits_alone ? RuleId::fragment_once : broken_color_rule(question);
}

}  // namespace

RuleId broken_rule(const OperationsQuestion& question) {
  const RuleChoices& lawful = standard_choices();
  const Stages stages = stages_of(question.arrivals(lawful), question.target());
  const auto agrees_with = [&](OutcomeScope OperationsFreedom::*step) {
    OperationsFreedom freedom = kAllPermitted;
    freedom.*step = OutcomeScope::any;
    return question.agrees(lawful, freedom);
  };
  if (stages.depth_test && agrees_with(&OperationsFreedom::depth_test)) return RuleId::depth_test;
  if (stages.stencil_test && agrees_with(&OperationsFreedom::stencil_test))
    return RuleId::stencil_test;
  if (stages.alpha && agrees_with(&OperationsFreedom::alpha))
    return RuleId::sample_alpha_to_coverage;
  if (agrees_in_another_order(question)) return RuleId::framebuffer_order;
  const auto agrees_without = [&](bool ComparedPlanes::*plane) {
    ComparedPlanes planes;
    planes.*plane = false;
    return question.agrees(lawful, kAllPermitted, planes);
  };
  if (agrees_without(&ComparedPlanes::color)) return broken_color_rule(question);
  if (agrees_without(&ComparedPlanes::depth)) return RuleId::framebuffer_depth;
  if (agrees_without(&ComparedPlanes::stencil)) return RuleId::stencil_test;
  return first_stage(stages, question);
}

namespace {

// Components that some blended fragment may have written.
std::array<bool, 4> blended_components(std::span<const Arrival> arrivals) {
  std::array<bool, 4> blended{};
  for (const Arrival& arrival : arrivals)
    for (std::size_t c = 0; c < blended.size(); ++c)
      if (arrival.operations->blending && arrival.operations->color_mask[c]) blended[c] = true;
  return blended;
}

// The state with its blended components widened by some codes to both sides.
PermittedSample loosened(PermittedSample state, const std::array<bool, 4>& blended) {
  constexpr int kCodes = 5;
  for (std::size_t c = 0; c < blended.size(); ++c) {
    if (!blended[c]) continue;
    Unorm8Range& range = state.color.permitted[c];
    range.low = static_cast<std::uint8_t>(std::max(0, range.low - kCodes));
    range.high = static_cast<std::uint8_t>(std::min(255, range.high + kCodes));
  }
  return state;
}

}  // namespace

int contested_ruling(const OperationsQuestion& question) {
  const DepthFormat format = question.target().depth;
  const auto blended = blended_components(question.arrivals({}));
  for (const PermittedSample& state : question.states({}, kAllPermitted)) {
    if (agrees(loosened(state, blended), question.stored, format)) return kRulingOnBlendedCodes;
    if (question.stored.depth &&
        agrees(state, question.stored, format, {true, false, true, true}) &&
        is_within_one_code(*question.stored.depth, state.depth.permitted, format))
      return kRulingOnDepthCodes;
  }
  return 0;
}

// ------------------------------------------------------------------------------------- explanation
//
// Explains a sample that does not hold what the renderer's own fragments make of it.

namespace {

// More fragments than this are not described one by one.
constexpr std::size_t kMostDescribed = 6;

std::string describe_stencil_failure(const Arrival& arrival, std::uint8_t stored,
                                     const RuleChoices& choice) {
  const StencilFace& face =
      face_of(*arrival.operations->stencil, arrival.values.front_facing, choice.output.stencil);
  return fmt::format("fails the stencil test ({} {} {} under mask {})", face.reference,
                     name_of(face.function), stored, face.read_mask);
}

// `before`: what exact stored before it.
std::string describe_outcome(const Arrival& arrival, const ExactSample& before,
                             FragmentOutcome outcome, const RuleChoices& choice,
                             DepthFormat format) {
  switch (outcome) {
    case FragmentOutcome::dropped:
      return "is left out by alpha to coverage";
    case FragmentOutcome::stencil_failed:
      return describe_stencil_failure(arrival, before.stencil, choice);
    case FragmentOutcome::depth_failed:
      return fmt::format("fails the depth test ({:.9g} {} {:.9g})",
                         to_depth(arrival.values.depth.exact, format),
                         name_of(arrival.operations->depth.function), before.depth);
    case FragmentOutcome::passed:
      return fmt::format("{}, ({:.6g})", arrival.operations->blending ? "is blended" : "is written",
                         fmt::join(arrival.values.color.exact, ", "));
  }
  return "";
}

// For each arrival: "primitive 0, depth 0.25, is written, (1, 0, 0, 1)".
std::vector<std::string> describe_arrivals(const OperationsQuestion& question,
                                           const RuleChoices& choice) {
  const Target& target = question.target();
  ExactSample sample = cleared_sample<ExactNumbers>(target);
  std::vector<std::string> texts;
  for (const Arrival& arrival : question.arrivals(choice)) {
    const ExactSample before = sample;
    const FragmentOutcome outcome = arrive(arrival, {target, choice.output}, sample);
    const std::string depth = target.depth == DepthFormat::none
                                  ? ""
                                  : fmt::format(", depth {:.9g},", arrival.values.depth.exact);
    texts.push_back(fmt::format("primitive {}{} {}", arrival.fragment->primitive, depth,
                                describe_outcome(arrival, before, outcome, choice, target.depth)));
  }
  return texts;
}

std::string describe_sequence(std::vector<std::string> texts) {
  if (texts.empty()) return "no fragment was drawn there";
  std::string left_out;
  if (texts.size() > kMostDescribed) {
    const std::size_t more = texts.size() - kMostDescribed;
    left_out = fmt::format("{} fragments, then ", more);
    texts.erase(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(more));
  }
  return left_out + fmt::format("{}", fmt::join(texts, "; "));
}

// The reported planes, as exact has them and as they are stored.
struct PlaneTexts {
  std::string exact;
  std::string rendered;
  void add(const std::string& one, const std::string& other) {
    exact += (exact.empty() ? "" : ", ") + one;
    rendered += (rendered.empty() ? "" : ", ") + other;
  }
};

PlaneTexts describe_planes(const ExactSample& exact, const StoredSample& stored) {
  PlaneTexts texts;
  if (stored.color != nullptr)
    texts.add(fmt::format("({})", fmt::join(exact.color, ", ")),
              fmt::format("({})", fmt::join(stored.color, stored.color + 4, ", ")));
  if (stored.depth)
    texts.add(fmt::format("depth {:.9g}", exact.depth), fmt::format("depth {:.9g}", *stored.depth));
  if (stored.stencil)
    texts.add(fmt::format("stencil {}", exact.stencil), fmt::format("stencil {}", *stored.stencil));
  if (stored.hits)
    texts.add(fmt::format("{} passed", exact.hits), fmt::format("{} passed", *stored.hits));
  return texts;
}

}  // namespace

std::string explain_operations(const OperationsQuestion& question, const RuleChoices& chosen) {
  const PlaneTexts planes = describe_planes(question.exact(chosen), question.stored);
  return fmt::format(
      "by the renderer's own fragments the {} should hold {}; it holds {}. In drawing order: {}",
      question.target().samples > 1 ? fmt::format("sample {}", question.sample) : "pixel",
      planes.exact, planes.rendered, describe_sequence(describe_arrivals(question, chosen)));
}

}  // namespace edgecase
