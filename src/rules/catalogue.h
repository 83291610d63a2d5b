// SPDX-License-Identifier: MIT
//
// The parts of which rules/all_rules.h is made: the table of contents, which lists every rule,
// where its choice is kept and what it decides, and the sources of the rulings. These are explicit
// lists: nothing registers itself.
//
// A ruling rests on a sentence of the specification, and on how others read it. Each was compared
// with every passage of the text on its subject, and with the related tests of the Khronos
// conformance suite (VK-GL-CTS, July 17, 2026). The text of a ruling stands beside the condition
// that applies it, in the files of its rule; the sources of a folder's rulings stand in one file,
// by number, so that they can be read and reviewed together. Quotations have at most 25 words;
// "..." marks omissions.
#pragma once

#include <map>
#include <vector>

#include "rules/rule.h"

namespace edgecase {

// The rules without the sources of their rulings.
std::vector<Rule> table_of_contents();

inline constexpr const char* kLanguageRevision = "GLSL 4.60.8, August 14, 2023";

// By number of the ruling.
std::map<int, RulingSource> ruling_sources();
// Adds the sources of one folder of rules.
void add_coverage_sources(std::map<int, RulingSource>& of);
void add_values_sources(std::map<int, RulingSource>& of);
void add_samples_sources(std::map<int, RulingSource>& of);
void add_textures_sources(std::map<int, RulingSource>& of);
void add_output_sources(std::map<int, RulingSource>& of);

}  // namespace edgecase
