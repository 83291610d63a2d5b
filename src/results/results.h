// SPDX-License-Identifier: MIT
//
// Results: everything that one run found, in memory. results/results_json.h writes it; reports draw
// it. Nothing here is computed: src/diff fills verdicts, results/expectations.h fills expectations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/figure.h"
#include "model/renderer.h"
#include "model/result.h"

namespace edgecase {

// One case with the results of all renderers, in the order of Results::renderers.
struct CaseResults {
  std::string id;
  std::string title;
  std::string why;
  std::vector<std::string> rules;
  std::string spec;
  std::string origin;
  std::vector<std::string> tags;
  std::string file;    // path of the case file, as given
  std::string source;  // its text
  std::string surface;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;          // of the exact side, RGBA8, bottom row first
  SampleImage samples;                       // of the exact side, where it is multisampled
  std::size_t fragments = 0;                 // of the exact side
  Figure figure;                             // the case's primitives and vertices
  std::vector<std::string> expect_failures;  // hand-drawn truths that exact does not meet
  std::vector<Result> results;
};

struct Results {
  std::string tool;    // "edgecase 0.1.0"
  std::string policy;  // name
  std::vector<RendererInfo> renderers;
  std::vector<CaseResults> cases;       // sorted by id
  std::vector<Diagnostic> diagnostics;  // case files that could not be loaded
  bool interrupted = false;             // some cases were left out
};

// verdict -> number of cases, for the renderer at `index`.
std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index);

}  // namespace edgecase
