// SPDX-License-Identifier: MIT
//
// Packed lines: they come back as they were; a file that is cut off or spoilt, or of another
// format, is refused in one sentence, and what resuming can take of it is taken.
#include "results/packed_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "results/results_json.h"
#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

std::string packed(const std::vector<std::string>& pieces) {
  std::ostringstream out;
  TextPacker packer(out);
  for (const std::string& piece : pieces) packer.add(piece);
  packer.finish();
  return out.str();
}

std::vector<std::string> lines_of(const std::string& bytes) {
  std::istringstream in(bytes);
  LineReader reader(in);
  std::vector<std::string> lines;
  for (std::string line; reader.next(line);) lines.push_back(line);
  return lines;
}

std::string file_of(const Results& results) {
  std::ostringstream out;
  write_packed_results(results, out);
  return out.str();
}

// The refusal, or "" when the bytes were read.
std::string refusal(const std::string& bytes, Cut cut = Cut::refused) {
  const auto outcome = read_results(bytes, cut);
  const auto* error = std::get_if<std::string>(&outcome);
  return error != nullptr ? *error : "";
}

// With many cases, so that a part of the bytes holds some.
Results many(int count) {
  Results results = full_results();
  CaseResults one = results.cases[0];
  results.cases = {};
  std::mt19937 random(7);
  for (int i = 0; i < count; ++i) {
    one.id = std::to_string(10000 + i);
    one.results[0].fingerprint = std::to_string(random());
    results.cases.push_back(one);
  }
  return results;
}

TEST(PackedStream, LinesComeBack) {
  std::mt19937 random(1);
  std::vector<std::string> lines;
  for (const std::size_t size : {0U, 1U, 70000U, 0U, 3U, 200000U, 5U})
    lines.emplace_back(size, static_cast<char>('a' + random() % 26));
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  EXPECT_EQ(lines_of(text), lines);
  EXPECT_EQ(lines_of(packed({text})), lines);
  EXPECT_EQ(lines_of(packed({text.substr(0, 9), text.substr(9)})), lines);
  lines.emplace_back("and a rest");
  EXPECT_EQ(lines_of(packed({text, "and a rest"})), lines);
  EXPECT_EQ(lines_of(packed({})), std::vector<std::string>());
  EXPECT_EQ(lines_of(""), std::vector<std::string>());
}

TEST(PackedStream, ResultsComeBackAndTakeLittleRoom) {
  const Results results = many(1000);
  const std::string bytes = file_of(results);
  std::ostringstream plain;
  write_results(results, plain);
  EXPECT_LT(bytes.size(), plain.str().size() / 20);
  EXPECT_EQ(bytes, file_of(results)) << "the same results are the same bytes";
  const auto read = read_results(bytes);
  ASSERT_TRUE(std::holds_alternative<Results>(read)) << std::get<std::string>(read);
  EXPECT_EQ(file_of(std::get<Results>(read)), bytes);
}

TEST(PackedStream, ACutFileIsRefusedUnlessItIsGoneOnWith) {
  const std::string bytes = file_of(many(1500));
  for (const std::size_t size : {bytes.size() - 1, bytes.size() - 4, bytes.size() / 2}) {
    const std::string cut = bytes.substr(0, size);
    EXPECT_THAT(refusal(cut), HasSubstr("--resume")) << size;
    const auto kept = read_results(cut, Cut::kept);
    ASSERT_TRUE(std::holds_alternative<Results>(kept)) << std::get<std::string>(kept);
    const Results& results = std::get<Results>(kept);
    EXPECT_TRUE(results.interrupted);
    EXPECT_GT(results.cases.size(), size == bytes.size() / 2 ? 100u : 1400u);
    for (std::size_t i = 0; i < results.cases.size(); ++i)
      ASSERT_EQ(results.cases.outline(i).id, std::to_string(10000 + i));
  }
  for (const std::size_t size : {0U, 3U, 5U, 20U})
    EXPECT_THAT(refusal(bytes.substr(0, size), Cut::kept), HasSubstr("no results file")) << size;
}

// The magic number tells packed lines from others, and how far back they refer may be more. Some
// bits of a frame mean nothing; a spoilt one that is read has said the same.
TEST(PackedStream, SpoiltBytesAreRefused) {
  const std::string bytes = file_of(many(100));
  std::mt19937 random(2);
  int harmless = 0;
  for (int round = 0; round < 60; ++round) {
    std::string spoilt = bytes;
    char& byte = spoilt[6 + random() % (bytes.size() - 6)];
    byte = static_cast<char>(byte ^ (1 << random() % 8));
    const auto read = read_results(spoilt);
    if (const auto* results = std::get_if<Results>(&read)) {
      EXPECT_EQ(file_of(*results), bytes) << round;
      ++harmless;
    }
  }
  EXPECT_LE(harmless, 2);
}

TEST(PackedStream, OtherFormatsAreToldByName) {
  EXPECT_THAT(refusal("{\n\"tool\":\"edgecase 0.1.0\",\n\"policy\":\"opengl\",\n"),
              HasSubstr("these are results of format 1, and this version reads format 2; run once "
                        "more"));
  std::ostringstream out;
  write_results(full_results(), out);
  std::string text = out.str();
  text.replace(text.find(":2,"), 3, ":3,");
  EXPECT_THAT(refusal(text), HasSubstr("these are results of format 3, and this version reads "
                                       "format 2"));
}

// A file of a few bytes that stands for a line without end.
TEST(PackedStream, ALineHasAnEnd) {
  std::ostringstream out;
  TextPacker packer(out);
  const std::string piece(std::size_t{1} << 24, 'a');
  for (std::size_t size = 0; size <= LineReader::kLongestLine; size += piece.size())
    packer.add(piece);
  packer.finish();
  ASSERT_LT(out.str().size(), 100'000u);
  EXPECT_THROW(lines_of(out.str()), std::runtime_error);
}

}  // namespace
}  // namespace edgecase
