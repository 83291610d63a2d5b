// SPDX-License-Identifier: MIT
#include "recording/recording.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace edgecase {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

RecordingHead some_head() {
  RecordingHead head;
  head.tool = "edgecase 9";
  head.renderer = {"egl:device0", "A vendor", "4.6 \"quoted\"",
                   "A device",    8,          {{"point_sizes", "1 to 64"}, {"stack", "x\ny"}}};
  head.is_complete = false;
  return head;
}

std::vector<RecordedBlock> some_blocks() {
  return {make_block({{"a/b", "0123456789abcdef"}, {"a/c:x=1/2", "fedcba9876543210"}},
                     {R"({"pixels":[1,2,3,255]})", R"({"depth":0.5})"}),
          make_block({{"d", "00000000000000ff"}}, {R"({"failure":"crashed","reason":"x"})"})};
}

class RecordingFile : public testing::Test {
 protected:
  void SetUp() override {
    path_ =
        std::filesystem::temp_directory_path() / ("edgecase-recording-" + std::to_string(getpid()));
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::variant<Recording, std::string> open(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return Recording::open(path_);
  }
  // The sentence that refuses these bytes; empty where they are taken.
  std::string refusal(const std::string& bytes) {
    const auto opened = open(bytes);
    const auto* message = std::get_if<std::string>(&opened);
    return message == nullptr ? "" : *message;
  }

  std::filesystem::path path_;
};

TEST_F(RecordingFile, KeepsHeadIndexAndLines) {
  const auto opened = open(recording_bytes(some_head(), some_blocks()));
  const auto* recording = std::get_if<Recording>(&opened);
  ASSERT_NE(recording, nullptr) << std::get<std::string>(opened);
  const RecordingHead& head = recording->head();
  const RecordingHead expected = some_head();
  EXPECT_EQ(head.tool, expected.tool);
  EXPECT_EQ(head.is_complete, expected.is_complete);
  EXPECT_EQ(head.renderer.name, expected.renderer.name);
  EXPECT_EQ(head.renderer.vendor, expected.renderer.vendor);
  EXPECT_EQ(head.renderer.version, expected.renderer.version);
  EXPECT_EQ(head.renderer.device, expected.renderer.device);
  EXPECT_EQ(head.renderer.subpixel_bits, expected.renderer.subpixel_bits);
  EXPECT_EQ(head.renderer.traits, expected.renderer.traits);
  EXPECT_EQ(recording->size(), 3u);
  EXPECT_EQ(recording->find("a"), nullptr);
  const auto* second = recording->find("a/c:x=1/2");
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->digest, "fedcba9876543210");
  EXPECT_EQ(second->block, 0u);
  EXPECT_EQ(second->line, 1u);
  EXPECT_EQ(recording->find("d")->block, 1u);
  EXPECT_THAT(recording->lines(0, 0), ElementsAre(R"({"pixels":[1,2,3,255]})", R"({"depth":0.5})"));
  EXPECT_THAT(recording->lines(1, 100), ElementsAre(R"({"failure":"crashed","reason":"x"})"));
  EXPECT_THROW(recording->lines(1, 50), std::runtime_error) << "it is longer than its scene needs";
}

TEST_F(RecordingFile, TheHeadCanBeReadAlone) {
  open(recording_bytes(some_head(), some_blocks()));
  const auto head = Recording::open_head(path_);
  ASSERT_TRUE(std::holds_alternative<RecordingHead>(head));
  EXPECT_EQ(std::get<RecordingHead>(head).renderer.name, "egl:device0");
}

TEST_F(RecordingFile, SameAnswersAreTheSameBytes) {
  EXPECT_EQ(recording_bytes(some_head(), some_blocks()),
            recording_bytes(some_head(), some_blocks()));
}

TEST_F(RecordingFile, AnEmptyRecordingIsOne) {
  const auto opened = open(recording_bytes(some_head(), {}));
  ASSERT_TRUE(std::holds_alternative<Recording>(opened));
  EXPECT_EQ(std::get<Recording>(opened).size(), 0u);
}

TEST_F(RecordingFile, IsRefusedWhereverItIsCutOff) {
  const std::string whole = recording_bytes(some_head(), some_blocks());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THAT(refusal(whole.substr(0, size)), HasSubstr("cannot be used")) << size;
  EXPECT_THAT(refusal(whole + " "), HasSubstr("cannot be used"));
}

TEST_F(RecordingFile, IsRefusedWhicheverByteIsAnother) {
  const std::string whole = recording_bytes(some_head(), some_blocks());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string altered = whole;
    altered[i] = static_cast<char>(altered[i] ^ 1);
    EXPECT_THAT(refusal(altered), AllOf(HasSubstr(path_.string()), HasSubstr("cannot be used"),
                                        HasSubstr("edgecase record")))
        << i;
  }
}

TEST_F(RecordingFile, OfAnotherVersionIsRefused) {
  std::string other = recording_bytes(some_head(), some_blocks());
  other.replace(0, other.find('\n'), "edgecase-recording 2");
  EXPECT_THAT(refusal(other), AllOf(HasSubstr("version 2"), HasSubstr("version 1")));
  EXPECT_THAT(refusal("{\"edgecase\": 1}\n"), HasSubstr("it is no recording"));
}

TEST_F(RecordingFile, ThatCannotBeReadSaysSo) {
  const auto missing = Recording::open("/nonexistent/file.rec");
  EXPECT_THAT(std::get<std::string>(missing),
              AllOf(HasSubstr("/nonexistent/file.rec"), HasSubstr("No such file")));
  const auto folder = Recording::open("/tmp");
  EXPECT_THAT(std::get<std::string>(folder), HasSubstr("cannot read the recording /tmp"));
}

}  // namespace
}  // namespace edgecase
