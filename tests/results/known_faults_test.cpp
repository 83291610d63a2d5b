// SPDX-License-Identifier: MIT
//
// The file of a driver's known faults: read, written, refused; and what an entry accounts for.
#include "results/known_faults.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/causes.h"

namespace edgecase {
namespace {

constexpr const char* kFile = R"({
  "driver": "llvmpipe",
  "faults": [
    {"id": "first-fragment-lost", "rule": "line.diamond-exit", "kind": "missing",
     "cause": "line.algorithm=bresenham", "surface": "fbo",
     "cases": ["lines/short", "lines/diamonds/*"],
     "versions": "Mesa >=22.3", "cases_on": {"Mesa 22.3.6": 96, "Mesa 26.2.6": 3},
     "reason": "left\nbottom \"tie\"",
     "link": "https://example.org/1"},
    {"id": "unexplained", "rule": ["triangle.fill-rule", "triangle.shared-edge"],
     "cause": "none",
     "renderer": "egl:*",
     "cases": ["triangles"],
     "reason": "why"},
    {"id": "crash", "kind": "crashed",
     "cases": ["a"],
     "cases_on": {"1.0": 2},
     "reason": "signal 11"}
  ]
}
)";

KnownFaults read(const std::string& text) {
  auto parsed = parse_known_faults(text);
  if (const auto* fault = std::get_if<std::string>(&parsed)) throw std::runtime_error(*fault);
  return std::get<KnownFaults>(std::move(parsed));
}

TEST(KnownFaults, AreWrittenAsTheyAreRead) {
  const KnownFaults known = read(kFile);
  EXPECT_EQ(known_faults_text(known), kFile);
  ASSERT_EQ(known.faults.size(), 3u);
  EXPECT_EQ(known.faults[0].rules, std::vector{RuleId::line_diamond_exit});
  EXPECT_EQ(known.faults[0].cases_on.at("Mesa 22.3.6"), 96u);
  ASSERT_TRUE(known.faults[1].cause);
  EXPECT_TRUE(known.faults[1].cause->empty());
  EXPECT_FALSE(known.faults[2].cause);
  EXPECT_EQ(known_faults_text(read("{\"driver\": \"d\", \"faults\": []}")),
            "{\n  \"driver\": \"d\",\n  \"faults\": []\n}\n");
}

TEST(KnownFaults, AreRefusedWithThePlace) {
  const auto refusal = [](const std::string& text) {
    const auto parsed = parse_known_faults(text);
    const auto* fault = std::get_if<std::string>(&parsed);
    return fault != nullptr ? *fault : "";
  };
  const auto with = [](const std::string& fault) {
    return R"({"driver": "d", "faults": [)" + fault + "]}";
  };
  const std::pair<std::string, const char*> faults[] = {
      {"", "the file: "},
      {"[]", "the file: it is no object"},
      {R"({"faults": []})", "the file: \"driver\" is missing"},
      {R"({"driver": "d"})", "the file: \"faults\" is missing"},
      {R"({"driver": "d", "faults": {}})", "\"faults\" is missing, or no list"},
      {R"({"driver": "d", "faults": [], "more": 1})", "unknown key \"more\""},
      {with("7"), "fault 1: it is no object"},
      {with("{}"), "fault 1: \"id\" is missing"},
      {with(R"({"id": "x"})"), "fault \"x\": \"rule\", \"cause\" or \"kind\" is missing"},
      {with(R"({"id": "x", "rule": "no.rule"})"), "there is no rule \"no.rule\""},
      {with(R"({"id": "x", "kind": "missing"})"),
       "where there is no rule and no cause, not \"missing\""},
      {with(R"({"id": "x", "kind": "unsupported"})"), "not \"unsupported\""},
      {with(R"({"id": "x", "rule": "line.joint", "kind": "crashed"})"), "not \"crashed\""},
      {with(R"({"id": "x", "kind": []})"), "a list of names is empty"},
      {with(R"({"id": "x", "kind": "crashed"})"), "\"cases\" is missing"},
      {with(R"({"id": "x", "kind": "crashed", "cases": "a"})"), "\"reason\" is missing"},
      {with(R"({"id": "x", "kind": "crashed", "cases": "a", "cause": "a=b"})"),
       "\"a=b\" names no alternative"},
      {with(R"({"id": "x", "kind": "crashed", "cases": "a", "versions": "Mesa >22"})"),
       "no range of versions"},
      {with(R"({"id": "x", "kind": "crashed", "cases": "a", "cases_on": {"a": -1}})"),
       "\"cases_on\" holds a number"},
      {with(R"({"id": "x", "kind": "crashed", "cases": "a", "reason": "r", "note": "n"})"),
       "unknown key \"note\""},
      {with(R"({"id": "x", "kind": "crashed", "cases": "a", "reason": "r"},
               {"id": "x", "kind": "crashed", "cases": "b", "reason": "r"})"),
       "its id is taken"},
      {std::string(5000, '['), "the file: it is nested deeper"},
  };
  for (const auto& [text, said] : faults)
    EXPECT_NE(refusal(text).find(said), std::string::npos) << text << "\n" << refusal(text);
}

