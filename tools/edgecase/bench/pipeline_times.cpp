// SPDX-License-Identifier: MIT
//
// The whole pipeline: cases, random scenes, pictures, and the stages of a run.
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "results/results_json.h"
#include "run/comparing.h"
#include "run/judging.h"
#include "run/renderers.h"
#include "run/run.h"
#include "search/fuzz.h"
#include "tools/edgecase/bench/rates.h"
#include "tools/edgecase/bench/scenes.h"
#include "tools/edgecase/bench/worker.h"

namespace edgecase {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

RunOptions options_for(const std::string& renderer, int jobs) {
  RunOptions options;
  options.renderers = {renderer};
  options.renderer_options = {options.policy, std::chrono::seconds(60), worker_directory(), {}};
  options.jobs = jobs;
  return options;
}

// `run --json` with loaded cases, without writing to a disk.
double run_once(const Suite& suite, const std::string& renderer, int jobs) {
  const auto start = Clock::now();
  const Results results = run_suite(suite, options_for(renderer, jobs)).results;
  std::ofstream out("/dev/null");
  write_packed_results(results, out);
  return seconds_since(start);
}

// While an object lives, this thread and the threads and processes that it starts run on one
// processor, if the system allows it.
class OneCore {
 public:
  OneCore() {
    CPU_ZERO(&before_);
    if (sched_getaffinity(0, sizeof(before_), &before_) != 0) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    std::size_t first = 0;
    while (first + 1 < CPU_SETSIZE && !CPU_ISSET(first, &before_)) ++first;
    CPU_SET(first, &one);
    is_set_ = sched_setaffinity(0, sizeof(one), &one) == 0;
  }
  ~OneCore() {
    if (is_set_) sched_setaffinity(0, sizeof(before_), &before_);
  }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;
  bool is_set() const { return is_set_; }

 private:
  cpu_set_t before_;
  bool is_set_ = false;
};

// Nothing if the run cannot be bound to one core.
std::optional<double> run_once_on_one_core(const Suite& suite, const std::string& renderer) {
  const OneCore one;
  if (!one.is_set()) return std::nullopt;
  return run_once(suite, renderer, 1);
}

// Scenes about coverage, of which only violations would be minimized.
double fuzz_once(const std::string& renderer, std::size_t count) {
  FuzzOptions options;
  for (const Family& family : all_families())
    if (family.coverage_only && family.scenes == 0) options.families.push_back(&family);
  options.least = Verdict::violation;
  options.count = count;
  const auto make = [&] {
    return std::get<std::unique_ptr<Renderer>>(
        make_renderer(renderer, options_for(renderer, 1).renderer_options));
  };
  const auto start = Clock::now();
  fuzz({{renderer, make, {}, {}}}, options);
  return seconds_since(start);
}

std::vector<Scene> scenes_of(const Suite& suite) {
  std::vector<Scene> scenes;
  for (const Case& one : suite.cases) scenes.push_back(one.scene);
  return scenes;
}

PipelineRates time_pipeline(const BenchPlan& plan, const Suite& suite,
                            const std::string& renderer) {
  PipelineRates rates;
  rates.renderer = renderer;
  rates.cases = suite.cases.size();
  auto started = BenchWorker::start(renderer);
  if (auto* problem = std::get_if<std::string>(&started)) {
    rates.problem = std::move(*problem);
    return rates;
  }
  BenchWorker& worker = *std::get<std::unique_ptr<BenchWorker>>(started);
  const BenchRequest request{BenchTask::render, 0, scenes_of(suite)};
  const auto cases = static_cast<double>(rates.cases);
  for (int round = 0; round < plan.rounds; ++round) {
    const BenchAnswer answer = worker.ask(request);
    if (!answer.problem.empty()) {
      rates.problem = answer.problem;
      return rates;
    }
    rates.worker.push_back(cases / answer.seconds);
    const std::optional<double> on_one_core = run_once_on_one_core(suite, renderer);
    if (!on_one_core) {
      rates.problem = "the system does not let a run have one processor for itself";
      return rates;
    }
    rates.one_core.push_back(cases / *on_one_core);
    rates.one_job.push_back(cases / run_once(suite, renderer, 1));
    rates.two_jobs.push_back(cases / run_once(suite, renderer, 2));
    rates.fuzzed.push_back(cases / fuzz_once(renderer, rates.cases));
  }
  return rates;
}

// What a case is mainly about, by what its scene has.
std::string subject_of(const Case& one) {
  const Scene& scene = one.scene;
  if (scene.target.samples > 1 || !scene.supersampling.empty()) return "samples";
  if (!scene.textures.empty()) return "textures";
  if (has_fragment_operations(scene)) return "output";
  const bool is_of_values = std::ranges::any_of(one.rules, [](const std::string& name) {
    return name.starts_with("attribute.") || name.starts_with("derivative.") ||
           name.starts_with("fragment.") || name.starts_with("framebuffer.");
  });
  return is_of_values ? "values" : "coverage";
}

// Times all stages except the renderer's own, case by case.
class StageTimer {
 public:
  StageTimer(const Suite& suite, const std::string& renderer)
      : suite_(suite),
        options_(options_for(renderer, 1)),
        comparison_(suite.cases.size(), options_) {}

