// SPDX-License-Identifier: MIT
//
// What is written without a tree is to the byte what the JSON library makes of the same tree.
#include "results/json_writer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Value>
std::string written(const Value& value) {
  std::string text;
  JsonWriter(text).value(value);
  return text;
}

TEST(JsonWriter, WritesFiniteNumbersAsTheLibraryDoes) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, 1.0 / 3, 0x1p53 - 1, Limits::min(), Limits::max()})
    EXPECT_EQ(written(value), dump(value));
  for (int exponent = -307; exponent <= 308; ++exponent) {
    const double power = std::stod(fmt::format("-1e{}", exponent));
    EXPECT_EQ(written(power), dump(power));
  }
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto bits = std::bit_cast<double>(random());  // of every magnitude
    if (std::isfinite(bits)) {
      ASSERT_EQ(written(bits), dump(bits));
    }
    const double small = static_cast<double>(random() % 1000000) / 1024;
    ASSERT_EQ(written(small), dump(small));
  }
}

TEST(JsonWriter, NamesWhatIsNoNumberInJson) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(written(std::vector{kInfinity, -kInfinity, std::nan(""), -std::nan("")}),
            R"(["inf","-inf","nan","nan"])");
}

TEST(JsonWriter, WritesIntegersOfEveryType) {
  EXPECT_EQ(written(0), "0");
  EXPECT_EQ(written(std::numeric_limits<int>::min()), "-2147483648");
  EXPECT_EQ(written(std::numeric_limits<std::uint32_t>::max()), "4294967295");
  EXPECT_EQ(written(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(written(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
}

// Every byte, alone and within a text that is long enough for many to be asked at once.
TEST(JsonWriter, EscapesAndReplacesAsTheLibraryDoes) {
  const std::string around(40, 'a');
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text(1, static_cast<char>(byte));
    EXPECT_EQ(written(text), dump(text)) << byte;
    EXPECT_EQ(written(around + text + around), dump(around + text + around)) << byte;
  }
  for (const char* text : {"", "\"", "\\", "</script>", "é 漢 \U0001F600 \u2028", "a\xc3", "\xc3z",
                           "\xed\xa0\x80", "\xf8\x88\x80\x80\x80", "\xff\xff"}) {
    EXPECT_EQ(written(text), dump(text)) << text;
    EXPECT_EQ(written(std::string_view(text)), dump(text)) << text;
  }
}

TEST(JsonWriter, NamesOfMembersAreEscapedToo) {
  std::string text;
  JsonWriter json(text);
  json.object([&] { json.member("\"a\"\n\xff", 1); });
  EXPECT_EQ(text, dump({{"\"a\"\n\xff", 1}}));
}

TEST(JsonWriter, WhatIsEmptyHasNoComma) {
  std::string text;
  JsonWriter json(text);
  json.object([&] {
    json.key("a").object([] {});
    json.key("b").list([] {});
    json.key("c").array();
    json.member("d", std::vector<std::string>());
  });
  EXPECT_EQ(text, R"({"a":{},"b":[],"c":[],"d":[]})");
}

TEST(JsonWriter, CommasStandBetweenAllThatFollowsSomething) {
  std::string text = "before ";
  JsonWriter json(text);
  json.list([&] {
    json.array(1, true, nullptr, "a", 0.5);
    json.object([&] {
      json.member("a", false);
      json.key("b").list(std::vector{1, 2}, [](JsonWriter& to, int n) { to.array(n, -n); });
      json.member("c", std::vector<std::vector<std::string>>{{"x", "y"}, {}, {"z"}});
    });
    json.object([] {});
    json.value(7);
  });
  EXPECT_EQ(text, R"(before [[1,true,null,"a",0.5],)"
                  R"({"a":false,"b":[[1,-1],[2,-2]],"c":[["x","y"],[],["z"]]},{},7])");
}

}  // namespace
}  // namespace edgecase