TEST(KnownFaults, NamesOfCasesHoldForFilesAndFolders) {
  EXPECT_TRUE(names_case("lines/short", "lines/short"));
  EXPECT_TRUE(names_case("lines/short", "lines/short:dx=1"));
  EXPECT_TRUE(names_case("lines", "lines/short:dx=1"));
  EXPECT_FALSE(names_case("lines/short", "lines/shorter"));
  EXPECT_FALSE(names_case("lines/short:dx=1", "lines/short:dx=12"));
  EXPECT_FALSE(names_case("lines/short", "lines"));
  EXPECT_TRUE(names_case("*/short:*=1", "lines/short:dx=1"));
  EXPECT_FALSE(names_case("*/short", "lines/short:dx=1"));
}

TEST(KnownFaults, NamesOfFilesFitFileSystems) {
  EXPECT_EQ(file_name_about("llvmpipe"), "llvmpipe.json");
  EXPECT_EQ(file_name_about("egl:zink"), "egl-zink.json");
  EXPECT_EQ(file_name_about("exec:python3 a/b.py"), "exec-python3-a-b.py.json");
  const std::string a = file_name_about(std::string(300, 'x') + "a");
  EXPECT_LT(a.size(), 230u);
  EXPECT_NE(a, file_name_about(std::string(300, 'x') + "b"));
}

// A missing pixel of primitive 2.
Disagreement difference() {
  Disagreement d;
  d.primitive = 2;
  d.kind = DisagreementKind::missing;
  d.rule = RuleId::line_diamond_exit;
  d.cause = cause_named("line.algorithm=bresenham");
  d.legality = Legality::illegal;
  return d;
}

TEST(KnownFaults, AccountForWhatFitsInAllThatTheyName) {
  const KnownFault fault = read(kFile).faults[0];
  const Result result;
  const auto fits = [&](const Disagreement& d, const char* id = "lines/short:x=1",
                        const char* surface = "fbo") {
    return accounts_for(fault, id, surface, result, d);
  };
  EXPECT_TRUE(fits(difference()));
  EXPECT_FALSE(fits(difference(), "lines/long"));
  EXPECT_FALSE(fits(difference(), "lines/short:x=1", "window"));
  Disagreement other = difference();
  other.kind = DisagreementKind::extra;
  EXPECT_FALSE(fits(other));
  other = difference();
  other.rule = RuleId::line_joint;
  EXPECT_FALSE(fits(other));
  other.upright = Disagreement::Upright{RuleId::line_diamond_exit, 1, Legality::illegal,
                                        cause_named("line.algorithm=bresenham")};
  EXPECT_TRUE(fits(other)) << "upside down, it is the same fault";
  other = difference();
  other.cause = cause_named("line.snap=none");
  EXPECT_FALSE(fits(other));
  other.cause = cause_named("line.snap=none + line.algorithm=bresenham");
  EXPECT_TRUE(fits(other)) << "a part of the cause is enough";
  other.cause = {};
  EXPECT_FALSE(fits(other));
}

