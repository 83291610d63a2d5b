// SPDX-License-Identifier: MIT
//
// Annotations for GitHub Actions: workflow commands that show on the case files of a pull request.
//
//   ::error file=cases/a.json,line=1,title=…::what failed, and why
//   ::warning file=cases/b.json,line=1,title=…::what is contested, and why
//
// One error per case file that has a failing test (reports/test_outcomes.h), one warning per file
// with what is contested and tolerated, and the ten heaviest only, since GitHub shows ten of a step
// and drops the others in silence; a notice says how many there are beyond them. Errors come before
// warnings. Heavier is the worse verdict, then more of its tests, then more disagreements; ties go
// by the file's path. What the run as a whole lacks comes first.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "results/results.h"

namespace edgecase {

// Where a case file lies in the repository, of its path as results give it.
using PathInRepository = std::function<std::string(const std::string& file)>;

// Writes a line for each; nothing where no test fails. Texts are cut to some 1,500 bytes, and no
// text can end its command or begin another. The caller checks the stream's state afterwards.
void write_annotations(const Results& results, const PathInRepository& path_of, std::ostream& out);

}  // namespace edgecase
