// SPDX-License-Identifier: MIT
#include "run/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "base/threads.h"
#include "diff/findings/patience.h"
#include "results/standing.h"
#include "run/answer_digest.h"
#include "run/comparing.h"
#include "run/earlier_answers.h"
#include "run/invariant_renderer.h"
#include "run/judging.h"
#include "run/renderers.h"
#include "run/share_queue.h"
#include "suite/case_store.h"
#include "suite/expectation_check.h"

namespace edgecase {
namespace {

// Thrown out of a renderer's sink when the run should end.
struct Stopped {};

auto all_of(const RendererInfo& info) {
  return std::tie(info.name, info.vendor, info.version, info.device, info.subpixel_bits,
                  info.traits);
}

class Run {
 public:
  Run(const Suite& suite, const RunOptions& options)
      : suite_(suite),
        options_(options),
        comparison_(suite.cases.size(), options),
        digests_(options.policy, options.profiles),
        infos_(options.renderers.size()),
        results_(suite.cases.size()),
        unanswered_(suite.cases.size()),
        shelved_(suite.cases.size()) {
    for (auto& renderers : unanswered_) renderers = options.renderers.size();
    for (auto& results : results_) results.resize(options.renderers.size());
    for (std::size_t r = 0; r < infos_.size(); ++r)
      infos_[r].name = split_name(options.renderers[r]).name;
    if (options.earlier == nullptr || options.max_unexpected > 0) return;
    std::vector<std::string> names;
    for (const RendererInfo& info : infos_) names.push_back(info.name);
    earlier_.emplace(*options.earlier, names);
  }

  CompletedRun operator()() {
    const auto jobs = static_cast<std::size_t>(std::max(1, options_.jobs));
    ShareQueue shares(shares_of(suite_.cases, options_.renderers.size()), jobs);
    run_threads(std::min(jobs, shares.size()), [&](std::size_t thread) { work(shares, thread); });
    if (enough_) finish_begun_cases();
    return collect();
  }

 private:
  using Renderers = std::map<std::size_t, std::unique_ptr<Renderer>>;  // by index

  struct Answer {
    Result result;
    bool is_kept = false;  // what an earlier run found of it stands in the result's place
  };

  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  void work(ShareQueue& shares, std::size_t thread) {
    Renderers own;
    try {
      while (!stopped() && !enough_) {
        const std::optional<Share> share = shares.take(thread);
        if (!share) return;
        std::vector<std::size_t> cases(share->cases.end - share->cases.begin);
        std::iota(cases.begin(), cases.end(), share->cases.begin);
        render_cases(share->renderer, cases, renderer_of(share->renderer, own));
        shares.finish(*share);
      }
    } catch (const Stopped&) {
    } catch (...) {
      // The shelf has no room, for instance.
      shares.close();
      throw;
    }
  }

  Renderer& renderer_of(std::size_t index, Renderers& own) const {
    std::unique_ptr<Renderer>& renderer = own[index];
    if (renderer == nullptr)
      renderer = std::make_unique<InvariantRenderer>(
          std::get<std::unique_ptr<Renderer>>(
              make_renderer(options_.renderers[index], options_.renderer_options)),
          options_.suggested_images);
    return *renderer;
  }

  // The cases that some renderers answered and others did not before enough were unexpected.
  void finish_begun_cases() {
    is_finishing_ = true;
    for (std::size_t r = 0; r < infos_.size() && !stopped(); ++r) {
      std::vector<std::size_t> cases;
      for (std::size_t i = 0; i < results_.size(); ++i)
        if (is_begun(i) && results_[i][r] == nullptr) cases.push_back(i);
      if (cases.empty()) continue;
      Renderers own;
      try {
        render_cases(r, cases, renderer_of(r, own));
      } catch (const Stopped&) {
        return;
      }
    }
  }

  // True if some renderers have answered it, and others not.
  bool is_begun(std::size_t index) const {
    return unanswered_[index] > 0 && unanswered_[index] < infos_.size();
  }

