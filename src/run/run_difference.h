// SPDX-License-Identifier: MIT
//
// Whether two runs are one in all that decides on results but the cases: version of the tool,
// policy, profiles, renderers. Only then may answers of both stand side by side.
#pragma once

#include <optional>
#include <string>

#include "results/results.h"

namespace edgecase {

// Results of a run, or of a part of one.
struct MergePart {
  std::string name;  // of its file, for messages
  Results results;
};

struct RunDifference {
  std::string what;    // "a.json was judged by policy opengl, b.json by policy cs184"
  std::string remedy;  // where the two are shards: "run all shards with one policy"
};

// The first difference of two runs; nothing where there is none. A renderer that never answered
// differs from none of its name.
std::optional<RunDifference> difference_of_runs(const MergePart& a, const MergePart& b);

// Such a renderer says nothing of itself.
bool has_never_answered(const RendererInfo& renderer);

}  // namespace edgecase
