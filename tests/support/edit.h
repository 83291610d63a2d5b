// SPDX-License-Identifier: MIT
//
// Lists of cases for tests: made of vectors, and changed in place.
#pragma once

#include <cstddef>
#include <vector>

#include "results/case_list.h"

namespace edgecase {

inline CaseList list_of(const std::vector<CaseResults>& cases) {
  CaseList list;
  for (const CaseResults& one : cases) list.push_back(one);
  return list;
}

// A case of a list that is changed: what it has become is in the list when this is gone.
class CaseEdit {
 public:
  CaseEdit(CaseList& cases, std::size_t index) : cases_(cases), index_(index), one_(cases[index]) {}
  CaseEdit(const CaseEdit&) = delete;
  CaseEdit& operator=(const CaseEdit&) = delete;
  ~CaseEdit() { cases_.replace(index_, one_); }

  CaseResults* operator->() { return &one_; }
  CaseResults& operator*() { return one_; }

 private:
  CaseList& cases_;
  std::size_t index_;
  CaseResults one_;
};

// For one statement: edit(results.cases, 0)->title = "A line".
inline CaseEdit edit(CaseList& cases, std::size_t index) {
  return {cases, index};
}

template <class Change>
void edit_each(CaseList& cases, const Change& change) {
  for (std::size_t i = 0; i < cases.size(); ++i) cases.change(i, change);
}

}  // namespace edgecase
