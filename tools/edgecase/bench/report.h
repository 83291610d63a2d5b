// SPDX-License-Identifier: MIT
//
// The measurements of `edgecase bench`, as a table and as JSON. The relevant figures are ratios of
// times measured side by side; rates are for orientation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/edgecase/bench/times.h"

namespace edgecase {

// One renderer's times for a scene, a frame each, round by round.
struct RendererTimes {
  std::string renderer;
  std::string problem;  // why it was not timed; otherwise empty
  std::vector<double> seconds;
  std::size_t same_pixels = 0;  // of its picture and ours
};

struct SceneTimes {
  std::string name;
  std::string unit;           // "triangles"
  double items = 0;           // of a frame
  int side = 0;               // of the target, pixels
  std::vector<double> exact;  // seconds a frame, round by round
  std::vector<RendererTimes> renderers;
};

// Cases a second.
struct PipelineRates {
  std::string renderer;
  std::string problem;
  std::size_t cases = 0;
  std::vector<double> worker;  // the worker alone draws, counts, captures and reads back
  // The whole of `run`, from the scene to the results; first with one job on one core.
  std::vector<double> one_core;
  std::vector<double> one_job;
  std::vector<double> two_jobs;
  std::vector<double> fuzzed;  // scenes a second of `fuzz`, one job
};

// Bytes of one picture a second; two are read.
struct DiffRates {
  std::vector<double> memcmp;     // of identical pictures
  std::vector<double> identical;  // by the comparison of pictures
  std::vector<double> different;  // the same with every pixel different
};

// The time of cases by stage.
struct StageTimes {
  std::string renderer;
  std::size_t cases = 0;
  struct Stage {
    std::string name;
    double seconds = 0;  // of all cases
  };
  std::vector<Stage> stages;
  // What the cases of one subject cost: coverage, values, textures, samples or output.
  struct Subject {
    std::string name;
    std::size_t cases = 0;
    double worker = 0;  // seconds, of these cases, as the next two
    double exact = 0;
    double comparing = 0;
  };
  std::vector<Subject> subjects;
};

struct BenchReport {
  int rounds = 0;
  std::vector<SceneTimes> scenes;
  std::vector<PipelineRates> pipelines;
  std::optional<DiffRates> diff;
  std::vector<StageTimes> stages;
};

void print_bench(const BenchReport& report);
std::string bench_json(const BenchReport& report);

}  // namespace edgecase
