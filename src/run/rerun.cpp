// SPDX-License-Identifier: MIT
#include "run/rerun.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/threads.h"
#include "diff/findings/patience.h"
#include "diff/judge.h"
#include "run/comparing.h"
#include "run/invariant_renderer.h"
#include "run/judging.h"

namespace edgecase {

NamedCases unexpected_cases(const Results& results) {
  NamedCases named;
  for (const CaseOutline& one : results.cases.outlines())
    if (one.expect_failures > 0 ||
        std::ranges::any_of(one.answers, [](const ResultOutline& answer) {
          return is_unexpected(answer.standing);
        }))
      named.ids.insert(one.id);
  for (const Diagnostic& diagnostic : results.diagnostics) named.files.insert(diagnostic.file);
  return named;
}

namespace {

// Results that one process answers again.
constexpr std::size_t kSlice = 200;

struct Question {
  std::size_t renderer = 0;
  std::size_t index = 0;  // of the case in the suite
  std::size_t place = 0;  // of the case in the results
};

struct Stopped {};

bool is_timeout(const ResultOutline& answer) {
  return answer.failure && answer.failure->kind == FailureKind::timed_out;
}

// Did the renderer at `index` answer any case, be it by a refusal or by garbage?
bool has_answered(const Results& results, std::size_t index) {
  return std::ranges::any_of(results.cases.outlines(), [&](const CaseOutline& one) {
    const auto& failure = one.answers[index].failure;
    return !failure || failure->kind == FailureKind::unsupported ||
           failure->kind == FailureKind::garbage || failure->kind == FailureKind::internal;
  });
}

class Rerun {
 public:
  Rerun(const Suite& suite, const RunOptions& options, Results& results)
      : suite_(suite),
        options_(options),
        results_(results),
        comparison_(suite.cases.size(), options) {}

  RerunCounts operator()() {
    gather();
    // How the run reads what each renderer drew on each surface.
    if (!questions_.empty()) readings_ = read_all(results_.cases);
    const std::size_t slices = (questions_.size() + kSlice - 1) / kSlice;
    run_threads(std::min(slices, static_cast<std::size_t>(options_.jobs)),
                [this](std::size_t) { work(); });
    counts_.stopped = stopped();
    return counts_;
  }

 private:
  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  // A renderer that could not be had at all is not asked for.
  static bool is_asked(const ResultOutline& answer) {
    return is_unexpected(answer.standing) &&
           !(answer.failure && answer.failure->kind == FailureKind::unavailable);
  }

  void gather() {
    std::size_t timeouts = 0;
    for (std::size_t r = 0; r < results_.renderers.size(); ++r) {
      // One that has been silent all the time would have the patience of a start again.
      const bool is_silent = !has_answered(results_, r);
      std::size_t index = 0;
      for (std::size_t place = 0; place < results_.cases.size(); ++place) {
        const CaseOutline& one = results_.cases.outline(place);
        while (suite_.cases.id(index) != one.id) ++index;
        const bool late = is_timeout(one.answers[r]);
        if (!is_asked(one.answers[r]) || (late && is_silent)) continue;
        if (questions_.size() == kMostReruns || (late && timeouts == kMostTimeoutReruns)) {
          ++counts_.not_asked;
          continue;
        }
        if (late) ++timeouts;
        questions_.push_back({r, index, place});
      }
    }
    counts_.asked = questions_.size();
  }

  void work() {
    for (std::size_t begin = next_.fetch_add(kSlice); begin < questions_.size() && !stopped();
         begin = next_.fetch_add(kSlice)) {
      try {
        ask_slice(begin, std::min(begin + kSlice, questions_.size()));
      } catch (const Stopped&) {
        return;
      } catch (const ComparisonStopped&) {
        return;
      }
    }
  }

  // A slice may hold questions to several renderers, one after the other.
  void ask_slice(std::size_t begin, std::size_t end) {
    while (begin < end) {
      std::size_t next = begin;
      while (next < end && questions_[next].renderer == questions_[begin].renderer) ++next;
      ask(std::span(questions_).subspan(begin, next - begin));
      begin = next;
    }
  }

  void ask(std::span<const Question> questions) {
    auto made =
        make_renderer(options_.renderers[questions.front().renderer], options_.renderer_options);
    InvariantRenderer renderer(std::move(std::get<std::unique_ptr<Renderer>>(made)),
                               options_.suggested_images);
    std::vector<Case> cases;
    for (const Question& question : questions) cases.push_back(suite_.cases[question.index]);
    std::vector<Task> tasks;
    for (const Case& one : cases)
      tasks.push_back({one.id, &one.scene, false, options_.invariance || one.invariant});
    renderer.render(tasks, [&](std::size_t i, Outcome outcome) {
      if (stopped()) throw Stopped{};
      take(questions[i], comparison_.compare_outcome(questions[i].index, cases[i],
                                                     std::move(outcome), renderer.info()));
    });
  }

  void take(const Question& question, Result second) const {
    Result* const only = &second;
    judge({&only, 1}, results_.latitude,
          readings_.at({question.renderer, results_.cases.outline(question.place).surface}));
    ResultOutline& first = results_.cases.answer(question.place, question.renderer);
    if (judgement_of(second) != judgement_of(first)) first.again = judgement_of(second);
  }

  const Suite& suite_;
  const RunOptions& options_;
  Results& results_;
  CaseComparison comparison_;
  std::vector<Question> questions_;
  RunReadings readings_;
  RerunCounts counts_;
  std::atomic<std::size_t> next_ = 0;
};

}  // namespace

RerunCounts rerun_unexpected(const Suite& suite, const RunOptions& options, Results& results) {
  return Rerun(suite, options, results)();
}

}  // namespace edgecase
