// SPDX-License-Identifier: MIT
#include "rules/portrait.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "rules/hypotheses.h"

namespace edgecase {
namespace {

using Counts = std::map<std::uint16_t, std::size_t>;

constexpr std::size_t kFewest = 5;     // answers: fewer fit by chance
constexpr std::size_t kFewestAll = 3;  // where one part explains all of them

std::size_t count_of(const Counts& counts, std::uint16_t number) {
  const auto found = counts.find(number);
  return found == counts.end() ? 0 : found->second;
}

int parts_of(std::uint16_t number) {
  return is_about_colors(number) ? 1 : CoverageHypothesis::of(number).parts();
}

// Drivers differ rarely, and then what explains a few differences does so by chance.
bool is_enough(std::size_t explained, std::size_t asked, std::size_t ran) {
  if (explained < kFewest) return explained >= kFewestAll && explained == asked;
  return 10 * explained >= 9 * asked || (4 * asked >= ran && 3 * explained >= asked);
}

// `mark`: of the answers that were asked. `ran`: all that are renderings.
std::optional<Portrait::Finding> best_of(const Counts& counts, std::uint16_t mark,
                                         std::size_t ran) {
  const std::size_t asked = count_of(counts, mark);
  const auto is_candidate = [&](std::uint16_t number) {
    return number < kAskedOfCoverage && is_about_colors(number) == (mark == kAskedOfColors) &&
           is_fault(number);
  };
  std::size_t most = 0;
  for (const auto& [number, count] : counts)
    if (is_candidate(number)) most = std::max(most, count);
  if (!is_enough(most, asked, ran)) return std::nullopt;
  const std::size_t by_one = mark == kAskedOfCoverage ? count_of(counts, kHasOneCause) : 0;
  if (10 * by_one >= 9 * asked && by_one > most) return std::nullopt;
  std::optional<Portrait::Finding> best;
  const auto rank = [](const Portrait::Finding& finding) {
    return std::tuple(parts_of(finding.hypothesis), -static_cast<std::ptrdiff_t>(finding.answers),
                      finding.hypothesis);
  };
  for (const auto& [number, count] : counts) {
    if (!is_candidate(number) || 20 * count < 19 * most) continue;
    const Portrait::Finding finding{number, count, asked};
    if (!best || rank(finding) < rank(*best)) best = finding;
  }
  if (best && most < kFewest && parts_of(best->hypothesis) > 1) return std::nullopt;
  return best;
}

bool holds(const std::optional<Portrait::Finding>& finding, const ResultOutline& answer) {
  return finding && std::ranges::any_of(answer.hypotheses, [&](const NumberRun& run) {
           return run.first <= finding->hypothesis && finding->hypothesis <= run.last;
         });
}

std::string sentence_of(const Portrait::Finding& finding, const char* what) {
  return fmt::format("It {}: that explains {} of the {} answers that {}.",
                     meaning_of_hypothesis(finding.hypothesis), finding.answers, finding.asked,
                     what);
}

}  // namespace

std::string Portrait::cause_of(const ResultOutline& answer) const {
  if (!is_unexpected(answer.standing)) return "";
  for (const auto& finding : {coverage, colors})
    if (holds(finding, answer)) return meaning_of_hypothesis(finding->hypothesis);
  return "";
}

void PortraitGatherer::add(const ResultOutline& answer) {
  if (!answer.failure) ++ran_;
  if (!is_unexpected(answer.standing)) return;
  for (const NumberRun& run : answer.hypotheses) {
    ++steps_[run.first];
    --steps_[run.last + 1];
  }
}

Portrait PortraitGatherer::portrait() const {
  Counts counts;
  std::ptrdiff_t count = 0;
  for (auto step = steps_.begin(); step != steps_.end(); ++step) {
    count += step->second;
    const auto next = std::next(step);
    for (int number = step->first; count > 0 && number < next->first; ++number)
      counts[static_cast<std::uint16_t>(number)] = static_cast<std::size_t>(count);
  }
  return {best_of(counts, kAskedOfCoverage, ran_), best_of(counts, kAskedOfColors, ran_)};
}

std::vector<std::string> sentences_of(const Portrait& portrait) {
  std::vector<std::string> sentences;
  if (portrait.coverage)
    sentences.push_back(sentence_of(*portrait.coverage, "cover something else"));
  if (portrait.colors)
    sentences.push_back(sentence_of(*portrait.colors, "cover what they should in other colours"));
  return sentences;
}

}  // namespace edgecase
