// SPDX-License-Identifier: MIT
#include "recording/block.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace edgecase::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Lines = std::vector<std::string>;
constexpr std::size_t kPlenty = 10000;  // bytes

TEST(LineColumns, NumbersGoToColumnsOfTheirKeyAndIndexModuloFour) {
  const LineColumns parts = take_apart({R"({"x":3,"c":[1,0.5,2,4,7],"y":[{"x":9},{"x":-2}]})"});
  EXPECT_EQ(parts.text, "{\"x\":#,\"c\":[#,#,#,#,#],\"y\":[{\"x\":#},{\"x\":#}]}\n");
  // The first x is the object's first member, as those of the list are.
  EXPECT_THAT(parts.columns, ElementsAre(ElementsAre(3, 9, -2), ElementsAre(1, 7), ElementsAre(0.5),
                                         ElementsAre(2), ElementsAre(4)));
}

TEST(LineColumns, LinesShareColumns) {
  const LineColumns parts = take_apart({"[1,2]", "[3]", ""});
  EXPECT_EQ(parts.text, "[#,#]\n[#]\n\n");
  EXPECT_THAT(parts.columns, ElementsAre(ElementsAre(1, 3), ElementsAre(2)));
}

// What this program would write otherwise stays as it was written.
TEST(LineColumns, EveryLineComesBackByteForByte) {
  const Lines lines = {
      "",
      "0",
      "-0",
      "-17",
      "007",
      "1.50",
      "0.1",
      "0.10000000149011612",
      "1e-07",
      "1e-7",
      "1E5",
      "1e+300",
      "1e999",
      "9007199254740991",
      "9007199254740992",
      "123456789012345678901234567890",
      "5e-324",
      "1.5.2",
      R"({"a":"7, # and \"8\"","b":["nan","-inf",null,true],"":[[1.5],[2,[3]]],"c\"d":4})",
      R"({"a":[1,2,3,4,5,6,7,8,9.25,-1e-30,11,{"a":{"a":[12]}}]})",
      R"("#")"};
  EXPECT_EQ(put_together(take_apart(lines), kPlenty), lines);
  EXPECT_THAT(put_together(take_apart({}), kPlenty), IsEmpty());
}

TEST(LineColumns, OnlyNumbersWrittenAsWeWriteThemLeaveTheText) {
  EXPECT_EQ(take_apart({"[-0,1.50,1e-7,007,9007199254740993,0.1,-3,1e-07]"}).text,
            "[-0,1.50,1e-7,007,9007199254740993,#,#,#]\n");
}

TEST(LineColumns, PartsThatDoNotBelongTogetherAreRefused) {
  EXPECT_THROW(put_together({"[#]\n", {}}, kPlenty), std::runtime_error);
  EXPECT_THROW(put_together({"[#,#]\n", {{1}}}, kPlenty), std::runtime_error);
  EXPECT_THROW(put_together({"[#]\n", {{1, 2}}}, kPlenty), std::runtime_error);
  EXPECT_THROW(put_together({"[]\n", {{1}}}, kPlenty), std::runtime_error);
  EXPECT_THROW(put_together({"[#]", {{1}}}, kPlenty), std::runtime_error);
  EXPECT_THROW(put_together({"]\n", {}}, kPlenty), std::runtime_error);
  EXPECT_THROW(put_together({"\"abc\n", {}}, kPlenty), std::runtime_error);
}

// A mark may stand for many digits, and a line without any takes memory, too.
TEST(LineColumns, LinesAreAsLongAsTheyMayBe) {
  const LineColumns parts{"[#,#]\n", {{0.1}, {-1e-300}}};
  const std::size_t size = put_together(parts, kPlenty)[0].size() + sizeof(std::string);
  EXPECT_EQ(put_together(parts, size).size(), 1u);
  EXPECT_THROW(put_together(parts, size - 1), std::runtime_error);
  EXPECT_THROW(put_together({std::string(1000, '\n'), {}}, kPlenty), std::runtime_error);
}

}  // namespace
}  // namespace edgecase::recording
