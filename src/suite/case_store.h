// SPDX-License-Identifier: MIT
//
// The cases of a suite, on a shelf (results/shelf.h) until they are drawn. Only their ids and
// weights stay in memory.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "model/case.h"
#include "results/case_list.h"

namespace edgecase {

// A list of cases as values: reading one makes a copy. It shares its file's text and its textures
// with the cases that are read next to it. Several threads may read.
class CaseStore {
 public:
  CaseStore();
  CaseStore(std::vector<Case> cases);  // NOLINT: a list of cases is one
  CaseStore(std::initializer_list<Case> cases);

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  // Const, because assigning to the copy would change nothing here. Throws a ShelfError if the
  // shelf cannot be read.
  const Case whole(std::size_t index) const;                               // NOLINT
  const Case operator[](std::size_t index) const { return whole(index); }  // NOLINT
  auto begin() const { return ListIterator<CaseStore, &CaseStore::whole>(*this, 0); }
  auto end() const { return ListIterator<CaseStore, &CaseStore::whole>(*this, size()); }
  std::vector<Case> all() const;

  const std::string& id(std::size_t index) const { return entries_[index].id; }
  // The number of the target's samples, times the passes of a supersampled one, plus 256.
  std::size_t weight(std::size_t index) const { return entries_[index].weight; }

  // Throws a ShelfError if the shelf has no room.
  void push_back(Case one);
  void sort_by_id();
  // Keeps the cases at `index`, `index` + `count` and so on: an even sample.
  void keep_sample(std::size_t index, std::size_t count);

 private:
  struct Entry {
    std::string id;
    std::size_t weight = 0;
    Shelf::Place place;
  };
  class Shelves;

  std::vector<Entry> entries_;
  std::shared_ptr<Shelves> shelves_;
};

// Cuts a suite's cases into slices of about the same cost; a thread takes one at a time.

// The cases of a slice: [begin, end).
struct CaseSlice {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct SliceLimits {
  std::size_t weight = 0;                                       // CaseStore::weight, in all
  std::size_t cases = std::numeric_limits<std::size_t>::max();  // at least 1
};

// Slices in the order of the cases. Each keeps the limits, or is one case that exceeds them. Empty
// without cases.
std::vector<CaseSlice> cut_cases(const CaseStore& cases, SliceLimits most);

}  // namespace edgecase
