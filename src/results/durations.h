// SPDX-License-Identifier: MIT
//
// Durations: how long each renderer took for each case.
//
// They are never the same twice, and so no part of results: a file of its own holds them, a line of
// JSON for each case, {"case": ID, "seconds": {RENDERER: number}}, in the order of their ids.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <variant>

namespace edgecase {

// Id of a case -> name of a renderer -> seconds, comparing not included. Of cases that share the
// start of a process, the first has it.
using Durations = std::map<std::string, std::map<std::string, double>>;

// The caller checks the stream's state afterwards.
void write_durations(const Durations& durations, std::ostream& out);

// Otherwise a sentence that says what is wrong, where, and what to do.
std::variant<Durations, std::string> read_durations(std::istream& in);

// 0 where it is not known.
double seconds_of(const Durations& durations, const std::string& id, const std::string& renderer);

}  // namespace edgecase
