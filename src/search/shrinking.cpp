// SPDX-License-Identifier: MIT
#include "search/shrinking.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "casefile/case_writer.h"
#include "casefile/scene/viewport.h"
#include "model/rule_id.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

// The grid named by a snap rule in the cause; null if there is none.
const Snap* named_in(const Cause& cause, RuleId rule) {
  const auto part = std::ranges::find(cause.parts, rule, &AlternativeId::rule);
  return part != cause.parts.end() ? find_snap(alternative_of(*part)->name) : nullptr;
}

// Whether vertices are snapped at their given positions.
bool snaps_given_vertices(const Scene& scene) {
  return scene.supersampling.empty() && !has_clip_vertices(scene.draws);
}

}  // namespace

int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene) {
  if (!snaps_given_vertices(scene)) return 0;
  const Cause cause = parse_cause(signature.cause).value_or(Cause());
  const RuleChoices choices = resolve(policy, scene.target.surface);
  int least = 0;
  for (const PrimitiveKind kind :
       {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle}) {
    const Snap* other = named_in(cause, snap_rule_of(kind));
    if (other == nullptr) continue;
    // If neither snaps, all bits count; a scene cannot have more.
    const int coarser = std::min(other->bits, choices.of(kind).snap.bits);
    least = std::max(least, std::min(coarser + 1, Fixed::kFractionBits));
  }
  return least;
}

namespace {

// Scenes rendered at once, any of which would do.
constexpr std::size_t kBatch = 8;

// A case file of the scene; empty if there can be none.
std::string written(const Scene& scene) {
  CaseWords words;
  words.title = "A candidate";
  words.rules = {"any"};
  return case_text(scene, words).text;
}

bool same_viewport(const Viewport& a, const Viewport& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

bool has_chosen_viewport(const Scene& scene) {
  const auto chosen = choose_viewport(scene.target, scene.draws, scene.supersampling);
  return chosen && same_viewport(*chosen, scene.viewport);
}

bool is_in_range(const Scene& scene) {
  return std::ranges::all_of(scene.draws, [](const Draw& draw) {
    return std::ranges::all_of(draw.vertices, [](const Vertex& vertex) {
      return vertex.position.x.in_coordinate_range() && vertex.position.y.in_coordinate_range();
    });
  });
}

// Changes the viewport; window positions of clip coordinates then change.
void see_through(const Viewport& viewport, Scene& scene) {
  if (same_viewport(viewport, scene.viewport)) return;
  scene.viewport = viewport;
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices)
      if (vertex.clip) place_clip_vertex(viewport, vertex);
}

// Whether every vertex reaches OpenGL as given, for scenes that no case file can express.
bool is_exact(const Scene& scene) {
  const Viewport& viewport = scene.viewport;
  const Shifts shifts = shifts_of(scene.supersampling);
  for (const Draw& draw : scene.draws)
    for (const Vertex& vertex : draw.vertices) {
      if (vertex.clip) continue;
      for (const Fixed shift : shifts.x)
        if (find_inexactness(vertex.position.x + shift, {viewport.x, viewport.width}, 'x',
                             vertex.w))
          return false;
      for (const Fixed shift : shifts.y)
        if (find_inexactness(vertex.position.y + shift, {viewport.y, viewport.height}, 'y',
                             vertex.w))
          return false;
      if (find_depth_inexactness(vertex.z, vertex.w)) return false;
    }
  return true;
}

}  // namespace

Shrinking::Shrinking(Scene scene, Result result, Signature signature, Trial& trial,
                     std::size_t asks_left)
    : scene_(std::move(scene)),
      result_(std::move(result)),
      signature_(std::move(signature)),
      trial_(trial),
      asks_left_(asks_left),
      size_(size_of(scene_)),
      is_writable_(!written(scene_).empty()) {}

int Shrinking::least_bits() const {
  return least_fraction_bits(signature_, trial_.options().policy, scene_);
}

std::vector<const Disagreement*> Shrinking::finds() const {
  return disagreements_of(result_, signature_);
}

// Completes a candidate; false if it should not be rendered.
bool Shrinking::prepare(Scene& candidate) {
  if (candidate.draws.empty() || !is_in_range(candidate)) return false;
  if (has_chosen_viewport(scene_)) {
    const auto chosen = choose_viewport(candidate.target, candidate.draws, candidate.supersampling);
    if (!chosen) return false;
    see_through(*chosen, candidate);
  }
  if (!(size_of(candidate) < size_)) return false;
  if (fraction_bits_of(candidate) <
      least_fraction_bits(signature_, trial_.options().policy, candidate))
    return false;
  if (!proposed_.insert(scene_json(candidate)).second) return false;
  return is_writable_ ? !written(candidate).empty() : is_exact(candidate);
}

bool Shrinking::shows_find(const TrialAnswer& answer) const {
  return std::ranges::find(answer.signatures, signature_) != answer.signatures.end();
}

void Shrinking::keep(Scene candidate, TrialAnswer answer) {
  size_ = size_of(candidate);
  scene_ = std::move(candidate);
  result_ = std::move(answer.result);
}

bool Shrinking::offer(Scene candidate) {
  std::vector<Scene> one;
  one.push_back(std::move(candidate));
  return offer_first_of(std::move(one));
}

bool Shrinking::offer_first_of(std::vector<Scene> candidates) {
  std::vector<Scene> batch;
  for (std::size_t next = 0; next < candidates.size();) {
    batch.clear();
    for (; next < candidates.size() && batch.size() < kBatch; ++next)
      if (prepare(candidates[next])) batch.push_back(std::move(candidates[next]));
    if (batch.empty()) break;
    if (asks_left_ == 0) throw AsksExhausted{};
    if (batch.size() > asks_left_)
      batch.erase(batch.begin() + static_cast<std::ptrdiff_t>(asks_left_), batch.end());
    asks_left_ -= batch.size();
    std::vector<TrialAnswer> answers = trial_.ask(batch);
    // Take the simplest: none that is passed over here would be accepted later.
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < batch.size(); ++i)
      if (shows_find(answers[i]) && (!best || size_of(batch[i]) < size_of(batch[*best]))) best = i;
    if (!best) continue;
    keep(std::move(batch[*best]), std::move(answers[*best]));
    return true;
  }
  return false;
}

}  // namespace edgecase