  StageTimes run(double load_seconds) {
    auto renderer = std::get<std::unique_ptr<Renderer>>(
        make_renderer(options_.renderers.front(), options_.renderer_options));
    const auto start = Clock::now();
    const std::vector<Case> cases = suite_.cases.all();
    std::vector<Task> tasks;
    for (const Case& one : cases) tasks.push_back({one.id, &one.scene});
    auto asked = Clock::now();
    renderer->render(tasks, [&](std::size_t i, Outcome outcome) {
      StageTimes::Subject& subject = subjects_[subject_of(cases[i])];
      ++subject.cases;
      subject.worker += seconds_since(asked);
      results_.cases.push_back(compare(i, cases[i], std::move(outcome), renderer->info(), subject));
      asked = Clock::now();
    });
    const double asking = seconds_since(start) - exact_ - comparing_;
    results_.renderers = {renderer->info()};
    const double judging = time_of(0, [&] { judge_all(results_); });
    std::ofstream out("/dev/null");
    const double writing = time_of(0, [&] { write_packed_results(results_, out); });
    return {options_.renderers.front(),
            suite_.cases.size(),
            {{"read and expand", load_seconds},
             {"ask and wait for the worker", asking},
             {"exact rendering", exact_},
             {"compare, with causes", comparing_},
             {"judge", judging},
             {"write results", writing}},
            named_subjects()};
  }

 private:
  std::vector<StageTimes::Subject> named_subjects() const {
    std::vector<StageTimes::Subject> named;
    for (const auto& [name, subject] : subjects_) {
      named.push_back(subject);
      named.back().name = name;
    }
    return named;
  }

  CaseResults compare(std::size_t i, const Case& asked, Outcome outcome, const RendererInfo& info,
                      StageTimes::Subject& subject) {
    const double drawing = time_of(0, [&] { comparison_.exact(i, asked.scene); });
    CaseResults one;
    const double comparing = time_of(0, [&] {
      one.results.emplace_back(comparison_.compare_outcome(i, asked, std::move(outcome), info));
    });
    exact_ += drawing;
    subject.exact += drawing;
    comparing_ += comparing;
    subject.comparing += comparing;
    one.pixels = comparison_.exact(i, asked.scene).pixels;
    comparison_.forget(i);
    one.id = asked.id;
    one.surface = name_of(asked.scene.target.surface);
    return one;
  }

  const Suite& suite_;
  RunOptions options_;
  CaseComparison comparison_;
  Results results_;
  double exact_ = 0;
  double comparing_ = 0;
  std::map<std::string, StageTimes::Subject> subjects_;
};

}  // namespace

std::vector<PipelineRates> time_pipelines(const BenchPlan& plan) {
  Suite suite;
  suite.cases = bench_cases(plan.cases);
  std::vector<PipelineRates> rates;
  for (const std::string& renderer : plan.renderers)
    rates.push_back(time_pipeline(plan, suite, renderer));
  return rates;
}

DiffRates time_diff(const BenchPlan& plan) {
  constexpr std::size_t kBytes = std::size_t{4} * 4096 * 4096;
  const std::vector<std::uint8_t> picture(kBytes, 1);
  const std::vector<std::uint8_t> same(kBytes, 1);
  const std::vector<std::uint8_t> other(kBytes, 2);
  // The sum is used, so that the compiler does not remove the work.
  volatile std::size_t kept = 0;
  const auto rate = [&](auto compare) {
    return static_cast<double>(kBytes) / time_of(plan.seconds, [&] { kept = compare(); });
  };
  DiffRates rates;
  for (int round = 0; round < plan.rounds; ++round) {
    rates.memcmp.push_back(rate([&] {
      return static_cast<std::size_t>(std::memcmp(picture.data(), same.data(), kBytes) == 0);
    }));
    rates.identical.push_back(rate([&] { return count_same_pixels(picture, same); }));
    rates.different.push_back(rate([&] { return count_same_pixels(picture, other); }));
  }
  return rates;
}

std::vector<StageTimes> time_stages(const BenchPlan& plan, const Suite& suite,
                                    double load_seconds) {
  std::vector<StageTimes> times;
  for (const std::string& renderer : plan.renderers)
    times.push_back(StageTimer(suite, renderer).run(load_seconds));
  return times;
}

}  // namespace edgecase
