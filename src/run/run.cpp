// SPDX-License-Identifier: MIT
#include "run/run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "diff/judge.h"
#include "diff/textures/level_ramp.h"
#include "raster/rasterizer.h"
#include "run/expectation_check.h"

namespace edgecase {
namespace {

// Starting a renderer costs as much as drawing some hundred cases.
constexpr std::size_t kLeastSlice = 200;

// Thrown out of a renderer's sink when the run should end.
struct Stopped {};

// The exact rendering of every case, each made once by whoever asks first, with samples where the
// policy has them when no renderer says where its own lie.
class ExactSide {
 public:
  ExactSide(const std::vector<Case>& cases, const Policy& policy)
      : cases_(cases),
        policy_(policy),
        made_(std::make_unique<std::once_flag[]>(cases.size())),
        renderings_(cases.size()) {}

  const Rendering& operator[](std::size_t index) {
    std::call_once(made_[index],
                   [&] { renderings_[index] = rasterize(cases_[index].scene, policy_); });
    return renderings_[index];
  }

 private:
  const std::vector<Case>& cases_;
  const Policy& policy_;
  std::unique_ptr<std::once_flag[]> made_;
  std::vector<Rendering> renderings_;
};

// A renderer's share of the cases: [begin, end).
struct Slice {
  std::size_t renderer = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<Slice> cut(std::size_t cases, std::size_t renderers, std::size_t jobs) {
  const std::size_t wanted = (cases + kLeastSlice - 1) / kLeastSlice;
  const std::size_t parts = std::clamp<std::size_t>(wanted, 1, jobs);
  std::vector<Slice> slices;
  for (std::size_t r = 0; r < renderers; ++r)
    for (std::size_t p = 0; p < parts; ++p)
      slices.push_back({r, cases * p / parts, cases * (p + 1) / parts});
  return slices;
}

class Run {
 public:
  Run(const Suite& suite, const RunOptions& options)
      : suite_(suite),
        options_(options),
        exact_(suite.cases, options.policy),
        infos_(options.renderers.size()),
        results_(suite.cases.size(), std::vector<std::optional<Result>>(options.renderers.size())) {
    for (std::size_t r = 0; r < infos_.size(); ++r) infos_[r].name = options.renderers[r];
  }

  Results operator()() {
    const auto jobs = static_cast<std::size_t>(std::max(1, options_.jobs));
    slices_ = cut(suite_.cases.size(), options_.renderers.size(), jobs);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < std::min(jobs, slices_.size()); ++i)
      threads.emplace_back([this] { work(); });
    for (std::thread& thread : threads) thread.join();
    return collect();
  }

 private:
  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  void work() {
    for (std::size_t next = next_slice_++; next < slices_.size() && !stopped();
         next = next_slice_++) {
      try {
        render_slice(slices_[next]);
      } catch (const Stopped&) {
        return;
      }
    }
  }

  void render_slice(const Slice& slice) {
    auto made = make_renderer(options_.renderers[slice.renderer], options_.renderer_options);
    Renderer& renderer = *std::get<std::unique_ptr<Renderer>>(made);
    std::vector<Task> tasks;
    for (std::size_t i = slice.begin; i < slice.end; ++i)
      tasks.push_back({suite_.cases[i].id, &suite_.cases[i].scene});
    renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
      // A failure may come from being stopped itself.
      if (stopped() && std::holds_alternative<Failure>(outcome)) throw Stopped{};
      const std::size_t at = slice.begin + index;
      results_[at][slice.renderer] = compare_outcome(at, std::move(outcome), renderer);
      report_progress();
      if (stopped()) throw Stopped{};
    });
    const std::lock_guard lock(mutex_);
    RendererInfo info = renderer.info();
    // A slice that never got an answer knows nothing of its renderer.
    if (infos_[slice.renderer].device.empty()) infos_[slice.renderer] = std::move(info);
  }

