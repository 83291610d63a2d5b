// SPDX-License-Identifier: MIT
//
// The user's word that the programs and libraries which a project's file names may be run.
//
// Such a file comes with a checkout, and takes effect in every folder below it. So a command that
// would run what the file names asks first, on the terminal; elsewhere --trust says it. The word is
// remembered for the file as it is: by a digest of its path and text in the user's private folder.
#pragma once

#include "tools/edgecase/project.h"

namespace edgecase {

// Returns if the word was given: by `is_given`, which is --trust, earlier, or now on the terminal.
// Otherwise throws ProjectError with what would be run, and how to allow it. A word about a file
// that others can write is not remembered.
void require_trust(const Project& project, bool is_given);

}  // namespace edgecase
