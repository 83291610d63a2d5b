// SPDX-License-Identifier: MIT
//
// Comparing the answers of a run's renderers with the exact side, case by case, whichever thread
// they come from. Nothing is judged here.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "diff/compare.h"
#include "model/renderer.h"
#include "model/storage.h"
#include "run/run.h"

namespace edgecase {

// What exact draws of a case, and the pictures of it that results keep.
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

  // The exact rendering of the scene of the case at `index`, made once by whoever asks first, with
  // samples where the policy has them when no renderer says where its own lie.
  const ExactSide& exact(std::size_t index, const Scene& scene);
  // Nobody asks for the exact rendering of this case any more.
  void forget(std::size_t index) { exact_[index].reset(); }

  // What `info` answered to the case, which is that at `index`, compared.
  Result compare_outcome(std::size_t index, const Case& one, Outcome outcome,
                         const RendererInfo& info);

 private:
  Result compare_with_exact(std::size_t index, const Scene& scene, const Rendering& rendering,
                            const RendererFacts& facts);

  const ResolvedPolicy policy_;
  std::map<std::string, ResolvedPolicy> profiles_;
  std::unique_ptr<std::once_flag[]> made_;
  std::vector<std::unique_ptr<const ExactSide>> exact_;  // of cases that somebody asks for
};

}  // namespace edgecase
