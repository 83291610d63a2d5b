// SPDX-License-Identifier: MIT
//
// A find as a case file: what is found joins the suite by being saved into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/case.h"
#include "search/find.h"

namespace edgecase {

constexpr std::size_t kMostTitle = 200;  // bytes of the title of a case that was found

// What a renderer is called or says, as a case file may hold it: a line, 500 bytes of it at most.
std::string words_for_file(const std::string& words);

struct FindFile {
  std::string name;  // "line.diamond-exit-1f2e3d4c.json": the rule, and a hash of title and scene
  std::string text;  // empty exactly when there are diagnostics
  std::vector<Diagnostic> diagnostics;  // what a case file cannot say
};

// The find with its title, why it is one, what every renderer that was asked draws of it, where it
// came from, and its family as a tag. `schema`: relative path from the file to case.schema.json, or
// empty. The same find gives the same file.
FindFile find_file(const Find& find, std::uint64_t seed, const std::string& schema);

}  // namespace edgecase