  Result compare_outcome(std::size_t index, Outcome outcome, const Renderer& renderer) {
    if (auto* failure = std::get_if<Failure>(&outcome)) return not_run(std::move(*failure));
    const RendererInfo info = renderer.info();
    const auto profile = options_.profiles.find(info.name);
    const Case& one = suite_.cases[index];
    const auto& rendering = std::get<Rendering>(outcome);
    const RendererFacts facts{info.subpixel_bits,
                              profile != options_.profiles.end() ? &profile->second : nullptr};
    Result result = compare_with_exact(index, rendering, facts);
    if (std::ranges::find(one.tags, kRampTag) != one.tags.end())
      result.ramp = level_ramp(one.scene, options_.policy, rendering, facts);
    return result;
  }

  // A renderer that has its samples elsewhere is held against exact with samples there.
  Result compare_with_exact(std::size_t index, const Rendering& rendering,
                            const RendererFacts& facts) {
    const Scene& scene = suite_.cases[index].scene;
    const Rendering& usual = exact_[index];
    const SamplePositions& reported = rendering.sample_positions;
    if (reported.empty() || reported == usual.sample_positions) {
      Result result = compare(scene, options_.policy, usual, rendering, facts);
      result.samples = sample_image(rendering);
      return result;
    }
    Rendering own = rasterize(scene, options_.policy, reported);
    Result result = compare(scene, options_.policy, own, rendering, facts);
    result.samples = sample_image(rendering);
    result.exact_samples = sample_image(own);
    result.exact_pixels = std::move(own.pixels);
    return result;
  }

  void report_progress() {
    const std::size_t done = ++done_;
    if (options_.progress) options_.progress(done, suite_.cases.size() * infos_.size());
  }

  CaseResults describe(std::size_t index) {
    const Case& one = suite_.cases[index];
    const Rendering& exact = exact_[index];
    CaseResults result;
    result.id = one.id;
    result.title = one.title;
    result.why = one.why;
    result.rules = one.rules;
    result.spec = one.spec;
    result.origin = one.origin;
    result.tags = one.tags;
    result.file = one.file.generic_string();
    result.source = one.source;
    result.surface = name_of(one.scene.target.surface);
    result.width = exact.width;
    result.height = exact.height;
    result.pixels = exact.pixels;
    result.samples = sample_image(exact);
    result.fragments = exact.fragments.size();
    for (const Rendering& pass : exact.passes) result.fragments += pass.fragments.size();
    result.figure = scene_figure(one.scene);
    result.expect_failures = unmet_drawings(one, options_.policy.name, exact);
    return result;
  }

  Results collect() {
    Results results;
    results.policy = options_.policy.name;
    results.renderers = infos_;
    results.diagnostics = suite_.diagnostics;
    for (std::size_t i = 0; i < suite_.cases.size(); ++i) {
      const bool complete = std::all_of(results_[i].begin(), results_[i].end(),
                                        [](const auto& result) { return result.has_value(); });
      if (!complete) {
        results.interrupted = true;
        continue;
      }
      results.cases.push_back(describe(i));
      for (auto& result : results_[i]) results.cases.back().results.push_back(std::move(*result));
    }
    judge_all(results);
    return results;
  }

  // One judgement per renderer and surface: what is read the same way is what is drawn the same
  // way.
  void judge_all(Results& results) {
    for (std::size_t r = 0; r < results.renderers.size(); ++r) {
      std::map<std::string, std::vector<Result*>> by_surface;
      for (CaseResults& one : results.cases) by_surface[one.surface].push_back(&one.results[r]);
      for (const auto& [surface, group] : by_surface)
        results.renderers[r].traits["lines read with snap, " + surface] =
            judge(group, options_.policy.latitude);
    }
  }

  const Suite& suite_;
  const RunOptions& options_;
  ExactSide exact_;
  std::vector<RendererInfo> infos_;
  std::vector<std::vector<std::optional<Result>>> results_;  // by case, then renderer
  std::vector<Slice> slices_;
  std::atomic<std::size_t> next_slice_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::mutex mutex_;
};

}  // namespace

Results run_suite(const Suite& suite, const RunOptions& options) {
  return Run(suite, options)();
}

}  // namespace edgecase
