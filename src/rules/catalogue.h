// SPDX-License-Identifier: MIT
//
// What rules/all_rules.h puts together: the table of contents, which has every rule, where its
// choice is kept and in what it has a say, and what rulings rest on. Explicit lists: nothing
// registers itself.
//
// Rulings rest on a sentence of the specification, and on who reads it how. Each was held against
// every place of the text that speaks of its subject, and against what the Khronos conformance
// tests (VK-GL-CTS, July 17, 2026) ask there. The text of a ruling stands beside the condition that
// judges by it, in the files of its rule; what the rulings of a folder rest on stands in one file
// of it, by their numbers, so that it can be read and reviewed at one go. Quotations are of at most
// 25 words; "..." marks what is left out.
#pragma once

#include <map>
#include <vector>

#include "rules/rule.h"

namespace edgecase {

// Without what rulings rest on.
std::vector<Rule> table_of_contents();

inline constexpr const char* kLanguageRevision = "GLSL 4.60.8, August 14, 2023";

// By the number of the ruling.
std::map<int, RulingSource> ruling_sources();
// One part for each folder of rules.
void add_coverage_sources(std::map<int, RulingSource>& of);
void add_values_sources(std::map<int, RulingSource>& of);
void add_samples_sources(std::map<int, RulingSource>& of);
void add_textures_sources(std::map<int, RulingSource>& of);
void add_output_sources(std::map<int, RulingSource>& of);

}  // namespace edgecase
