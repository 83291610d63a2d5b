// SPDX-License-Identifier: MIT
#include "casefile/json/json_document.h"

#include <gmock/gmock.h>

namespace edgecase {
namespace {

using testing::ElementsAre;

JsonNode tree() {
  return *parse_json(R"({"draws": [{
    "a/b": {"~": 7},
    "vertices": [[1, 2], {"at": [3, 4, 0.5]}, {"color": []}, 9]}]})",
                     "a.json")
              .root;
}

JsonNode* find(JsonNode& root, const std::string& pointer, Missing missing = Missing::stays) {
  const auto tokens = split_pointer(pointer);
  return tokens ? find_at(root, *tokens, missing) : nullptr;
}

TEST(TreePointer, Splits) {
  EXPECT_THAT(split_pointer("/a~1b/~0//1").value(), ElementsAre("a/b", "~", "", "1"));
  EXPECT_THAT(split_pointer("/").value(), ElementsAre(""));
  for (const char* text : {"", "a", "/~", "/~2", "a/b"})
    EXPECT_FALSE(split_pointer(text).has_value()) << text;
}

TEST(TreePointer, FindsValues) {
  JsonNode root = tree();
  EXPECT_EQ(find(root, "/draws/0/a~1b/~0")->text, "7");
  EXPECT_EQ(find(root, "/draws/0/vertices/0/1")->text, "2");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/at/2")->text, "0.5");
  for (const char* pointer : {"/draws/1", "/draws/00", "/draws/-1", "/draws/0x", "/draws/", "/none",
                              "/draws/0/vertices/0/1/2", "/draws/99999999999999999999"})
    EXPECT_EQ(find(root, pointer), nullptr) << pointer;
}

TEST(TreePointer, FindsCoordinatesInEveryForm) {
  JsonNode root = tree();
  EXPECT_EQ(find(root, "/draws/0/vertices/0/y")->text, "2");
  EXPECT_EQ(find(root, "/draws/0/vertices/0/w")->text, "1");
  EXPECT_EQ(find(root, "/draws/0/vertices/0/z")->text, "0");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/z")->text, "0.5");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/w")->text, "1");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/w")->line, 3);
  EXPECT_EQ(find(root, "/draws/0/vertices/2/x"), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/3/x"), nullptr);
}

TEST(TreePointer, FindsClipCoordinatesAndObjectSpace) {
  JsonDocument document = parse_json(
      R"({"draws": [{"vertices": [{"clip": [1, 2, 3, 4]}, {"object": [5, 6, 7]}, {"clip": [8]}]}]})",
      "a.json");
  JsonNode& root = *document.root;
  EXPECT_EQ(find(root, "/draws/0/vertices/0/x")->text, "1");
  EXPECT_EQ(find(root, "/draws/0/vertices/0/w")->text, "4");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/z")->text, "7");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/w"), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/2/y"), nullptr);
}

TEST(TreePointer, FindsTextureCoordinates) {
  JsonDocument document = parse_json(
      R"({"draws": [{"vertices": [{"at": [1, 2], "uv": [3, 4]}, {"at": [1, 2], "uv": [5]}, [6, 7]]}],
          "textures": [{"noise": {"seed": 8}}]})",
      "a.json");
  JsonNode& root = *document.root;
  EXPECT_EQ(find(root, "/draws/0/vertices/0/s")->text, "3");
  EXPECT_EQ(find(root, "/draws/0/vertices/0/t")->text, "4");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/s")->text, "5");
  EXPECT_EQ(find(root, "/draws/0/vertices/1/t"), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/2/s", Missing::is_created), nullptr);
  EXPECT_EQ(find(root, "/textures/0/noise/seed")->text, "8");
  ASSERT_NE(find(root, "/draws/0/vertices/2/uv", Missing::is_created), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/2/y")->text, "7");
}

TEST(TreePointer, CreatesMembersButNoItems) {
  JsonNode root = tree();
  EXPECT_EQ(find(root, "/draws/0/state/line_width"), nullptr);
  ASSERT_NE(find(root, "/draws/0/state/line_width", Missing::is_created), nullptr);
  EXPECT_NE(find(root, "/draws/0/state/line_width"), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/4", Missing::is_created), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/3/color", Missing::is_created), nullptr);
}

TEST(TreePointer, GivesAnArrayAColour) {
  JsonNode root = tree();
  ASSERT_NE(find(root, "/draws/0/vertices/0/color", Missing::is_created), nullptr);
  EXPECT_EQ(find(root, "/draws/0/vertices/0/at/0")->text, "1");
  EXPECT_EQ(find(root, "/draws/0/vertices/0/x")->text, "1");
}

}  // namespace
}  // namespace edgecase
