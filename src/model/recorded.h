// SPDX-License-Identifier: MIT
//
// Renderers that replay a recording, and who they stand for: their results are their own, but what
// is known of the renderer that was recorded holds for them.
#pragma once

#include <string>
#include <string_view>

#include "model/renderer.h"

namespace edgecase {

// What names of such renderers begin with; the path of a file follows.
constexpr std::string_view kRecordingPrefix = "recording:";

// The trait by which they tell the name of the renderer that was recorded.
constexpr const char* kRecordedTrait = "recorded";

// The name under which expectations and profiles know a renderer: its own, or that of the renderer
// which was recorded. Of others than recordings, the trait means nothing.
const std::string& known_as(const RendererInfo& info);

}  // namespace edgecase
