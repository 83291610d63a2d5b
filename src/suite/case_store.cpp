// SPDX-License-Identifier: MIT
#include "suite/case_store.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <mutex>
#include <utility>

#include "wire/binary.h"

namespace edgecase {

using wire::carry_all;
using wire::Of;

template <class Io, Of<Expect> T>
void carry(Io& io, T& expect) {
  carry_all(io, expect.policy, expect.coverage, expect.masks, expect.where);
}

template <class Io, Of<Shelf::Place> T>
void carry(Io& io, T& place) {
  carry_all(io, place.begin, place.packed, place.unpacked);
}

// All but the id, the file, its text and the textures.
template <class Io, Of<Case> T>
void carry_case(Io& io, T& one) {
  carry_all(io, one.parts, one.title, one.why, one.rules, one.spec, one.origin, one.tags,
            one.invariant, one.scene, one.expect);
}

namespace {

constexpr std::size_t kCaseWeight = 256;

std::size_t weight_of(const Scene& scene) {
  const Target& target = scene.target;
  return kCaseWeight + static_cast<std::size_t>(target.width) *
                           static_cast<std::size_t>(target.height) *
                           static_cast<std::size_t>(target.samples) *
                           std::max<std::size_t>(1, scene.supersampling.size());
}

// Objects that neighbouring cases share, and where each lies: the last few.
template <class Object>
class Recent {
 public:
  template <class IsSame, class Make>
  std::pair<Object, Shelf::Place> find(const IsSame& is_same, const Make& make) {
    constexpr std::size_t kMost = 8;
    const auto found = std::ranges::find_if(last_, is_same);
    if (found != last_.end()) return *found;
    if (last_.size() == kMost) last_.pop_front();
    return last_.emplace_back(make());
  }

 private:
  std::deque<std::pair<Object, Shelf::Place>> last_;
};

using TexturePointer = std::shared_ptr<const Texture>;

}  // namespace

class CaseStore::Shelves {
 public:
  Shelf::Place put(Case one) {
    const std::lock_guard lock(mutex_);
    const std::vector<TexturePointer> textures = std::exchange(one.scene.textures, {});
    std::string bytes;
    wire::Writer io(bytes);
    carry_case(io, one);
    const std::string file = one.file.string();
    carry_all(io, file);
    const Shelf::Place text = text_place(one.source);
    carry(io, text);
    std::vector<Shelf::Place> places;
    for (const TexturePointer& texture : textures) places.push_back(texture_place(texture));
    carry(io, places);
    return shelf_.put(bytes);
  }

  Case take(const Shelf::Place& place) {
    const std::string bytes = shelf_.at(place);
    wire::Reader io(bytes);
    Case one;
    carry_case(io, one);
    std::string file;
    Shelf::Place text;
    std::vector<Shelf::Place> textures;
    carry_all(io, file, text, textures);
    one.file = file;
    const std::lock_guard lock(mutex_);
    one.source = text_at(text);
    for (const Shelf::Place& texture : textures) one.scene.textures.push_back(texture_at(texture));
    return one;
  }

 private:
  static auto lies_at(const Shelf::Place& place) {
    return [&](const auto& known) { return known.second.begin == place.begin; };
  }

  Shelf::Place text_place(const SharedText& text) {
    return texts_
        .find([&](const auto& known) { return is_same_object(known.first, text); },
              [&] { return std::pair(text, shelf_.put(*text)); })
        .second;
  }

  SharedText text_at(const Shelf::Place& place) {
    return texts_
        .find(lies_at(place), [&] { return std::pair(SharedText(shelf_.at(place)), place); })
        .first;
  }

  Shelf::Place texture_place(const TexturePointer& texture) {
    const auto put = [&] {
      std::string bytes;
      wire::Writer io(bytes);
      carry(io, texture);
      return std::pair(texture, shelf_.put(bytes));
    };
    return textures_.find([&](const auto& known) { return known.first == texture; }, put).second;
  }

  TexturePointer texture_at(const Shelf::Place& place) {
    const auto read = [&] {
      const std::string bytes = shelf_.at(place);
      wire::Reader io(bytes);
      TexturePointer texture;
      carry(io, texture);
      return std::pair(std::move(texture), place);
    };
    return textures_.find(lies_at(place), read).first;
  }

  Shelf shelf_;
  std::mutex mutex_;
  Recent<SharedText> texts_;
  Recent<TexturePointer> textures_;
};

CaseStore::CaseStore() : shelves_(std::make_shared<Shelves>()) {}

CaseStore::CaseStore(std::vector<Case> cases) : CaseStore() {
  for (Case& one : cases) push_back(std::move(one));
}

CaseStore::CaseStore(std::initializer_list<Case> cases) : CaseStore(std::vector<Case>(cases)) {}

const Case CaseStore::whole(std::size_t index) const {  // NOLINT
  Case one = shelves_->take(entries_[index].place);
  one.id = entries_[index].id;
  return one;
}

std::vector<Case> CaseStore::all() const {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < size(); ++i) cases.push_back((*this)[i]);
  return cases;
}

void CaseStore::push_back(Case one) {
  const std::size_t weight = weight_of(one.scene);
  Entry entry{one.id, weight, {}};
  entry.place = shelves_->put(std::move(one));
  entries_.push_back(std::move(entry));
}

void CaseStore::sort_by_id() {
  std::ranges::sort(entries_, {}, &Entry::id);
}

void CaseStore::keep_sample(std::size_t index, std::size_t count) {
  std::size_t at = 0;
  std::erase_if(entries_, [&](const Entry&) { return at++ % count != index; });
}

std::vector<CaseSlice> cut_cases(const CaseStore& cases, SliceLimits most) {
  std::vector<CaseSlice> slices;
  std::size_t weight = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t more = cases.weight(i);
    const bool is_full =
        weight + more > most.weight || (!slices.empty() && i - slices.back().begin == most.cases);
    if (slices.empty() || is_full) {
      slices.push_back({i, i});
      weight = 0;
    }
    weight += more;
    slices.back().end = i + 1;
  }
  return slices;
}

}  // namespace edgecase
