// SPDX-License-Identifier: MIT
//
// Variants: images of a case of which the right answer is known to follow it, or to stay the same.
//
//   reverse    the vertices of each draw in reverse order: of separate primitives, each within
//              itself; of strips and loops, all; of fans, all but the hub, which stays first
//   winding    the second and third vertex of each separate triangle exchanged
//   octants    the seven other images under mirrors and transposition about the target's centre;
//              where transposed, width and height of the target, the viewport and scissors are
//              exchanged, too
//   translate  everything moved by (3, 2) pixels, the target as much larger
//
// Positions of samples turn with the image, each with its index, where the file gives them; where
// it gives none, an image has them wherever the case itself has. The places where a supersampled
// scene is shaded turn likewise.
//
// Texture coordinates stay with their vertices; gradients that a lookup gives turn with the image.
// All keep coordinates exact, since sizes of targets and steps are whole. Clip coordinates turn
// about the viewport's centre and move with it, so where any vertex has them the viewport is
// settled first. An image is made of what the file says; otherwise viewport and colours that it
// leaves open are filled in afterwards.
#pragma once

#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/scene/scene_reader.h"

namespace edgecase {

// What a file may ask for.
const std::vector<std::string>& variant_names();

enum class VariantKind { none, reverse, winding, octant, translate };

// One image; `octant` is 1 to 7: bit 0 mirrors x, bit 1 mirrors y, bit 2 then exchanges x and y.
struct Image {
  VariantKind kind = VariantKind::none;
  int octant = 0;

  // The part of an id: "reverse", "winding", "octant=3", "translate=3,2"; "" of the case itself.
  std::string part() const;
};

// A list of variants as written.
struct Variants {
  std::vector<Place> places;  // of the names, for messages
  std::vector<Image> images;  // the case itself first
};

Variants read_variants(const Place& place, Findings& findings);

// Refuses variants that a scene does not have, or that leave it as it is.
void check_variants(const Variants& variants, const std::vector<DrawFields>& draws,
                    Findings& findings);

// Turns a scene into an image of itself. Adds a finding where that leaves the ranges of targets,
// coordinates or viewports.
void apply_image(const Image& image, TargetFields& target, std::vector<DrawFields>& draws,
                 const Place& draws_place, Findings& findings);

// Turns a scene whose y counts from the target's upper edge downwards into the same scene with y
// up: of vertices, clip coordinates, viewport, scissors and positions of samples, of either kind.
// Adds findings as apply_image does.
void turn_y_up(TargetFields& target, std::vector<DrawFields>& draws, const Place& draws_place,
               Findings& findings);

}  // namespace edgecase
