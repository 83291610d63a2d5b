// SPDX-License-Identifier: MIT
#include "run/earlier_answers.h"

#include <malloc.h>

#include <algorithm>
#include <utility>

namespace edgecase {
namespace {

// Without what depends on the run: it is judged anew, and so is its standing.
void forget_standing(ResultOutline& answer) {
  ResultOutline kept;
  kept.failure = std::move(answer.failure);
  kept.answer_digest = answer.answer_digest;
  kept.images = answer.images;
  kept.hypotheses = std::move(answer.hypotheses);
  answer = std::move(kept);
}

}  // namespace

EarlierAnswers::EarlierAnswers(const Results& earlier, const std::vector<std::string>& renderers)
    : earlier_(earlier),
      same_renderers_(std::ranges::equal(earlier.renderers, renderers, {}, &RendererInfo::name)) {
  for (const std::string& name : renderers) {
    const auto found = std::ranges::find(earlier.renderers, name, &RendererInfo::name);
    renderers_.emplace_back();
    if (found != earlier.renderers.end())
      renderers_.back() = static_cast<std::size_t>(found - earlier.renderers.begin());
  }
  for (const CaseOutline& one : earlier.cases.outlines()) cases_.emplace(one.id, cases_.size());
  malloc_trim(0);  // reading them took more memory than they do
}

const CaseOutline* EarlierAnswers::outline(const std::string& id) const {
  const auto found = cases_.find(id);
  return found == cases_.end() ? nullptr : &earlier_.cases.outline(found->second);
}

bool EarlierAnswers::has(const std::string& id, std::size_t renderer, std::uint64_t digest) const {
  const CaseOutline* const one = outline(id);
  if (one == nullptr || !renderers_[renderer]) return false;
  const ResultOutline& answer = one->answers[*renderers_[renderer]];
  if (answer.answer_digest != digest || answer.again) return false;
  return renderers_.size() == 1 || has_details(*one);
}

Result EarlierAnswers::result(const std::string& id, std::size_t renderer) const {
  CaseResults one = earlier_.cases.whole(cases_.at(id));
  Result& found = one.results[*renderers_[renderer]];
  forget_standing(found);
  return std::move(found);
}

ShelvedCase EarlierAnswers::whole(const std::string& id,
                                  const std::shared_ptr<Shelf>& shelf) const {
  const std::size_t index = cases_.at(id);
  if (same_renderers_) {
    ShelvedCase shelved = earlier_.cases.shelved(index);
    for (ResultOutline& answer : shelved.outline.answers) forget_standing(answer);
    return shelved;
  }
  CaseResults one = earlier_.cases.whole(index);
  std::vector<Result> results;
  for (std::size_t r = 0; r < renderers_.size(); ++r) results.push_back(result(id, r));
  one.results = std::move(results);
  return {one, shelf};
}

}  // namespace edgecase
