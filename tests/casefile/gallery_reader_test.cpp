// SPDX-License-Identifier: MIT
#include "casefile/policy_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace edgecase {
namespace {

const std::vector<KnownRule> kKnown{{"triangle.fill-rule", {"left-top", "closed"}},
                                    {"line.snap", {"none", "8-half-even"}}};

LoadedGallery load(const std::string& text) {
  return load_gallery_text(text, "g.json", kKnown);
}

struct Fault {
  const char* text;
  int line;
  const char* pointer;
  const char* message;
  const char* remedy;
};

TEST(GalleryReader, ReadsEveryField) {
  const LoadedGallery loaded = load(R"({"$schema": "x", "title": "Mine", "about": "Half planes.",
    "policy": "mine", "sources": ["https://example.org/", "a book"],
    "choices": {"triangle.fill-rule": "Borders count."}, "not_shown": {"line.snap": "No lines."},
    "pictures": [{"case": "a/b:dx=1", "heading": "One", "text": "Look.",
                  "rules": {"triangle.fill-rule": "closed"}},
                 {"case": "c", "heading": "Two"}]})");
  EXPECT_TRUE(loaded.diagnostics.empty()) << to_string(loaded.diagnostics.front());
  ASSERT_TRUE(loaded.value.has_value());
  const Gallery& gallery = *loaded.value;
  EXPECT_EQ(gallery.title, "Mine");
  EXPECT_EQ(gallery.policy, "mine");
  EXPECT_EQ(gallery.sources, (std::vector<std::string>{"https://example.org/", "a book"}));
  EXPECT_EQ(gallery.choices.at("triangle.fill-rule"), "Borders count.");
  EXPECT_EQ(gallery.not_shown.at("line.snap"), "No lines.");
  ASSERT_EQ(gallery.pictures.size(), 2U);
  EXPECT_EQ(gallery.pictures[0].case_id, "a/b:dx=1");
  EXPECT_EQ(gallery.pictures[0].heading, "One");
  EXPECT_EQ(gallery.pictures[0].text, "Look.");
  EXPECT_EQ(gallery.pictures[0].rules, (Choices{{"triangle.fill-rule", "closed"}}));
  EXPECT_TRUE(gallery.pictures[1].rules.empty());
}

TEST(GalleryReader, NamesEachFault) {
  const Fault faults[] = {
      {"[]", 1, "", "must be an object", "{"},
      {"{\"policy\": \"p\", \"pictures\": [{\"case\": \"a\", \"heading\": \"b\"}]}", 1, "",
       "lacks \"title\"", "add"},
      {"{\"title\": \"t\", \"policy\": \"p\"}", 1, "", "lacks \"pictures\"", "add"},
      {"{\"title\": \"t\", \"policy\": \"p\",\n\"pictures\": []}", 2, "/pictures", "0 pictures",
       "1 to 100"},
      {"{\"title\": \"t\", \"policy\": \"p\", \"pictures\": {}}", 1, "/pictures",
       "must be an array", "["},
      {"{\"title\": \"t\", \"policy\": \"p\", \"pictures\": [{\"case\": \"a\"}]}", 1, "/pictures/0",
       "lacks \"heading\"", "add"},
      {"{\"title\": \"t\", \"policy\": \"p\", \"pictures\": [{\"case\": \"a\", \"heading\": \"b\", "
       "\"rule\": {}}]}",
       1, "/pictures/0/rule", "no key", "did you mean \"rules\"?"},
      {"{\"title\": \"t\", \"policy\": \"p\", \"pictures\": [{\"case\": \"a\", \"heading\": \"b\", "
       "\"rules\": {\"line.snap\": \"non\"}}]}",
       1, "/pictures/0/rules/line.snap", "no alternative", "did you mean \"none\"?"},
      {"{\"title\": \"t\", \"policy\": \"p\", \"choices\": {\"line.snaps\": \"x\"}, \"pictures\": "
       "[{\"case\": \"a\", \"heading\": \"b\"}]}",
       1, "/choices/line.snaps", "there is no rule", "did you mean \"line.snap\"?"},
      {"{\"title\": \"t\", \"policy\": \"p\", \"not_shown\": {\"Snap\": \"x\"}, \"pictures\": "
       "[{\"case\": \"a\", \"heading\": \"b\"}]}",
       1, "/not_shown/Snap", "no rule's id", "line.diamond-exit"},
      {"{\"title\": \"t\", \"policy\": \"p\", \"sources\": \"x\", \"pictures\": "
       "[{\"case\": \"a\", \"heading\": \"b\"}]}",
       1, "/sources", "must be an array", "["},
      {"{\"title\": \"a\\u0007b\", \"policy\": \"p\", \"pictures\": "
       "[{\"case\": \"a\", \"heading\": \"b\"}]}",
       1, "/title", "control", "remove"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.text);
    const LoadedGallery loaded = load(fault.text);
    EXPECT_FALSE(loaded.value.has_value());
    ASSERT_EQ(loaded.diagnostics.size(), 1U);
    EXPECT_EQ(loaded.diagnostics[0].line, fault.line);
    EXPECT_EQ(loaded.diagnostics[0].pointer, fault.pointer);
    EXPECT_NE(loaded.diagnostics[0].message.find(fault.message), std::string::npos)
        << loaded.diagnostics[0].message;
    EXPECT_NE(loaded.diagnostics[0].remedy.find(fault.remedy), std::string::npos)
        << loaded.diagnostics[0].remedy;
  }
}

TEST(GalleryReader, CollectsAllFaults) {
  EXPECT_EQ(load(R"({"title": "", "policy": 1, "pictures": [{"heading": 3}], "extra": 0})")
                .diagnostics.size(),
            5U);
}

TEST(GalleryReader, ReportsAMissingFile) {
  const LoadedGallery loaded = load_gallery("no/such/gallery.json", kKnown);
  EXPECT_FALSE(loaded.value.has_value());
  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_EQ(loaded.diagnostics[0].file, "no/such/gallery.json");
}

}  // namespace
}  // namespace edgecase