  void render_cases(std::size_t index, const std::vector<std::size_t>& cases, Renderer& renderer) {
    std::vector<Case> asked_cases;
    for (const std::size_t i : cases) asked_cases.push_back(suite_.cases[i]);
    std::vector<Task> tasks;
    for (const Case& one : asked_cases)
      tasks.push_back({one.id, &one.scene, false, options_.invariance || one.invariant});
    auto asked = std::chrono::steady_clock::now();
    renderer.render(tasks, [&](std::size_t i, Outcome outcome) {
      note_duration(tasks[i].id, index, asked);
      note_info(index, renderer.info());
      // A failure may come from being stopped itself.
      if (stopped() && std::holds_alternative<Failure>(outcome)) throw Stopped{};
      std::unique_ptr<Answer>& answer = results_[cases[i]][index];
      answer = std::make_unique<Answer>(
          answer_to(cases[i], asked_cases[i], index, std::move(outcome), renderer));
      if (!answer->is_kept)
        count_unexpected(cases[i], asked_cases[i], renderer.info(), answer->result);
      if (--unanswered_[cases[i]] == 0) complete(cases[i], asked_cases[i]);
      report_progress();
      if (stopped() || (enough_ && !is_finishing_)) throw Stopped{};
      asked = std::chrono::steady_clock::now();
    });
  }

  // Compares what the renderer at `index` gave the case at `at`, unless that was done before.
  Answer answer_to(std::size_t at, const Case& one, std::size_t index, Outcome outcome,
                   const Renderer& renderer) {
    const RendererInfo& info = renderer.info();
    std::uint64_t digest = 0;
    if (const auto* rendering = std::get_if<Rendering>(&outcome)) {
      digest = digests_.of(one, *rendering, info, renderer.outcome_digest());
      if (earlier_ && earlier_->has(one.id, index, digest)) {
        ++kept_;
        return {{}, true};
      }
    }
    Answer answer{compared(at, one, std::move(outcome), info), false};
    // What was not compared to its end is compared again by the next run.
    if (!answer.result.failure) answer.result.answer_digest = digest;
    return answer;
  }

  Result compared(std::size_t at, const Case& one, Outcome outcome, const RendererInfo& info) {
    try {
      return comparison_.compare_outcome(at, one, std::move(outcome), info);
    } catch (const ComparisonStopped&) {
      throw Stopped{};
    }
  }

  void note_duration(const std::string& id, std::size_t index,
                     std::chrono::steady_clock::time_point asked) {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - asked;
    const std::lock_guard lock(mutex_);
    // As the file has it (results/durations.h), so that reports of both are the same.
    durations_[id][options_.renderers[index]] = std::round(took.count() * 1e6) / 1e6;
  }

  // A renderer without any answer has not reported anything.
  void note_info(std::size_t index, const RendererInfo& info) {
    const std::lock_guard lock(mutex_);
    RendererInfo& known = infos_[index];
    if (!known.device.empty() || all_of(known) == all_of(info)) return;
    known = info;
    is_more_known_ = true;
  }

  // Counts a case once, however many renderers answer it unexpectedly.
  void count_unexpected(std::size_t at, const Case& one, const RendererInfo& info,
                        const Result& result) {
    if (options_.max_unexpected == 0 || enough_) return;
    std::vector<const KnownFault*> faults;
    if (const KnownFaults* known = faults_about(options_.known, info))
      faults = faults_of(*known, info);
    if (!is_surely_unexpected(one, result, options_.policy.latitude, faults)) return;
    const std::lock_guard lock(mutex_);
    unexpected_.insert(at);
    if (unexpected_.size() >= options_.max_unexpected) enough_ = true;
  }

  void report_progress() {
    const std::size_t done = ++done_;
    if (options_.progress) options_.progress(done, suite_.cases.size() * infos_.size());
  }

  // Exact renderings are the bulk of what a run holds: each is kept until the last renderer has
  // been held against it.
  void complete(std::size_t index, const Case& answered) {
    const std::vector<std::unique_ptr<Answer>> answers = std::exchange(results_[index], {});
    if (std::ranges::all_of(answers, [](const auto& answer) { return answer->is_kept; })) {
      ShelvedCase kept = earlier_->whole(answered.id, shelf_);
      CaseResults one = kept.whole();
      read_and_judge(one);
      kept.outline = outline_of(one);  // the rest was judged in the same way before
      shelved_[index].emplace(std::move(kept));
      tell(one);
      return;
    }
    CaseResults one = describe(answered);
    describe_exact(index, answered, one);
    comparison_.forget(index);
    one.results.reserve(infos_.size());
    for (std::size_t r = 0; r < infos_.size(); ++r)
      one.results.push_back(answers[r]->is_kept ? earlier_->result(answered.id, r)
                                                : std::move(answers[r]->result));
    try {
      shelve(index, one);
    } catch (const ShelfError&) {
      throw;
    } catch (const std::exception& error) {
      // Its results are too large, for instance: they alone are lost.
      for (Result& result : one.results)
        if (!result.failure) result = not_run(internal_failure(one.id, error));
      shelve(index, one);
    }
  }

