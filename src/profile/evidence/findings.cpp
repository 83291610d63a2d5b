// SPDX-License-Identifier: MIT
#include "profile/evidence/findings.h"

#include <algorithm>
#include <utility>

#include "profile/evidence/inference.h"

namespace edgecase {

const char* component_name(ValueKind kind, int component) {
  constexpr std::array kColors{"red", "green", "blue", "alpha"};
  switch (kind) {
    case ValueKind::color:
      break;
    case ValueKind::depth:
      return "depth";
    case ValueKind::inverse_w:
      return "gl_FragCoord.w";
  }
  return kColors[static_cast<std::size_t>(component)];
}

double ValueErrors::mean_ulp() const {
  const std::size_t numbers = components - not_numbers;
  return numbers == 0 ? 0 : ulp_sum / static_cast<double>(numbers);
}

std::optional<int> ValueErrors::log2_bound(double share) const {
  const double asked = share * static_cast<double>(components - not_numbers);
  std::size_t within = correct;
  if (static_cast<double>(within) >= asked) return std::nullopt;
  for (const auto& [exponent, count] : histogram) {
    within += count;
    if (static_cast<double>(within) >= asked) return exponent + 1;
  }
  return std::nullopt;
}

const FormulaResidual& LevelResiduals::found() const {
  return *std::ranges::find_if(formulas, &FormulaResidual::is_found);
}

bool InvocationRow::is_violation() const {
  const auto is_elsewhere = [](const auto& one) { return one.first != kOwnSample; };
  return at_sample &&
         (std::ranges::any_of(whole, is_elsewhere) || std::ranges::any_of(partial, is_elsewhere));
}

std::size_t BlendResidual::wrong() const {
  std::size_t sum = 0;
  for (const auto& [difference, count] : off) sum += count;
  return sum;
}

void SurfaceFindings::adopt(Trait trait) {
  if (trait.id.is_rule() && trait.rate.of > 0 && trait.alternative != kNoneFits)
    choices[name_of(trait.id.rule)] = trait.alternative;
  traits.push_back(std::move(trait));
}

void measure_subject(const Subject& subject, Renderer& renderer, const Question& question,
                     const ObservationProgress& progress, const std::atomic<bool>* stop,
                     SurfaceFindings& findings) {
  SceneDrawing drawing(renderer, progress, stop, subject.scene_count(question.scenes_per_kind));
  subject.measure(question, drawing, findings);
  drawing.finish();
  findings.drawn += drawing.counts();
}

}  // namespace edgecase
