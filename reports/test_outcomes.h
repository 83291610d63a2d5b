// SPDX-License-Identifier: MIT
//
// A run as tests, as CI systems know them: what JUnit XML, CTRF and annotations tell of it.
//
// One suite per renderer and in it one test per case, named by the case's id. A result that stands
// as expected or is known passes, whatever its verdict; one that is contested passes with a
// message; everything else is a failure, and a renderer that did not answer is an error. Those with
// something to tell come first, the worst before the others (results/worst_first.h). `skipped` says
// one thing only: not run, and not supported or known not to run. Case files that could not be
// loaded, hand-drawn truths that exact does not meet, known faults that have grown, and a run that
// was stopped have suites of their own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/durations.h"
#include "results/results.h"

namespace edgecase {

enum class TestStatus { passed, skipped, failed, error };

struct TestOutcome {
  // From the outermost suite: the renderer and the folders of the id. Never empty.
  std::vector<std::string> suite;
  std::string name;  // unique among the tests of suite.front(): no consumer merges two
  TestStatus status = TestStatus::passed;
  // One line; empty exactly where the test passed with nothing to tell.
  std::string message;
  std::string details;               // lines, each with its end, that say why; may be empty
  std::string file;                  // path of the case file, as given; empty where there is none
  int line = 0;                      // in the file, from 1; 0: the file as a whole
  const CaseResults* one = nullptr;  // of a renderer's answer
  const Result* result = nullptr;    // the same
  const RendererInfo* renderer = nullptr;  // the same
};

// Receives the outcomes suite by suite.
using TestSink = std::function<void(const TestOutcome&)>;

// Every test of the run, in an order that depends on the results alone. Suites, names and messages
// are one_line(), details xml_text(). Details list at most 20 disagreements, and so few, or
// nothing, that all tests together stay below 24 MB of XML, unless their names and messages alone
// take that much: CI systems refuse files beyond 30 MB.
void visit_outcomes(const Results& results, const TestSink& sink);

// How long the answer took; 0 where that is not known, or the outcome is of no answer.
double seconds_of(const TestOutcome& outcome, const Durations& durations);

}  // namespace edgecase
