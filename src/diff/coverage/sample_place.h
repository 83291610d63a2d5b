// SPDX-License-Identifier: MIT
//
// Where a sample lies, by all that an answer covers of it.
//
// The places at which coverage is found need not be those that the renderer reports (ruling 47),
// but a sample has one place in all pixels and for all primitives: 14.3.1 speaks of "exact
// positions", and 8.8 asks that they be the same in the whole of a target.
#pragma once

#include <map>
#include <optional>

#include "diff/coverage/coverage_compare.h"
#include "exact/interval.h"
#include "model/place_cells.h"

namespace edgecase {

// In pixels, from the lower left corner of the sample's pixel.
struct PlaceBox {
  Interval x;
  Interval y;
};

// Finds places by halving the pixel and its neighbours, since a sample may lie less than a pixel
// outside of its pixel (14.3.1): a square remains as long as some place in it may cover each sample
// that the renderer covers, and leave out each that it leaves out, every vertex where its latitude
// puts it. So a box holds all places that explain the answer, and perhaps more: where there is
// none, no place does.
class SamplePlaces {
 public:
  // The context must outlive it.
  explicit SamplePlaces(const CoverageContext& context) : context_(context) {}

  // Of the sample with this index in multisampled primitives; nothing if no place explains all that
  // they cover. Found at the first question.
  const std::optional<PlaceBox>& of(int sample);
  // The same, found faster and less exactly: to 1/16 pixel.
  std::optional<PlaceBox> about(int sample) const;
  // All squares of 1/16 pixel that remain.
  PlaceCells cells(int sample) const;

 private:
  const CoverageContext& context_;
  std::map<int, std::optional<PlaceBox>> known_;
};

// True if all texels of the target have their samples at the same places (8.8): who reports them
// has a target with fixed sample locations.
bool have_one_place(const CoverageContext& context);

// Notes where the samples lie by what is covered: of those whose coverage breaks ruling 47, and in
// small scenes of all, as far as that is told by half a pixel.
void note_places(const CoverageContext& context, SamplePlaces& places, Result& result);

}  // namespace edgecase