// Which of several causes is told depends on the other cases of the run.
TEST(KnownFaults, AccountForAnyCauseThatExplainsThePrimitive) {
  const KnownFault fault = read(kFile).faults[0];
  Disagreement d = difference();
  d.cause = cause_named("line.snap=none");
  Result result;
  const auto fits = [&] { return accounts_for(fault, "lines/short", "fbo", result, d); };
  result.evidence.resize(1);
  result.evidence[0].primitive = 2;
  result.evidence[0].causes =
      causes_named({"line.snap=none", "line.algorithm=bresenham + line.snap=none"});
  EXPECT_TRUE(fits());
  result.evidence[0].primitive = 1;
  EXPECT_FALSE(fits());
  result.evidence[0].primitive = 2;
  result.evidence[0].pass = 1;
  EXPECT_FALSE(fits());
  d.sample = 1;
  EXPECT_TRUE(fits());
}

TEST(KnownFaults, WithoutACauseAccountForAnyAndNoneForNone) {
  KnownFaults known = read(kFile);
  KnownFault& fault = known.faults[1];
  Disagreement d = difference();
  d.rule = RuleId::triangle_fill_rule;
  const auto fits = [&] { return accounts_for(fault, "triangles/a", "window", Result(), d); };
  EXPECT_FALSE(fits());
  d.cause = {};
  EXPECT_TRUE(fits());
  fault.cause.reset();
  d.cause = cause_named("triangle.fill-rule=left-bottom");
  EXPECT_TRUE(fits());
}

TEST(KnownFaults, OfAnswersThatDidNotCome) {
  const KnownFaults known = read(kFile);
  EXPECT_TRUE(accounts_for(known.faults[2], "a", "fbo", Failure{FailureKind::crashed, ""}));
  EXPECT_FALSE(accounts_for(known.faults[2], "a", "fbo", Failure{FailureKind::timed_out, ""}));
  EXPECT_FALSE(accounts_for(known.faults[2], "b", "fbo", Failure{FailureKind::crashed, ""}));
  EXPECT_FALSE(accounts_for(known.faults[0], "a", "fbo", Failure{FailureKind::crashed, ""}));
  EXPECT_FALSE(accounts_for(known.faults[2], "a", "fbo", Result(), difference()));
}

TEST(KnownFaults, BelongToReleasesAndRenderers) {
  const KnownFaults known = read(kFile);
  RendererInfo info;
  info.name = "egl:llvmpipe";
  info.device = "llvmpipe (LLVM 15.0.6, 256 bits)";
  info.version = "4.5 (Core Profile) Mesa 22.3.6";
  EXPECT_EQ(faults_of(known, info).size(), 3u);
  info.version = "4.5 (Core Profile) Mesa 22.2.0";
  EXPECT_EQ(faults_of(known, info).size(), 2u);
  info.name = "osmesa:llvmpipe";
  EXPECT_EQ(faults_of(known, info).size(), 1u) << "one is of EGL alone";
}

TEST(KnownFaults, AreOfOpenGlEsAloneWhereNoOtherReleaseWasCounted) {
  KnownFault fault;
  EXPECT_FALSE(is_of_es_alone(fault));
  fault.cases_on = {{"Mesa 22.3.6 ES", 3}, {"Mesa 25.0.7 ES", 2}};
  EXPECT_TRUE(is_of_es_alone(fault));
  fault.cases_on["Mesa 25.0.7"] = 1;
  EXPECT_FALSE(is_of_es_alone(fault));
}

TEST(KnownFaults, ABrowserDoesNotTellTheReleaseOfTheDriverBelowIt) {
  const KnownFaults known = read(kFile);
  RendererInfo info;
  info.name = "webgl:chromium-gl";
  info.device = "ANGLE (Mesa/X.org, llvmpipe (LLVM 15.0.6 256 bits), OpenGL ES 3.2)";
  info.version = "OpenGL ES 3.0 (WebGL 2.0) Chromium 156.0.0.0";
  EXPECT_EQ(driver_of(info), "llvmpipe");
  EXPECT_EQ(text_of(release_of(info)), "Chromium 156.0.0.0 ES");
  EXPECT_EQ(faults_of(known, info).size(), 2u) << "those of any release, but for EGL's own";
}

}  // namespace
}  // namespace edgecase
