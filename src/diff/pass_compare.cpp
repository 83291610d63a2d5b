// SPDX-License-Identifier: MIT
#include "diff/pass_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diff/accumulated_image.h"
#include "diff/coverage/legality.h"
#include "diff/findings/add_disagreement.h"
#include "rules/coverage/window.h"
#include "rules/rule.h"

namespace edgecase {
namespace {

// Sums up the aggregates of all passes: the number of compared values of each attribute, and its
// differing values by cause.
class PassValues {
 public:
  void add(const std::vector<ValueAggregate>& of_pass) {
    std::map<Attribute, Count> counts;
    for (const ValueAggregate& values : of_pass) {
      // Several causes of one attribute share the same compared values.
      Count& count = counts[attribute_of(values)];
      count = {std::max(count.compared, values.compared),
               std::max(count.components, values.components)};
      merge(values);
    }
    for (const auto& [attribute, count] : counts) {
      Count& total = counts_[attribute];
      total.compared += count.compared;
      total.components += count.components;
    }
  }

  std::vector<ValueAggregate> take() {
    for (ValueAggregate& values : merged_) {
      const Count& total = counts_.at(attribute_of(values));
      // The sum becomes a mean.
      values.mean_ulp /= static_cast<double>(total.components);
      values.compared = total.compared;
      values.components = total.components;
    }
    return std::move(merged_);
  }

 private:
  using Attribute = std::pair<std::string, RuleId>;  // name and rule
  struct Count {
    std::uint64_t compared = 0;
    std::uint64_t components = 0;
  };

  static Attribute attribute_of(const ValueAggregate& values) {
    return {values.attribute, values.rule};
  }

  void merge(const ValueAggregate& values) {
    const double sum = values.mean_ulp * static_cast<double>(values.components);
    const auto known = std::ranges::find_if(merged_, [&](const ValueAggregate& other) {
      return attribute_of(other) == attribute_of(values) && other.ruling == values.ruling &&
             other.cause == values.cause;
    });
    if (known == merged_.end()) {
      merged_.push_back(values);
      merged_.back().mean_ulp = sum;
      return;
    }
    known->mean_ulp += sum;
    if (values.differing.empty()) return;
    if (known->differing.empty() || values.worst_ulp > known->worst_ulp) {
      known->worst = values.worst;
      known->worst_component = values.worst_component;
      known->worst_exact = values.worst_exact;
      known->worst_rendered = values.worst_rendered;
      known->worst_low = values.worst_low;
      known->worst_high = values.worst_high;
      known->worst_ulp = values.worst_ulp;
    }
    known->worst_relative = std::max(known->worst_relative, values.worst_relative);
    known->differing.insert(known->differing.end(), values.differing.begin(),
                            values.differing.end());
    for (const auto& [exponent, count] : values.ulp_histogram)
      known->ulp_histogram[exponent] += count;
  }

  std::vector<ValueAggregate> merged_;
  std::map<Attribute, Count> counts_;
};

class PassComparison {
 public:
  PassComparison(const Scene& scene, Result& result) : scene_(scene), result_(result) {}

  void add(std::size_t k, Result pass) {
    result_.refuted = pass.refuted;
    for (Disagreement& d : pass.disagreements) {
      attribute(k, d);
      add_disagreement(result_, std::move(d));
    }
    for (CountedDisagreements& counted : pass.counted) {
      counted.sample = static_cast<int>(k);
      add_counted(result_, std::move(counted));
    }
    for (Result::Evidence& evidence : pass.evidence) {
      evidence.pass = static_cast<int>(k);
      result_.evidence.push_back(std::move(evidence));
    }
    illegal_snaps_.insert(pass.illegal_line_snaps.begin(), pass.illegal_line_snaps.end());
    values_.add(pass.values);
  }

  void finish() {
    for (const Snap snap : all_snaps())
      if (illegal_snaps_.contains(name_of(snap)))
        result_.illegal_line_snaps.push_back(name_of(snap));
    std::ranges::move(values_.take(), std::back_inserter(result_.values));
  }

 private:
  // Names the pass that the disagreement belongs to, and moves its figure back.
  void attribute(std::size_t k, Disagreement& d) const {
    const Point shift = shift_of(scene_.supersampling[k]);
    d.sample = static_cast<int>(k);
    const std::string moved =
        shift == Point{} ? "" : fmt::format(", the scene moved by {}", format_point(shift));
    d.explanation =
        fmt::format("{}{}: {}", text_of_pass(scene_.supersampling, k), moved, d.explanation);
    const auto [dx, dy] = position_of(shift);
    for (Mark& mark : d.figure.marks) {
      for (auto& [x, y] : mark.points) {
        x -= dx;
        y -= dy;
      }
    }
  }

  const Scene& scene_;
  Result& result_;
  std::set<std::string> illegal_snaps_;
  PassValues values_;
};

}  // namespace

Result compare_passes(const Drawing& drawing, const AlternativeSet& refuted) {
  const auto& [scene, policy, exact, rendered, facts] = drawing;
  Result result;
  result.refuted = refuted;
  PassComparison comparison(scene, result);
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k) {
    const Scene pass = pass_of(scene, k);
    comparison.add(k, compare_drawing({pass, policy, exact.passes[k], rendered.passes[k], facts},
                                      result.refuted));
  }
  comparison.finish();
  compare_accumulated(drawing, result);
  return result;
}

}  // namespace edgecase
