// SPDX-License-Identifier: MIT
#include "casefile/word_pieces.h"

#include <utility>
#include <vector>

namespace edgecase {
namespace {

JsonPiece strings(const std::vector<std::string>& words) {
  Pieces items;
  for (const std::string& word : words) items.push_back(json_string(word));
  return json_array(std::move(items));
}

}  // namespace

void add_word(const char* name, const std::string& word, Pieces& members) {
  if (!word.empty()) members.push_back(named(name, json_string(word)));
}

Pieces word_pieces(const CaseWords& words) {
  Pieces members;
  add_word("$schema", words.schema, members);
  members.push_back(named("title", json_string(words.title)));
  add_word("why", words.why, members);
  members.push_back(named("rules", strings(words.rules)));
  add_word("spec", words.spec, members);
  add_word("origin", words.origin, members);
  if (!words.tags.empty()) members.push_back(named("tags", strings(words.tags)));
  return members;
}

}  // namespace edgecase
