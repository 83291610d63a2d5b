// SPDX-License-Identifier: MIT
//
// Reads the root of a case file: title and other texts, then what is drawn and on what.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/scene/scene_reader.h"
#include "casefile/scene/textures.h"
#include "model/case.h"

namespace edgecase {

// Whether a name has the form of a rule's id: at least two words joined by dots, of a-z, 0-9 and,
// after the first word, '-': "line.diamond-exit".
bool is_rule_id(std::string_view name);

// The keys of a case file's root.
const Keys& case_keys();

// A case as written, before anything that depends on its id. Places live as long as the tree.
struct CaseFields {
  Case words;  // from title to tags
  TargetFields target;
  Details details;
  TextureList textures;
  std::vector<DrawFields> draws;
  std::optional<Place> draws_place;  // nothing if the file has no draws
};

// Reads a tree. Faults are added to `findings`, and the result is then incomplete. For "sweep",
// "variants" and "expect" only their presence is checked. If the file counts y downwards, the
// result is already converted.
CaseFields read_case_fields(const JsonNode& root, std::span<const std::string> known_rules,
                            MeshShelf& meshes, TextureShelf& textures, Findings& findings);

// The JSON schema of case files, for editors to help and check (draft 2020-12): the parts of all
// nouns, each made beside its reader, within the root.

// The text of cases/case.schema.json.
std::string case_schema();

}  // namespace edgecase
