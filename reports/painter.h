// SPDX-License-Identifier: MIT
//
// Text for the terminal, with or without colour.
#pragma once

#include <fmt/color.h>
#include <fmt/format.h>

#include <string>

#include "model/verdict.h"

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
  switch (verdict) {
    case Verdict::agree:
      return fmt::fg(fmt::terminal_color::green);
    case Verdict::convention:
      return fmt::fg(fmt::terminal_color::cyan);
    case Verdict::permitted:
      return fmt::fg(fmt::terminal_color::yellow);
    case Verdict::contested:
      return fmt::fg(fmt::terminal_color::magenta);
    case Verdict::violation:
      return fmt::fg(fmt::terminal_color::red) | fmt::emphasis::bold;
    case Verdict::not_run:
      return fmt::emphasis::faint;
  }
  return {};
}

}  // namespace edgecase
