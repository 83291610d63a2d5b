// SPDX-License-Identifier: MIT
//
// Lines of a results file that are about cases (results/results_json.h), written and read.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "results/results.h"
#include "results/shallow_json.h"

namespace edgecase {

// Appends the fields that a case shares with others, as a JSON object: the head with this number.
void append_head(const CaseResults& one, std::size_t number, std::string& text);

// Appends the case as a JSON object. `renderers` are those of its results, in that order.
void append_case(const CaseResults& one, std::size_t head,
                 const std::vector<RendererInfo>& renderers, std::string& text);

// False if every renderer agrees, as expected: its line in a list then says everything.
bool has_details(const CaseResults& one);

// The counts of a rendering without any difference.
PixelCounts counts_of_agreement(int width, int height);

// The inverses. All throw std::runtime_error, or what the library throws, for anything else.

// The alternatives of a text of text_of_refuted().
AlternativeSet to_refuted(const ReadJson& json);

// The fields that a case shares with others; all others have their defaults.
CaseResults to_head(const ReadJson& json);

// Heads that cases may name: the last ones of the file.
struct HeadsRead {
  std::size_t first = 0;  // number of the first
  std::vector<std::shared_ptr<const CaseResults>> list;

  // Keeps only the heads of the last head's case file, which are consecutive.
  void keep_last_file();
};

// `renderers` are those of the file, in the order of the results.
CaseResults to_case(const ReadJson& json, const HeadsRead& heads,
                    const std::vector<RendererInfo>& renderers);

}  // namespace edgecase
