// SPDX-License-Identifier: MIT
//
// Compares the answers of a run's renderers with the exact side, case by case, from any thread.
// run/judging.h judges them.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/packed_words.h"
#include "base/shared.h"
#include "diff/compare.h"
#include "model/renderer.h"
#include "model/sample_image.h"
#include "run/run.h"

namespace edgecase {

// Exact's rendering of a case, and the pictures of it that results keep.
struct ExactSide {
  Rendering rendering;
  Shared<PackedWords> pixels;
  SampleImage samples;

  explicit ExactSide(Rendering drawn);
};

// Of a suite of `count` cases. Safe to use from several threads.
class CaseComparison {
 public:
  CaseComparison(std::size_t count, const RunOptions& options);

  // The exact rendering of the scene of the case at `index`, made by the first caller. Samples lie
  // where the policy has them for renderers that do not report positions.
  const ExactSide& exact(std::size_t index, const Scene& scene);
  // Frees the exact rendering of a case for which exact() is not called any more.
  void forget(std::size_t index) { exact_[index].reset(); }

  // Compares the answer of renderer `info` to the case, which is the one at `index`. What fails in
  // comparing costs this answer alone: it is not run, by a fault of ours. Nor is it where comparing
  // takes longer than its patience. Throws ComparisonStopped (diff/findings/patience.h) once
  // options.stop is true.
  Result compare_outcome(std::size_t index, const Case& one, Outcome outcome,
                         const RendererInfo& info);

 private:
  Result compare_rendering(std::size_t index, const Case& one, const Rendering& rendering,
                           const RendererInfo& info);
  Result compare_with_exact(std::size_t index, const Scene& scene, const Rendering& rendering,
                            const RendererFacts& facts);

  const ResolvedPolicy policy_;
  const Profiles profiles_;
  const bool likely_first_;
  const std::atomic<bool>* const stop_;
  const std::chrono::milliseconds patience_;
  std::unique_ptr<std::once_flag[]> made_;
  std::vector<std::unique_ptr<const ExactSide>> exact_;  // by case; null: not made, or freed
};

}  // namespace edgecase
