// SPDX-License-Identifier: MIT
//
// The JSON schema of case files, for editors to help and check (draft 2020-12): the parts of all
// nouns, each made beside its reader, within the root.
#pragma once

#include <string>

namespace edgecase {

// The text of cases/case.schema.json.
std::string case_schema();

}  // namespace edgecase
