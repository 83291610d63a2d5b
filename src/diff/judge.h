// SPDX-License-Identifier: MIT
//
// Judge: from compared results to verdicts, over all results of one renderer on one surface.
//
// Three decisions need the whole run. Lines are read with one catalogued snap for all of them: the
// first of those under which most cases are legal (ruling 1). And if several causes reproduce a
// primitive equally well, the likeliest is the one whose alternatives explain most primitives of
// the run and are refuted by fewest cases. For a legal drawing, an alternative that the
// specification leaves open comes before one that it does not, unless the run refutes it and no
// case refutes a fault that explains more. Judging is a function of the results alone, so merged
// shards are judged like the whole run.
//
// And what is one thing for a renderer must be one in all answers (diff/single_things.h).
//
// Disagreements that are only counted (Result::counted) are judged with those in full: all that is
// read here of a disagreement is its class, and evidence is of whole primitives, however many of
// their samples differ. A primitive whose faults are gross may lack a cause of two alternatives
// (CauseQuestion::is_gross), and is then judged no milder.
//
// These form a RunReading. A run can be read once and its reading used to judge any
// result, whether it is one of the run or new.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "diff/single_things.h"
#include "model/policy.h"
#include "model/result.h"
#include "rules/rule_answers.h"

namespace edgecase {

// The findings of a run, by which each of its results is judged.
struct RunReading {
  std::string line_snap = "none";  // the catalogued snap with which lines are read
  // How many primitives of the run an alternative helps to reproduce, alone or with another, less
  // the number of cases that refute it. A missing alternative counts 0.
  std::map<AlternativeId, std::ptrdiff_t> alternatives;
  AlternativeSet refuted;  // alternatives that some case refutes
  // Alternatives by which some primitive was not drawn that another one of their subject explains.
  AlternativeSet missed;
  // GL_SUBPIXEL_BITS as the renderer reports them; 0: unknown. Of precisions that explain as much,
  // this one is taken.
  int subpixel_bits = 0;
  Meetings things;                 // what most answers show of things that are one
  std::vector<RuleAnswers> rules;  // what the answers say of each rule about which they were asked
};

// A choice that the specification leaves open is refuted where it hinders more than it helps, since
// it may be hidden beside another choice, or where another alternative explains what it does not. A
// fault is refuted by one answer.
AlternativeSet refuted_in(const RunReading& reading);

// Reads all results of one renderer on one surface, which compare() has made, one after the other.
// Results without a rendering add nothing. Results that are judged already give the same reading.
class RunReader {
 public:
  // `id`: of the case, for naming what speaks against another answer.
  void add(const Result& result, const std::string& id = {});
  RunReading reading() const;

 private:
  std::map<std::string, std::size_t> legal_;  // by snap: cases whose lines are legal under it
  RunReading reading_;
  RuleAnswersGatherer rules_;
  SingleThings things_;
};

// The same of a list.
RunReading read_run(std::span<Result* const> results);

// Fills legality (of lines, and by the basis of rulings), cause, ruling, verdict and fingerprint of
// every result that ran, under the reading of a run that they need not belong to. Judging twice
// changes nothing.
void judge(std::span<Result* const> results, Latitude latitude, const RunReading& reading);

// Judges results under their own reading. Returns the name of the snap with which lines were read.
std::string judge(std::span<Result* const> results, Latitude latitude);

}  // namespace edgecase
