// SPDX-License-Identifier: MIT
//
// The schemas are made of the tables and limits that the loaders use: the files beside the cases
// are what the program makes, and nothing is left blank in them.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "casefile/case_reader.h"
#include "casefile/json/schema.h"
#include "casefile/policy_reader.h"
#include "casefile/scene/forms.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string laid_out(const std::string& text, const Pieces& blanks) {
  return lay_out(json_object(schema_pieces(text, blanks)));
}

void expect_file(const std::string& name, const std::string& schema) {
  std::ifstream file(EDGECASE_ROOT "/cases/" + name + ".schema.json", std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(text, schema) << "renew it: edgecase validate --schema " << name;
}

TEST(Schemas, AreTheFilesBesideTheCases) {
  expect_file("case", case_schema());
  expect_file("gallery", gallery_schema());
  expect_file("policy", policy_schema(known_rules()));
}

TEST(Schemas, HaveNoBlanks) {
  EXPECT_THAT(case_schema(), Not(HasSubstr("@")));
  EXPECT_THAT(gallery_schema(), Not(HasSubstr("@")));
  EXPECT_THAT(policy_schema(known_rules()), Not(HasSubstr("@")));
}

TEST(SchemaPieces, FillInNumbersTextsAndMembers) {
  const Pieces blanks{named("most", schema_number(16)),
                      named("more", json_object({named("b", json_string("c"))}))};
  EXPECT_EQ(
      laid_out(R"({"a": "@most", "t": "1 to @most, 2@most.", "@more": 0, "l": ["@most"]})", blanks),
      "{\"a\": 16, \"t\": \"1 to 16, 216.\", \"b\": \"c\", \"l\": [16]}\n");
}

TEST(SchemaPieces, GoOnBehindABackslash) {
  EXPECT_EQ(laid_out("{\"a\": \"one \\\n      two \\\n   three\"}", {}),
            "{\"a\": \"one two three\"}\n");
}

TEST(SchemaPieces, RefuseWhatNothingFillsInAndWhatIsNoObject) {
  EXPECT_THROW(schema_pieces(R"({"a": "@most"})"), std::logic_error);
  EXPECT_THROW(schema_pieces(R"({"a": "1 to @most"})"), std::logic_error);
  EXPECT_THROW(schema_pieces(R"({"@more": 0})"), std::logic_error);
  EXPECT_THROW(schema_pieces("[1]"), std::logic_error);
  EXPECT_THROW(schema_pieces("{"), std::logic_error);
}

TEST(SchemaNumber, HasAllDigits) {
  const auto text = [](double value) { return schema_number(value).text; };
  EXPECT_EQ(text(-3), "-3");
  EXPECT_EQ(text(0x1p64), "18446744073709551616");
  EXPECT_EQ(text(0x1p-16), "1.52587890625e-05");
  EXPECT_EQ(text(1.5), "1.5");
}

TEST(SchemaNumber, IsAPowerInASentenceWhereItIsLargeOrSmall) {
  EXPECT_EQ(number_text(-0x1p24), "-2^24");
  EXPECT_EQ(number_text(0x1p-20), "2^-20");
  EXPECT_EQ(number_text(0x1p19), "524288");
  EXPECT_EQ(number_text(0x1p24 + 1), "16777217");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(laid_out(R"({"a": "to @b", "b": "@b"})", {named("b", schema_number(0x1p64))}),
            "{\"a\": \"to 2^64\", \"b\": 18446744073709551616}\n");
}

TEST(FieldSchemas, SayWhatTheListSays) {
  const std::string text = lay_out(json_object(field_schemas<StencilFace>()));
  EXPECT_THAT(text, HasSubstr(R"("reference": {)"));
  EXPECT_THAT(text, HasSubstr(R"("minimum": 0)"));
  EXPECT_THAT(text, HasSubstr(R"("maximum": 255)"));
  EXPECT_THAT(text, HasSubstr(R"("$ref": "#/$defs/stencil_operation")"));
  EXPECT_THAT(text, HasSubstr("Which bits are compared, 0 to 255."));
}

}  // namespace
}  // namespace edgecase
