// SPDX-License-Identifier: MIT
//
// Variants: images of a case whose right answer transforms with it, or stays the same.
//
//   reverse    the vertices of each draw in reverse order: for separate primitives, each within
//              itself; of strips and loops, all; of fans, all but the hub, which stays first
//   winding    the second and third vertex of each separate triangle exchanged
//   octants    the seven other images under mirrors and transposition about the target's centre;
//              where transposed, width and height of the target, the viewport and scissors are
//              exchanged, too
//   translate  everything moved by (3, 2) pixels, the target as much larger
//
// If the file gives sample positions, they turn with the image and keep their index; otherwise an
// image has the same positions as the case. The shaded points of a supersampled scene turn
// likewise.
//
// Texture coordinates stay with their vertices; gradients of a lookup turn with the image. All
// images keep coordinates exact, since sizes of targets and steps are whole. Clip coordinates turn
// about the viewport's centre and move with it, so the viewport is chosen first if any vertex has
// them. Otherwise an image is made from the file's content, and viewport and default colours are
// filled in afterwards.
#pragma once

#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/scene/scene_reader.h"

namespace edgecase {

// The names that a file may use.
const std::vector<std::string>& variant_names();

enum class VariantKind { none, reverse, winding, octant, translate };

// One image; `octant` is 1 to 7: bit 0 mirrors x, bit 1 mirrors y, then bit 2 exchanges x and y.
struct Image {
  VariantKind kind = VariantKind::none;
  int octant = 0;

  // Its part of an id: "reverse", "winding", "octant=3", "translate=3,2"; "" for the case itself.
  std::string part() const;
};

// A list of variants as written.
struct Variants {
  std::vector<Place> places;  // of the names, for messages
  std::vector<Image> images;  // the case itself first
};

Variants read_variants(const Place& place, Findings& findings);

// Refuses variants that do not apply to a scene or do not change it.
void check_variants(const Variants& variants, const std::vector<DrawFields>& draws,
                    Findings& findings);

// Transforms a scene into an image of itself. Adds a finding if that leaves the range of targets,
// coordinates or viewports.
void apply_image(const Image& image, TargetFields& target, std::vector<DrawFields>& draws,
                 const Place& draws_place, Findings& findings);

// Converts a scene whose y counts downwards from the target's upper edge to the same scene with y
// up: vertices, clip coordinates, viewport, scissors and both kinds of sample positions. Adds
// findings as apply_image does.
void turn_y_up(TargetFields& target, std::vector<DrawFields>& draws, const Place& draws_place,
               Findings& findings);

}  // namespace edgecase
