// SPDX-License-Identifier: MIT
//
// What each verdict looks like, in the terminal and in pages: the one table of it. The report's
// script gets words and shapes with its data (report_index.h); embed_viewer.py reads the colours
// and signs here, line by line, and writes the styles of every page from them.
#pragma once

#include <fmt/color.h>

#include <array>
#include <cstddef>

#include "model/verdict.h"

namespace edgecase {

// A colour as CSS has it, "#rrggbb", on light and on dark pages.
struct PageColor {
  const char* light = "";
  const char* dark = "";
};

// No meaning depends on a colour alone: each verdict has its word (its name) and its shape, too.
struct VerdictLook {
  Verdict verdict;
  const char* meaning;  // a sentence
  const char* icon;     // the path of a line drawing, 16 units wide and high
  const char* sign;     // a character that is like it, as CSS escapes it
  PageColor ink;        // of text, icon and bar
  PageColor ground;     // of a badge
  PageColor heat;       // of pixels; none of what has no picture
  fmt::text_style terminal;
};

// In the order of pages, the worst first. What was not run needs a look before what agrees.
inline constexpr auto kVerdictLooks = std::to_array<VerdictLook>({
    {.verdict = Verdict::violation,
     .meaning = "Something is outside what the specification allows.",
     .icon = "M3.5 3.5l9 9M12.5 3.5l-9 9",
     .sign = "2715",
     .ink = {"#b3123c", "#ff7b98"},
     .ground = {"#b3123c", "#d42a57"},
     .heat = {"#d8123f", "#ff3b64"},
     .terminal = fmt::fg(fmt::terminal_color::red) | fmt::emphasis::bold},
    {.verdict = Verdict::contested,
     .meaning = "The letter of the specification forbids it, and there is good reason to read it "
                "otherwise.",
     .icon = "M5.2 5.8a2.8 2.8 0 1 1 4.2 2.4C8.4 8.8 8 9.3 8 10.2M8 13v.2",
     .sign = "3F",
     .ink = {"#6f2a94", "#d9a8f2"},
     .ground = {"#f1e6f8", "#33214a"},
     .heat = {"#a24fd0", "#b76ae0"},
     .terminal = fmt::fg(fmt::terminal_color::magenta)},
    {.verdict = Verdict::permitted,
     .meaning = "All is allowed, but no catalogued alternative explains some of it.",
     .icon = "M8 2.5 14.2 13.5H1.8z",
     .sign = "25B3",
     .ink = {"#8a5a00", "#f0bc56"},
     .ground = {"#fdf0d2", "#3a2f14"},
     .heat = {"#e0a526", "#e0a526"},
     .terminal = fmt::fg(fmt::terminal_color::yellow)},
    {.verdict = Verdict::convention,
     .meaning = "All is allowed and follows alternatives that the specification leaves open.",
     .icon = "M2 6.4c2-2.6 4-2.2 6-.6s4 2 6-.6M2 11.4c2-2.6 4-2.2 6-.6s4 2 6-.6",
     .sign = "2248",
     .ink = {"#1d56b8", "#8db6ff"},
     .ground = {"#e3edfc", "#1a2c4d"},
     .heat = {"#4f8df0", "#4f8df0"},
     .terminal = fmt::fg(fmt::terminal_color::cyan)},
    {.verdict = Verdict::not_run,
     .meaning = "There is no rendering to compare. Never counted as agreement.",
     .icon = "M8 2.2a5.8 5.8 0 1 0 .01 0zM4 12 12 4",
     .sign = "2298",
     .ink = {"#59606c", "#a6adba"},
     .ground = {"#e8eaee", "#2a2f38"},
     .heat = {},
     .terminal = fmt::emphasis::faint},
    {.verdict = Verdict::agree,
     .meaning = "Nothing differs from the exact rendering under this policy.",
     .icon = "M2.8 8.6 6.5 12.2 13.2 4",
     .sign = "2713",
     .ink = {"#0d6b4f", "#62d3a8"},
     .ground = {"#dff3ea", "#15352a"},
     .heat = {"#b9c4cf", "#4a525e"},
     .terminal = fmt::fg(fmt::terminal_color::green)},
});

static_assert(kVerdictLooks.size() == kValues<Verdict>.size());

constexpr const VerdictLook& look_of(Verdict verdict) {
  std::size_t at = 0;
  while (kVerdictLooks[at].verdict != verdict) ++at;
  return kVerdictLooks[at];
}

}  // namespace edgecase
