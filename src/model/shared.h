// SPDX-License-Identifier: MIT
//
// Shared: a value that many hold and none changes. Of a sweep's thousands of cases each has its
// file's text, and of a case's renderers nearly each draws what exact draws.
#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <utility>

namespace edgecase {

template <class Value>
class Shared {
 public:
  Shared() = default;
  template <std::convertible_to<Value> From>
  Shared(From&& value)  // NOLINT: a value is one
      : value_(std::make_shared<const Value>(std::forward<From>(value))) {}

  const Value& operator*() const {
    static const Value none{};
    return value_ ? *value_ : none;
  }
  const Value* operator->() const { return &**this; }

  // Both are one in memory from here on, if they are equal.
  void share_with(const Shared& other) {
    if (*this == other) value_ = other.value_;
  }

  // Are they one in memory? Quickly told, and false says nothing.
  friend bool is_same_object(const Shared& a, const Shared& b) { return a.value_ == b.value_; }
  friend bool operator==(const Shared& a, const Shared& b) {
    return is_same_object(a, b) || *a == *b;
  }

 private:
  std::shared_ptr<const Value> value_;
};

using SharedText = Shared<std::string>;

}  // namespace edgecase
