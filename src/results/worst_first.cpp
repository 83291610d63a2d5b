// SPDX-License-Identifier: MIT
#include "results/worst_first.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "base/threads.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// What an answer begins with: with a cause, or without one.
struct Beginning {
  std::size_t renderer = 0;
  Verdict verdict = Verdict::agree;
  std::string cause;
  std::string rule;
  int kind = 0;
  std::string attribute;
  friend auto operator<=>(const Beginning&, const Beginning&) = default;
};

Beginning beginning_of(const Result& result, std::size_t renderer) {
  // The first of the worst.
  const auto worst = std::ranges::max_element(result.disagreements, {}, &Disagreement::legality);
  if (worst != result.disagreements.end()) {
    if (!worst->cause.empty()) return {renderer, result.verdict, text_of(worst->cause), "", 0, ""};
    return {renderer, result.verdict, "", name_of(worst->rule), static_cast<int>(worst->kind), ""};
  }
  const int kind = static_cast<int>(DisagreementKind::value);
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      return {renderer, result.verdict,  text_of(values.cause), name_of(values.rule),
              kind,     values.attribute};
  const std::string failure = result.failure ? name_of(result.failure->kind) : "";
  return {renderer, result.verdict, "", failure, 0, ""};
}

// 0 for the worst.
int rank_of(Verdict verdict) {
  return static_cast<int>(std::ranges::find(kWorstFirst, verdict) - kWorstFirst.begin());
}

}  // namespace

std::vector<const Disagreement*> worst_first(const Result& result) {
  std::vector<const Disagreement*> order;
  for (const Disagreement& d : result.disagreements) order.push_back(&d);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [](const Disagreement* d) { return d->legality; });
  return order;
}

class WorstFirst::Entries {
 public:
  void add(AnswerPlace place, const Result& result) {
    std::size_t& count = counts_[beginning_of(result, place.renderer)];
    ++count;
    sorted_.push_back({place, rank_of(result.verdict), &count});
  }

  std::vector<AnswerPlace> take() {
    std::ranges::stable_sort(sorted_, [](const Sorted& a, const Sorted& b) {
      return std::tuple(a.rank, *b.alike) < std::tuple(b.rank, *a.alike);
    });
    std::vector<AnswerPlace> places;
    for (const Sorted& one : sorted_) places.push_back(one.place);
    return places;
  }

 private:
  struct Sorted {
    AnswerPlace place;
    int rank = 0;
    const std::size_t* alike = nullptr;
  };
  std::map<Beginning, std::size_t> counts_;
  std::vector<Sorted> sorted_;
};

WorstFirst::WorstFirst() : entries_(std::make_unique<Entries>()) {}
WorstFirst::~WorstFirst() = default;

void WorstFirst::add(AnswerPlace place, const Result& result) {
  entries_->add(place, result);
}

std::vector<AnswerPlace> WorstFirst::take() {
  return entries_->take();
}

std::vector<AnswerPlace> worst_first(const Results& results, const WantedAnswer& is_wanted) {
  WorstFirst order;
  const auto case_of = [&](std::size_t i) {
    std::optional<CaseResults> one;
    if (std::ranges::any_of(results.cases.outline(i).answers, is_wanted)) one = results.cases[i];
    return one;
  };
  const auto add = [&](std::size_t i, const std::optional<CaseResults>& one) {
    for (std::size_t r = 0; one && r < one->results.size() && r < results.renderers.size(); ++r)
      if (is_wanted(one->results[r])) order.add({i, r}, one->results[r]);
  };
  make_in_order(results.cases.size(), case_of, add,
                [&](std::size_t i) { return results.cases.bytes(i); });
  return order.take();
}

}  // namespace edgecase
