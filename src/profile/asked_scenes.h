// SPDX-License-Identifier: MIT
//
// What a measurement asks, for renderers that cannot be asked themselves: a page draws these scenes
// wherever it is opened, and its recording is measured.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"
#include "profile/profile.h"

namespace edgecase {

// The measurement that a page's recording answers: few scenes, without windows.
MeasureOptions options_of_pages();

// A scene with the id by which `measure` asks for it.
struct AskedScene {
  std::string id;
  Scene scene;
};

// What `measure` asks of exact, by ascending id. Some scenes depend on earlier answers; those that
// another renderer would be asked are missing.
std::vector<AskedScene> asked_scenes(MeasureOptions options);

}  // namespace edgecase
