// SPDX-License-Identifier: MIT
//
// Annotations for GitHub Actions: workflow commands that show on the case files of a pull request.
//
//   ::error file=cases/…,line=1,title=…::what failed, and why
//   ::warning file=cases/…,line=1,title=…::what is contested, and why
//
// There is one error per case file with a failing test (reports/test_outcomes.h), and one warning
// per file with something contested and tolerated. Only the ten heaviest are written, since GitHub
// silently drops all beyond ten of a step; a notice gives the number of the others. Errors come
// before warnings. The worse verdict is heavier, then the larger number of such tests, then the
// larger number of disagreements; ties are ordered by path. Faults of the whole run come first.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "results/results.h"

namespace edgecase {

// Maps a case file's path in the results to its path in the repository.
using PathInRepository = std::function<std::string(const std::string& file)>;

// Writes one line per annotation. Texts are cut to about 1,500 bytes and escaped, so that no text
// ends its command or begins another. The caller checks the stream's state afterwards.
void write_annotations(const Results& results, const PathInRepository& path_of, std::ostream& out);

}  // namespace edgecase
