// SPDX-License-Identifier: MIT
//
// Minimize: from a scene with a find to the smallest scene that shows the same.
//
// Delta debugging: simpler scenes are tried, one step at a time, and kept if the find's signature
// is still among what they show. Steps lead to fewer primitives, default state, smaller targets,
// and rounder and smaller coordinates; they are repeated until none helps. "Simpler" is one order
// on scenes (search/scene_size.h) in which every accepted step descends, so the result is never
// worse than the input and the search ends. Scenes of a few points whose coordinates stay finer
// than 1/16 are searched for among their neighbours on coarser grids.
//
// Equal scenes, signatures and renderers give equal results. How the renderer failed on rejected
// scenes does not matter.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "model/names.h"
#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "search/scene_size.h"
#include "search/trial.h"

namespace edgecase {

// Shrinking: the state of one minimization: the simplest scene so far that shows the find, and the
// only way to replace it.
//
// Steps (search/minimize.h) only propose. Candidates that are not simpler, not expressible as a
// case file, too coarse (least_fraction_bits), or proposed before are not rendered.

// ----------------------------------------------------------------------------- least fraction bits

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

// --------------------------------------------------------------------------------------- shrinking

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

struct MinimizeOptions {
  std::size_t max_asks = 20'000;  // limit of rendered scenes, at least 1
};

enum class MinimizeEnd {
  finished,        // no step helps any more
  exhausted,       // max_asks scenes were rendered
  stopped,         // the trial was stopped
  not_reproduced,  // the scene does not show the signature; `scene` is the input
};
template <>
inline constexpr auto kNames<MinimizeEnd> =
    std::to_array<Named<MinimizeEnd>>({{MinimizeEnd::finished, "finished"},
                                       {MinimizeEnd::exhausted, "exhausted"},
                                       {MinimizeEnd::stopped, "stopped"},
                                       {MinimizeEnd::not_reproduced, "not-reproduced"}});

struct Minimized {
  Scene scene;
  Result result;  // of that scene, judged by the trial
  MinimizeEnd end = MinimizeEnd::finished;
  std::size_t asks = 0;   // scenes rendered for it
  int fraction_bits = 0;  // least found: fraction_bits_of the scene
  int least_bits = 0;     // no such scene shows the find with fewer (least_fraction_bits)
};

// Every scene that is kept can be written as a case file (casefile/case_writer.h), unless the input
// cannot. If the trial is stopped, the result is the best scene so far.
Minimized minimize(const Scene& scene, const Signature& signature, Trial& trial,
                   const MinimizeOptions& options);

// Steps of minimizing: each proposes simpler scenes to a Shrinking, and returns whether any was
// kept.

// -------------------------------------------------------------------------------------- primitives

// Steps towards fewer primitives: removing draws, primitives and vertices of a strip, many at once
// first; splitting strips, loops and fans; joining similar draws.

// The same primitives without shared vertices, each with its vertices in the order of assembly. A
// draw without shared vertices is returned unchanged.
Draw separated(const Scene& scene, std::size_t draw);

// Keeps only the find's primitives, or these together with one other primitive each.
bool keep_only_finds(Shrinking& shrinking);
bool leave_out_draws(Shrinking& shrinking);
bool separate_primitives(Shrinking& shrinking);
// Removes primitives of a draw, or vertices of remaining strips, loops and fans.
bool leave_out_primitives(Shrinking& shrinking);
bool join_draws(Shrinking& shrinking);

// ------------------------------------------------------------------------------------------ target

// Steps towards a smaller target and a position near its origin. Scenes move by whole pixels only:
// anything on a pixel's centre, or between two points of a sub-pixel grid, stays so.

// A distance in whole pixels, y up.
struct Move {
  int x = 0;
  int y = 0;
};

// Moves everything that is drawn: vertices, scissors and, if the scene has its own, the viewport.
// Nothing if vertices are given as clip coordinates.
std::optional<Scene> moved_scene(const Scene& scene, Move move);

// Removes columns and rows: right and top, then left and bottom, with the drawing moved there. The
// find's pixels stay.
bool crop_target(Shrinking& shrinking);
// Moves everything towards the origin without changing the target; powers of two first.
bool move_to_origin(Shrinking& shrinking);

// ------------------------------------------------------------------------------------- coordinates

// Steps towards coordinates that are round, aligned and near to the origin. Vertices at one point
// move together, so that shared edges and ends stay shared.

// The distinct points of vertices in drawing order, without those of clip coordinates.
std::vector<Point> points_of(const Scene& scene);

// Moves every vertex at points[i] to places[i]; `points` is the result of points_of.
Scene with_points(const Scene& scene, const std::vector<Point>& points,
                  const std::vector<Point>& places);

// The multiples of 2^-bits next to a coordinate, the nearest first; only the number itself if it is
// one. `bits` from 0 to 16.
std::vector<Fixed> neighbours_on_grid(Fixed value, int bits);

// Moves all points at once to grids of 1, 1/2, ... pixel: to the nearest position, down, up.
bool round_all(Shrinking& shrinking);
// Then each point, and each x or y, with all the points that share it or without them.
bool round_each(Shrinking& shrinking);
// Sets a point's x or y to that of another.
bool align(Shrinking& shrinking);
// Moves values of x and y by whole pixels towards 0, alone or with all values beyond them.
bool draw_in(Shrinking& shrinking);
// Rounds depths between the planes.
bool round_depths(Shrinking& shrinking);

// ------------------------------------------------------------------------------------- grid search

// Grid search: for scenes of a few points whose coordinates stay fine.
//
// Rounding one coordinate at a time gets stuck if several must move together: a tie needs all of
// its numbers. So whole scenes on a coarse grid are tried: first those with all points next to
// their present positions, then those farther away, then any of the same size, from a generator
// that is the same on every machine.

// The largest number of fraction bits in easily readable coordinates.
constexpr int kReadableBits = 4;
// Scenes of more points are not searched: there are too many of them.
constexpr std::size_t kMostGridPoints = 6;

// Tries all ways to move every point to a neighbour on grids of 1, 1/2, ... pixel that are coarser
// than the present one. Returns whether anything was kept.
bool search_neighbours(Shrinking& shrinking);

// Tries at most `most` scenes of kReadableBits whose points lie farther away. Returns whether
// anything was kept.
bool search_afar(Shrinking& shrinking, std::size_t most);

}  // namespace edgecase
