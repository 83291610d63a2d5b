// SPDX-License-Identifier: MIT
//
// Names of a rule's alternatives against the values that they stand for.
#pragma once

#include <gtest/gtest.h>

#include "rules/rule.h"

namespace edgecase {

template <class Enum, class Values>
void expect_names_lead_back(const Values& values, const Rule& rule) {
  ASSERT_EQ(values.size(), rule.alternatives.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(rule.alternatives[i].name, name_of(values[i]));
    Enum parsed{};
    EXPECT_TRUE(parse_name(name_of(values[i]), parsed));
    EXPECT_EQ(parsed, values[i]);
    EXPECT_FALSE(parse_name("?", parsed));
  }
}

}  // namespace edgecase
