// SPDX-License-Identifier: MIT
//
// Text for the terminal, with or without colour.
#pragma once

#include <fmt/color.h>
#include <fmt/format.h>

#include <string>

#include "model/verdict.h"
#include "reports/verdict_looks.h"

namespace edgecase {

// Padding belongs inside the painted text, so that columns line up with and without colour.
class Painter {
 public:
  explicit Painter(bool color) : color_(color) {}
  std::string operator()(fmt::text_style style, const std::string& text) const {
    return color_ ? fmt::format(style, "{}", text) : text;
  }
  std::string bold(const std::string& text) const { return (*this)(fmt::emphasis::bold, text); }

 private:
  bool color_;
};

inline fmt::text_style style_of(Verdict verdict) {
  return look_of(verdict).terminal;
}

}  // namespace edgecase
