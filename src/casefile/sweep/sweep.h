// SPDX-License-Identifier: MIT
//
// Sweeps: one case file that stands for many cases.
//
// An axis has a name, some values, and pointers to what takes them; "set" puts a value there,
// "add_to" adds it to the number that the file gives. Axes multiply, except those of one zip group,
// which run side by side. A combination chooses a value for every axis; put into the file's tree,
// it makes a case file of its own, which the ordinary reader then reads and checks.
//
// A value's name is what ids, "base" and "when" call it: a number's canonical decimal (of a float32
// number that is no multiple of 2^-16, the shortest), a word, true or false, and "#" with its index
// from 0 for points and colours.
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

constexpr std::size_t kMaxCases = 4096;  // of a file, and values of an axis
constexpr int kMaxSwept = 16384;         // largest magnitude of a number that is added

struct AxisValue {
  std::string name;
  JsonNode node;  // what "set" puts in
  Fixed amount;   // what "add_to" adds
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
  std::optional<std::size_t> base;  // as the file says; base_of tells what holds
  std::string zip;                  // name of the group, or empty
};

// Which value of every axis, by index.
using Combination = std::vector<std::size_t>;

struct Sweep {
  std::vector<SweepAxis> axes;
  // Axes that run together, by index: a zip group, or one axis alone. In the order of the file.
  std::vector<std::vector<std::size_t>> groups;
};

// Reads "sweep". Pointers are followed only later, by substitute.
Sweep read_sweep(const Place& place, Findings& findings);

// A value, as "base" and "when" write it: the index of the axis's value, or none and a finding.
std::optional<std::size_t> read_value_of(const Place& place, const SweepAxis& axis,
                                         Findings& findings);

// Is it a name of an axis or a zip group: a-z first, then a-z, 0-9 and '-'?
bool is_axis_name(std::string_view name);

// How many combinations there are; beyond 2^32 only that there are more.
std::size_t count_combinations(const Sweep& sweep);

// All of them, the last axis running fastest. A sweep without axes has one, which is empty.
std::vector<Combination> all_combinations(const Sweep& sweep);

// That of the base case.
Combination base_of(const Sweep& sweep);

// "dx=0.5", "dy=1": one part of an id for every axis, in the order of the file.
std::vector<std::string> parts_of(const Sweep& sweep, const Combination& combination);

// Puts the values of a combination into the file's tree: all "set" first, outer places before inner
// ones, then all "add_to". Places keep the lines of the file.
void substitute(const Sweep& sweep, const Combination& combination, JsonNode& root,
                Findings& findings);

// Reads the values of a sweep's axis in the three forms that a file may give them.
//
// Numbers are exact numerals of magnitude 16384 at most, or, in a list of values that are set,
// float32 numbers of magnitude 2^64 at most; what they may be where they go is checked by the
// reader of that place. The same holds for words, colours and points.

// [value, ...]: numbers, and unless they are added, words, true, false and colours, none twice.
std::vector<AxisValue> read_values(const Place& place, bool numbers_only, Findings& findings);

// {"from", "to", "step"}: from, from + step, and so on, as long as it is not above to.
std::vector<AxisValue> read_range(const Place& place, Findings& findings);

// [vertex, ...]: arrays or objects, none twice.
std::vector<AxisValue> read_points(const Place& place, Findings& findings);

// The definitions of axes and of what runs through them in the schema.
Pieces sweep_schemas();

}  // namespace edgecase
