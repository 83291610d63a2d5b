// SPDX-License-Identifier: MIT
//
// The errors of values for people: a part of profile_text.
#pragma once

#include <span>
#include <string>

#include "profile/values/value_errors.h"

namespace edgecase {

// A table, a line each; below each line its histogram and its worst scenes. Empty without rows.
std::string value_errors_text(std::span<const ValueErrors> rows);

// "red", …, or what a value that is no colour is called.
const char* component_name(ValueKind kind, int component);

}  // namespace edgecase
