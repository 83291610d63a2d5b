// SPDX-License-Identifier: MIT
//
// SharedText: a text that many hold and none changes. Of a sweep's thousands of cases each has its
// file's.
#pragma once

#include <memory>
#include <string>
#include <utility>

namespace edgecase {

class SharedText {
 public:
  SharedText() = default;
  SharedText(std::string text)  // NOLINT: a text is one
      : text_(std::make_shared<const std::string>(std::move(text))) {}
  SharedText(const char* text) : SharedText(std::string(text)) {}  // NOLINT: as above

  const std::string& str() const {
    static const std::string none;
    return text_ ? *text_ : none;
  }
  bool empty() const { return str().empty(); }

  // Are they one text in memory? Quickly told, and false says nothing.
  friend bool is_same_object(const SharedText& a, const SharedText& b) {
    return a.text_ == b.text_;
  }
  friend bool operator==(const SharedText& a, const SharedText& b) {
    return is_same_object(a, b) || a.str() == b.str();
  }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace edgecase
