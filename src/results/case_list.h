// SPDX-License-Identifier: MIT
//
// The cases of results. Outlines stay in memory; everything else is on a shelf (results/shelf.h)
// and is read on demand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/packed_words.h"
#include "base/shared.h"
#include "model/figure.h"
#include "model/result.h"
#include "model/sample_image.h"
#include "model/scene.h"
#include "results/shelf.h"

namespace edgecase {

// One case with the results of all renderers, in the order of Results::renderers.
struct CaseResults {
  std::string id;
  std::string title;
  std::string why;
  std::vector<std::string> rules;
  std::string spec;
  std::string origin;
  std::vector<std::string> tags;
  std::string file;         // path of the case file, as given
  std::string file_digest;  // of the file's text (model/text.h)
  std::string surface;
  int width = 0;
  int height = 0;
  std::optional<Viewport> viewport;          // if it is not the target's rectangle
  Shared<PackedWords> pixels;                // of the exact side, RGBA8, bottom row first
  SampleImage samples;                       // of the exact side, if it is multisampled
  std::size_t fragments = 0;                 // of the exact side
  Figure figure;                             // the case's primitives and vertices
  std::vector<std::string> expect_failures;  // hand-drawn truths that exact does not meet
  std::vector<Result> results;
};

// The part of a case that stays in memory.
struct CaseOutline {
  std::string id;
  std::string surface;
  std::size_t expect_failures = 0;     // hand-drawn truths that exact does not meet
  bool has_ramp = false;               // some answer has (Result::ramp)
  bool depends_on_run = false;         // some answer does (model/result.h)
  bool shows_things = false;           // some answer does (Result::shown)
  std::vector<ResultOutline> answers;  // by renderer
};

CaseOutline outline_of(const CaseResults& one);

// False if every renderer agrees, as expected, so that there is nothing to show.
bool has_details(const CaseOutline& one);

// A case that is on a shelf.
class ShelvedCase {
 public:
  // Throws what Shelf::put throws.
  ShelvedCase(const CaseResults& one, std::shared_ptr<Shelf> shelf);

  // The stored case, with the present answers of the outline. Throws what Shelf::at throws.
  CaseResults whole() const;
  // The case from its id to its viewport, and where that lies. Cases of a file mostly share it, so
  // that one place mostly has all of them.
  CaseResults head() const;
  std::pair<const Shelf*, std::uint64_t> head_place() const { return {shelf_.get(), head_.begin}; }
  // The approximate memory of whole(), bytes.
  std::size_t bytes() const { return bytes_; }

  CaseOutline outline;

 private:
  std::shared_ptr<Shelf> shelf_;
  Shelf::Place head_;
  Shelf::Place place_;
  std::size_t bytes_ = 0;
};

// Iterates over a list by its function that reads one element.
template <class List, auto kRead>
class ListIterator {
 public:
  using difference_type = std::ptrdiff_t;
  using value_type =
      std::remove_cvref_t<std::invoke_result_t<decltype(kRead), const List&, std::size_t>>;
  using iterator_concept = std::input_iterator_tag;

  ListIterator() = default;
  ListIterator(const List& list, std::size_t index) : list_(&list), index_(index) {}
  decltype(auto) operator*() const { return (list_->*kRead)(index_); }
  ListIterator& operator++() {
    ++index_;
    return *this;
  }
  void operator++(int) { ++index_; }
  friend bool operator==(const ListIterator&, const ListIterator&) = default;

 private:
  const List* list_ = nullptr;
  std::size_t index_ = 0;
};

// A list of cases as values: reading one makes a copy. Several threads may read, and each replace
// another case.
class CaseList {
 public:
  CaseList() = default;
  explicit CaseList(std::vector<ShelvedCase> cases) : cases_(std::move(cases)) {}

  std::size_t size() const { return cases_.size(); }
  bool empty() const { return cases_.empty(); }
  // Const, because assigning to the copy would change nothing here.
  const CaseResults whole(std::size_t index) const { return cases_[index].whole(); }  // NOLINT
  const CaseResults operator[](std::size_t index) const { return whole(index); }      // NOLINT
  auto begin() const { return ListIterator<CaseList, &CaseList::whole>(*this, 0); }
  auto end() const { return ListIterator<CaseList, &CaseList::whole>(*this, size()); }

  // Shares the shelf: nothing is read.
  const ShelvedCase& shelved(std::size_t index) const { return cases_[index]; }
  const CaseOutline& outline(std::size_t index) const { return cases_[index].outline; }
  ResultOutline& answer(std::size_t index, std::size_t renderer) {
    return cases_[index].outline.answers[renderer];
  }
  // The index of a case by its id, or nothing.
  std::optional<std::size_t> find(const std::string& id) const;

  void push_back(const CaseResults& one) { cases_.emplace_back(one, own_shelf()); }
  void push_back(ShelvedCase one) { cases_.push_back(std::move(one)); }
  void replace(std::size_t index, const CaseResults& one) {
    cases_[index] = ShelvedCase(one, own_shelf());
  }
  // Replaces a case: `change` gets a copy of it to modify.
  template <class Change>
  void change(std::size_t index, const Change& change) {
    CaseResults one = cases_[index].whole();
    change(one);
    replace(index, one);
  }
  // Adds the cases of another list; all are then sorted by id.
  void merge(CaseList other);
  // Removes each case for whose outline `is_unwanted` is true.
  template <class Unwanted>
  void erase_if(const Unwanted& is_unwanted) {
    std::erase_if(cases_, [&](const ShelvedCase& one) { return is_unwanted(one.outline); });
  }

  // The approximate memory of a case that is read, bytes: for make_in_order (base/threads.h).
  std::size_t bytes(std::size_t index) const { return cases_[index].bytes(); }
  // The outlines of all, in their order.
  struct Outlines {
    const CaseList& list;
    auto begin() const { return ListIterator<CaseList, &CaseList::outline>(list, 0); }
    auto end() const { return ListIterator<CaseList, &CaseList::outline>(list, list.size()); }
  };
  Outlines outlines() const { return {*this}; }

 private:
  const std::shared_ptr<Shelf>& own_shelf();

  std::vector<ShelvedCase> cases_;
  std::shared_ptr<Shelf> shelf_;  // of what is added here
};

}  // namespace edgecase
