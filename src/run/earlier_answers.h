// SPDX-License-Identifier: MIT
//
// Answers that an earlier run has compared. Most answers of most runs are, to the bit, what they
// were in the run before: what was found of them then is still right, and costs nothing to find.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "results/results.h"

namespace edgecase {

// Safe to use from several threads.
class EarlierAnswers {
 public:
  // `earlier` must live as long. `renderers`: the names of those of the present run, in order.
  EarlierAnswers(const Results& earlier, const std::vector<std::string>& renderers);

  // True if the renderer at `renderer` gave the case `id` an answer with this digest
  // (run/answer_digest.h) and everything is known that was found of it. It is not of flakes, and of
  // cases where all agree only if no other renderer is asked, since results have no pictures of
  // these.
  bool has(const std::string& id, std::size_t renderer, std::uint64_t digest) const;

  // For cases that has() has found: what was found of the answer, or of the answers of all
  // renderers of the present run, to be judged anew.
  Result result(const std::string& id, std::size_t renderer) const;
  ShelvedCase whole(const std::string& id, const std::shared_ptr<Shelf>& shelf) const;

 private:
  const CaseOutline* outline(const std::string& id) const;

  const Results& earlier_;
  std::unordered_map<std::string_view, std::size_t> cases_;  // index by id
  std::vector<std::optional<std::size_t>> renderers_;        // in `earlier`, by present index
  bool same_renderers_ = false;
};

}  // namespace edgecase
