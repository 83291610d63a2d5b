// SPDX-License-Identifier: MIT
//
// Sweeps: one case file that stands for many cases.
//
// An axis has a name, some values, and pointers to their destinations: "set" replaces what is
// there, "add_to" adds to the number in the file. Axes multiply, except those of one zip group,
// which run in parallel. A combination chooses a value for every axis. Substituted into the file's
// tree, it gives a case file, which the ordinary reader then reads and checks.
//
// A value has a name in ids, "base" and "when": a number's canonical decimal (the shortest one for
// a float32 number that is no multiple of 2^-16), a word, true or false, and "#" with an index from
// 0 for points and colours.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/json/json_document.h"
#include "casefile/json/json_layout.h"
#include "exact/fixed.h"

namespace edgecase {

constexpr std::size_t kMaxCases = 4096;  // of a file; also of values of an axis
constexpr int kMaxSwept = 16384;         // largest magnitude of a number that is added

struct AxisValue {
  std::string name;
  JsonNode node;  // the value of "set"
  Fixed amount;   // the addend of "add_to"
};

struct AxisTarget {
  Tokens tokens;
  Place place;  // of the pointer in the file
};

struct SweepAxis {
  std::string name;
  bool adds = false;    // add_to instead of set
  bool points = false;  // values are vertices
  std::vector<AxisTarget> targets;
  std::vector<AxisValue> values;
  std::optional<std::size_t> base;  // as in the file; see base_of
  std::string zip;                  // name of the group, or empty
};

// The index of the value for every axis.
using Combination = std::vector<std::size_t>;

struct Sweep {
  std::vector<SweepAxis> axes;
  // Axes that run together, by index: a zip group, or a single axis. In the order of the file.
  std::vector<std::vector<std::size_t>> groups;
};

// Reads "sweep". Pointers are resolved later, by substitute.
Sweep read_sweep(const Place& place, Findings& findings);

// The index of an axis's value that "base" or "when" refers to; or nothing, and a finding.
std::optional<std::size_t> read_value_of(const Place& place, const SweepAxis& axis,
                                         Findings& findings);

// Whether it can name an axis or a zip group: a-z first, then a-z, 0-9 and '-'.
bool is_axis_name(std::string_view name);

// The number of combinations; any number beyond 2^32 only means that there are more.
std::size_t count_combinations(const Sweep& sweep);

// All combinations, the last axis fastest. A sweep without axes has one, which is empty.
std::vector<Combination> all_combinations(const Sweep& sweep);

// The combination of the base case.
Combination base_of(const Sweep& sweep);

// "dx=0.5", "dy=1": one part of an id for every axis, in the order of the file.
std::vector<std::string> parts_of(const Sweep& sweep, const Combination& combination);

// Substitutes a combination into the file's tree: all "set" first, outer values before inner ones,
// then all "add_to". Values keep the lines of the file.
void substitute(const Sweep& sweep, const Combination& combination, JsonNode& root,
                Findings& findings);

// Reads the values of a sweep's axis, in the three forms of a file.
//
// Numbers are exact numerals of magnitude at most 16384 or, in a list of values to set, float32
// numbers of magnitude at most 2^64. The reader of the destination checks its own range, and
// likewise words, colours and points.

// [value, ...]: distinct numbers and, for "set", words, true, false and colours.
std::vector<AxisValue> read_values(const Place& place, bool numbers_only, Findings& findings);

// {"from", "to", "step"}: from, from + step, and so on, up to `to`.
std::vector<AxisValue> read_range(const Place& place, Findings& findings);

// [vertex, ...]: distinct arrays or objects.
std::vector<AxisValue> read_points(const Place& place, Findings& findings);

// The definitions of axes and their values in the schema.
Pieces sweep_schemas();

}  // namespace edgecase
