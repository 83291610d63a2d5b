// SPDX-License-Identifier: MIT
//
// Shared: an immutable value with many owners. Each of a sweep's thousands of cases has its file's
// text, and nearly every renderer draws exactly what exact draws.
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

  // If both are equal, they share one object in memory from here on.
  void share_with(const Shared& other) {
    if (*this == other) value_ = other.value_;
  }

  // Whether they share one object in memory. A cheap test: true means equal, false means unknown.
  friend bool is_same_object(const Shared& a, const Shared& b) { return a.value_ == b.value_; }
  friend bool operator==(const Shared& a, const Shared& b) {
    return is_same_object(a, b) || *a == *b;
  }

 private:
  std::shared_ptr<const Value> value_;
};

using SharedText = Shared<std::string>;

}  // namespace edgecase
