// SPDX-License-Identifier: MIT
//
// Lines of a results file that are about cases, read: the inverse of
// results/case_results_writer.h. All throw std::runtime_error, or what the library throws, for
// anything else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "results/results.h"
#include "results/shallow_json.h"

namespace edgecase {

// What a case shares with others; all else is as a new one has it.
CaseResults to_head(const ReadJson& json);

// Heads that cases may name: the last ones of the file.
struct HeadsRead {
  std::size_t first = 0;  // number of the first
  std::vector<std::shared_ptr<const CaseResults>> list;

  // Forgets all but those of the last head's case file, which stand together.
  void keep_last_file();
};

// `renderers` are those of the file, in the order in which results are to stand.
CaseResults to_case(const ReadJson& json, const HeadsRead& heads,
                    const std::vector<RendererInfo>& renderers);

// Throws.
[[noreturn]] void refuse_name(const std::string& text);

// The value whose name_of is the given text, among those from `first` to `last`.
template <class Enum>
Enum to_enum(const std::string& text, Enum first, Enum last) {
  for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i)
    if (text == name_of(static_cast<Enum>(i))) return static_cast<Enum>(i);
  refuse_name(text);
}

}  // namespace edgecase
