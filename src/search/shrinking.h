// SPDX-License-Identifier: MIT
//
// Shrinking: the state of one minimization: the simplest scene so far that shows the find, and the
// only way to replace it.
//
// Steps (search/scene_steps.h, search/coordinate_steps.h, search/grid_search.h) only propose.
// Candidates that are not simpler, not expressible as a case file, too coarse
// (least_fraction_bits), or proposed before are not rendered.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_set>
#include <vector>

#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "search/scene_size.h"
#include "search/trial.h"

namespace edgecase {

// The least fineness of a scene's coordinates for a find to show at all.
//
// A grid of b bits does not move a coordinate of at most b fraction bits. So if the cause of a find
// is a different snap than the policy's, both treat coarser scenes alike: that cause explains
// nothing there, and no such scene can show the find. This is known without a search. Snap rules
// snap only vertices: the corners of wide lines, of points and of multisampled lines are computed
// from snapped vertices, and rounding of these has rules of its own.
//
// Fraction bits, 0 to 16. 0 if unknown: the cause does not involve snapping, or the snapped
// vertices are not the given ones, as with clip coordinates and shifted passes.
int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene);

// Thrown if another scene would exceed the limit.
struct AsksExhausted {};

class Shrinking {
 public:
  // `result` is that of `scene` and shows `signature`. The trial must outlive this object.
  Shrinking(Scene scene, Result result, Signature signature, Trial& trial, std::size_t asks_left);

  const Scene& scene() const { return scene_; }
  const Result& result() const { return result_; }
  // Fraction bits that such a scene needs to show the find.
  int least_bits() const;
  // The disagreements with the signature; empty for failures and aggregated values.
  std::vector<const Disagreement*> finds() const;

  // If the candidate is simpler and shows the find, it becomes the scene, and the result is true.
  // Its viewport follows target and vertices if that of the scene does. Throws AsksExhausted and
  // SearchStopped.
  bool offer(Scene candidate);
  // Offers them in order, several at once, until some show the find; of those rendered together,
  // the simplest is kept.
  bool offer_first_of(std::vector<Scene> candidates);

 private:
  bool prepare(Scene& candidate);
  bool shows_find(const TrialAnswer& answer) const;
  void keep(Scene candidate, TrialAnswer answer);

  Scene scene_;
  Result result_;
  Signature signature_;
  Trial& trial_;
  std::size_t asks_left_;
  SceneSize size_;
  bool is_writable_;
  std::unordered_set<std::string> proposed_;
};

}  // namespace edgecase
