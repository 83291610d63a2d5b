// SPDX-License-Identifier: MIT
//
// JUnit XML, for continuous integration.
//
// One test suite per renderer and in it one test case per case, named by the case's id, with the
// renderer and the id's folder as class. A result that stands as expected passes, whatever its
// verdict; everything else is a failure, and a renderer that did not answer is an error.
// `skipped` says one thing only: not run, and known not to run, with the reason. Case files that
// could not be loaded, hand-drawn expectations that exact does not meet, and expectations of cases
// that are no more have suites of their own. No times are written: the same results give the same
// bytes.
#pragma once

#include <iosfwd>

#include "results/results.h"

namespace edgecase {

// Writes the document in UTF-8. The caller checks the stream's state afterwards.
void write_junit(const Results& results, std::ostream& out);

}  // namespace edgecase
