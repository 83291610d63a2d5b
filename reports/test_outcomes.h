// SPDX-License-Identifier: MIT
//
// A run as tests of a CI system, for JUnit XML, CTRF and annotations.
//
// There is one suite per renderer with one test per case, named by the case's id. An expected or
// known result passes, whatever its verdict; a contested one passes with a message; all others are
// failures, and a missing answer is an error. Tests with a message come first, the worst before the
// others (results/clusters.h). `skipped` means only: not run because not supported, or known not
// to run. Case files that could not be loaded, hand-drawn expectations that exact does not meet,
// known faults that have grown, and interrupted runs have suites of their own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/clusters.h"
#include "results/durations.h"
#include "results/results.h"

namespace edgecase {

enum class TestStatus { passed, skipped, failed, error };

struct TestOutcome {
  // From the outermost suite inward: the renderer, then the folders of the id. Never empty.
  std::vector<std::string> suite;
  std::string name;  // unique among the tests of suite.front(): no consumer merges two
  TestStatus status = TestStatus::passed;
  // One line; empty exactly for passed tests without a message.
  std::string message;
  std::string details;               // lines, each with its end, that say why; may be empty
  std::string file;                  // path of the case file, as given; empty if there is none
  int line = 0;                      // in the file, from 1; 0: the file as a whole
  const CaseResults* one = nullptr;  // of a renderer's answer
  const Result* result = nullptr;    // the same
  const RendererInfo* renderer = nullptr;  // the same
  // What the run has as the cause of an unexpected answer's worst difference; null: nothing
  // differs.
  const Cluster* cluster = nullptr;
};

// Receives the outcomes suite by suite.
using TestSink = std::function<void(const TestOutcome&)>;

// Visits every test of the run, in an order that depends only on the results. Suites, names and
// messages are one_line(), details xml_text(). Details list at most 20 disagreements, or fewer, so
// that all tests together stay below 24 MB of XML unless names and messages alone exceed it: CI
// systems refuse files beyond 30 MB.
void visit_outcomes(const Results& results, const TestSink& sink);

// The duration of the answer; 0 if it is unknown or there is no answer.
double seconds_of(const TestOutcome& outcome, const Durations& durations);

}  // namespace edgecase
