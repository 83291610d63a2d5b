// SPDX-License-Identifier: MIT
//
// Durations: how long each renderer took for each case.
//
// They differ from run to run, so they are not part of results but have a file of their own: a line
// of JSON for each case, {"case": ID, "seconds": {RENDERER: number}}, in the order of ids.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <variant>

namespace edgecase {

// Id of a case -> name of a renderer -> seconds, without the comparison. The start of a process
// counts for its first case.
using Durations = std::map<std::string, std::map<std::string, double>>;

// The caller checks the stream's state afterwards.
void write_durations(const Durations& durations, std::ostream& out);

// Otherwise a sentence that says what is wrong, where, and what to do.
std::variant<Durations, std::string> read_durations(std::istream& in);

// 0 if unknown.
double seconds_of(const Durations& durations, const std::string& id, const std::string& renderer);

}  // namespace edgecase
