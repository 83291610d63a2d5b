// SPDX-License-Identifier: MIT
//
// The measurements of `edgecase bench`; each alternates with the one that it is compared with.
#pragma once

#include <string>
#include <vector>

#include "suite/selection.h"
#include "tools/edgecase/bench/report.h"

namespace edgecase {

struct BenchPlan {
  std::vector<std::string> renderers;
  int rounds = 5;
  double seconds = 0.3;      // of one measurement, at least
  int side = 1024;           // of the scenes' targets
  std::size_t cases = 4096;  // of a pipeline, about
};

std::vector<SceneTimes> time_scenes(const BenchPlan& plan);
std::vector<PipelineRates> time_pipelines(const BenchPlan& plan);
DiffRates time_diff(const BenchPlan& plan);
// For each renderer, over these cases. `load_seconds`: the time to load them.
std::vector<StageTimes> time_stages(const BenchPlan& plan, const Suite& suite, double load_seconds);

}  // namespace edgecase
