// SPDX-License-Identifier: MIT
//
// Shrinking: the state of one minimisation: the simplest scene so far that shows the find, and the
// one way to replace it.
//
// Steps (search/steps.h) only propose. What is not simpler, cannot be written as a case file, is
// too coarse to show the find (least_fraction_bits), or was proposed before, is never asked.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "search/scene_size.h"
#include "search/signature.h"
#include "search/trial.h"

namespace edgecase {

// ----------------------------------------------------------------------------- least fraction bits

// How fine the coordinates of a scene must be at least for a find to show at all.
//
// A grid of b bits leaves a coordinate of at most b fraction bits where it is. So where the cause
// of a find is another snapping than the policy's, the two treat coarser scenes alike: nothing is
// explained there by that cause, and no such scene can show the find. No search is needed to know.
// Vertices are all that snap rules snap: the corners of wide lines, of points and of multisampled
// lines are made of snapped vertices, and those that implementations round have rules of their own.
//
// Fraction bits, 0 to 16; 0 where nothing is known: the cause does not speak of snapping, or what
// is snapped is other than the vertices that are given: clip coordinates, and passes that are
// shifted.
int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene);

// --------------------------------------------------------------------------------------- shrinking

// Thrown when another scene would be one more than may be asked.
struct AsksExhausted {};

class Shrinking {
 public:
  // `result` is what `scene` shows, `signature` among it. The trial must outlive this.
  Shrinking(Scene scene, Result result, Signature signature, Trial& trial, std::size_t asks_left);

  const Scene& scene() const { return scene_; }
  const Result& result() const { return result_; }
  // Fraction bits that a scene like this one needs to show the find.
  int least_bits() const;
  // What of the scene's result has the signature; empty of failures and aggregated values.
  std::vector<const Disagreement*> finds() const;

  // Is the candidate simpler, and does it show the find? Then it is the scene from now on. Its
  // viewport follows its target and vertices where the scene's own does. Throws AsksExhausted and
  // SearchStopped.
  bool offer(Scene candidate);
  // Offers them in order, several at once, up to the first that show the find; of those that were
  // offered together the simplest is kept.
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
