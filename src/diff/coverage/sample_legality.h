// SPDX-License-Identifier: MIT
//
// Legality of samples: is one sample of a point, a triangle or a multisampled line drawn, or left
// out, inside the specification? Each sample is judged by itself (rulings 4, 6, 28, 32, 35, 40, 42,
// 47 and 54).
//
// A gross fault asks this of millions of samples, so what is the same for all samples of a
// primitive is found once, and a decision makes no text.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/coverage_report.h"
#include "diff/coverage/facing_latitude.h"
#include "diff/coverage/legality.h"
#include "diff/coverage/sample_place.h"
#include "diff/coverage/size_latitude.h"
#include "model/scene.h"
#include "rules/coverage/clip_polygon.h"

namespace edgecase {

// Where an unclipped triangle that is not multisampled covers what no triangle can (ruling 4).
struct ShapeFault {
  std::vector<PixelPosition> holes;  // that exact covers, sorted
  // One that exact does not cover: samples that are drawn beyond exact's make it a hole.
  std::optional<PixelPosition> hole_beyond;
};
// For a primitive of which the renderer draws something else than exact.
ShapeFault shape_fault(const ScenePrimitive& primitive, const PrimitiveCoverage& coverage,
                       const Target& target);

struct SampleTerms {
  int bits = 4;               // as in ruling 4
  SupportedSizes sizes = {};  // those that the renderer supports
  bool is_multisampled = false;
  bool is_missing = false;  // nothing of the primitive was drawn
  ShapeFault shape = {};
  SamplePlaces* places = nullptr;  // by all that the answer covers; null: of single pixels
};

// Judges the differences of one primitive, which must outlive it. Not safe to use from several
// threads.
class SampleJudge {
 public:
  SampleJudge(const ScenePrimitive& primitive, const SampleTerms& terms);

  // `within`: the sample's position in its pixel. The decision has no reason.
  CoverageLegality decide(const CoverageDifference& difference, Point within) {
    return judged(difference, within, false);
  }
  // The same decision, with its reason.
  CoverageLegality explain(const CoverageDifference& difference, Point within) {
    return judged(difference, within, true);
  }

 private:
  CoverageLegality judged(const CoverageDifference& difference, Point within, bool wants_reason);
  // By the sample alone.
  CoverageLegality judge(const CoverageDifference& difference, Point within) const;
  CoverageLegality judge_clipped(bool extra, Point sample) const;
  CoverageLegality judge_clipped_point(bool extra, Point sample) const;
  // True if OpenGL, which clips at the viewport's sides, may leave out what OpenGL ES must draw.
  bool is_clipped_as_in_opengl(Point sample) const;
  // Triangles that are none: two vertices are one, or a hole lies between covered samples. None if
  // the difference is no part of that.
  std::optional<CoverageLegality> judge_shape(const CoverageDifference& difference) const;
  // Triangles of draws that cull, whose facing may be the cause of the difference (ruling 40).
  CoverageLegality judge_facing(const CoverageDifference& difference,
                                CoverageLegality otherwise) const;
  // Differences that judge() forbids and ruling 47 or 54 contests: the ruling becomes theirs. For
  // multisampled draws, the points at which coverage is found are not reported, and may lie outside
  // the pixel (14.3.1): ruling 47 is broken if a sample elsewhere in the pixel, or less than a
  // pixel outside it, would be covered, or not, as the difference has it.
  void contest(const CoverageDifference& difference, CoverageLegality& legality);
  bool is_so_elsewhere(PixelPosition pixel, bool extra);
  // True if the sample may be covered (or, unless it is `extra`, left out) when the vertices move
  // by `more` than they may.
  bool is_possible(Point sample, bool extra, Fixed more = {}) const;

  // What `make` returns, if a reason is wanted.
  template <class Make>
  std::string reason(const Make& make) const {
    return wants_reason_ ? make() : std::string();
  }

  friend CoverageLegality judge_sample(const ScenePrimitive&, const CoverageDifference&, Point, int,
                                       const SupportedSizes&);

  const ScenePrimitive& primitive_;
  const SampleTerms terms_;
  const Fixed error_;  // by division
  const Latitudes latitudes_;
  std::optional<LoosePolygon> polygon_;  // of a clipped triangle
  const CullingLatitude culling_;
  // Whether it is so elsewhere, by pixel and `extra`, as far as it was asked.
  std::map<std::pair<PixelPosition, bool>, bool> elsewhere_;
  bool wants_reason_ = true;
};

// Judges one `difference` by rulings 4, 6, 28, 32, 35 and 42 alone.
CoverageLegality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              Point within, int bits, const SupportedSizes& sizes = {});

}  // namespace edgecase