  void shelve(std::size_t index, CaseResults& one) {
    judge_alone(one, options_.policy.latitude);
    shelved_[index].emplace(one, shelf_);
    readers_.add(one);
    tell(one);
  }

  // Tells whoever wants to know that the case is finished.
  void tell(const CaseResults& one) {
    if (options_.finished == nullptr) return;
    const std::lock_guard telling(telling_);
    std::optional<Results> known;
    {
      const std::lock_guard lock(mutex_);
      if (std::exchange(is_more_known_, false)) known = what_is_known();
    }
    if (known) options_.finished->begin(*known);
    options_.finished->add(one);
  }

  // While it is at hand.
  void read_and_judge(CaseResults& one) {
    readers_.add(one);
    judge_alone(one, options_.policy.latitude);
  }

  CaseResults describe(const Case& one) {
    CaseResults result;
    result.id = one.id;
    result.title = one.title;
    result.why = one.why;
    result.rules = one.rules;
    result.spec = one.spec;
    result.origin = one.origin;
    result.tags = one.tags;
    result.file = one.file.generic_string();
    result.file_digest = digest_of_source(one);
    result.surface = name_of(one.scene.target.surface);
    result.width = one.scene.target.width;
    result.height = one.scene.target.height;
    const Viewport& seen = one.scene.viewport;
    if (std::tuple(seen.x, seen.y, seen.width, seen.height) !=
        std::tuple(0, 0, result.width, result.height))
      result.viewport = seen;
    result.figure = scene_figure(one.scene);
    return result;
  }

  // What exact makes of a case. Where it fails, each answer that was held against it says so.
  void describe_exact(std::size_t index, const Case& one, CaseResults& result) {
    try {
      const ExactSide& side = comparison_.exact(index, one.scene);
      const Rendering& exact = side.rendering;
      result.pixels = side.pixels;
      result.samples = side.samples;
      result.fragments = exact.fragments.size();
      for (const Rendering& pass : exact.passes) result.fragments += pass.fragments.size();
      result.expect_failures = unmet_drawings(one, options_.policy.name, exact);
    } catch (const std::exception& error) {
      result.expect_failures = {internal_failure(one.id, error).reason};
    }
  }

  CaseList take_complete_cases() {
    std::vector<ShelvedCase> complete;
    complete.reserve(shelved_.size());
    for (; !shelved_.empty(); shelved_.pop_front())
      if (shelved_.front()) complete.push_back(std::move(*shelved_.front()));
    return CaseList(std::move(complete));
  }

  // The results without their cases.
  Results what_is_known() const {
    Results results;
    results.policy = options_.policy.name;
    results.latitude = options_.policy.latitude;
    results.policy_digest = digest_of(options_.policy, options_.profiles, infos_);
    results.renderers = infos_;
    results.diagnostics = suite_.diagnostics;
    results.shard = suite_.share;
    return results;
  }

  CompletedRun collect() {
    Results results = what_is_known();
    results.cases = take_complete_cases();
    results.left_out = suite_.cases.size() - results.cases.size();
    results.interrupted = results.left_out > 0;
    judge_rest(results, readers_.readings());
    return {std::move(results), std::move(durations_), kept_};
  }

  const Suite& suite_;
  const RunOptions& options_;
  CaseComparison comparison_;
  AnswerDigests digests_;
  std::optional<EarlierAnswers> earlier_;
  std::vector<RendererInfo> infos_;
  // By case, then renderer, of cases that not all have answered.
  std::vector<std::vector<std::unique_ptr<Answer>>> results_;
  std::vector<std::atomic<std::size_t>> unanswered_;  // by case: renderers
  std::deque<std::optional<ShelvedCase>> shelved_;    // cases that all have answered
  RunReaders readers_;                                // of these
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  std::atomic<std::size_t> done_ = 0;
  std::atomic<std::size_t> kept_ = 0;  // answers
  std::atomic<bool> enough_ = false;   // cases are unexpected
  bool is_finishing_ = false;          // what was begun before that
  std::set<std::size_t> unexpected_;   // cases, where their number matters
  Durations durations_;
  bool is_more_known_ = true;  // of the renderers than was told
  std::mutex mutex_;
  std::mutex telling_;
};

}  // namespace

CompletedRun run_suite(const Suite& suite, const RunOptions& options) {
  return Run(suite, options)();
}

}  // namespace edgecase
