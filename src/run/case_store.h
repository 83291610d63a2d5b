// SPDX-License-Identifier: MIT
//
// The cases of a suite, put aside until they are drawn: at hand are their ids and what they weigh.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "model/case.h"
#include "results/case_list.h"

namespace edgecase {

// A list of cases, which are values: what is read of it is a copy. Cases share their file's text
// and their textures with those that are read next to them. Several threads may read.
class CaseStore {
 public:
  CaseStore();
  CaseStore(std::vector<Case> cases);  // NOLINT: a list of cases is one
  CaseStore(std::initializer_list<Case> cases);

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  // Const, so that nobody takes it for a place to write to. Throws a ShelfError where what
  // was put aside cannot be read.
  const Case whole(std::size_t index) const;                               // NOLINT
  const Case operator[](std::size_t index) const { return whole(index); }  // NOLINT
  auto begin() const { return ListIterator<CaseStore, &CaseStore::whole>(*this, 0); }
  auto end() const { return ListIterator<CaseStore, &CaseStore::whole>(*this, size()); }
  std::vector<Case> all() const;

  const std::string& id(std::size_t index) const { return entries_[index].id; }
  // As many as the target has samples, once a pass where it is supersampled, and 256 beside them.
  std::size_t weight(std::size_t index) const { return entries_[index].weight; }

  // Throws a ShelfError where there is no room to put it aside.
  void push_back(Case one);
  void sort_by_id();
  // Keeps the cases at `index`, `index` + `count` and so on.
  void keep_share(std::size_t index, std::size_t count);

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

}  // namespace edgecase
