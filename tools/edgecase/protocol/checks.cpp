// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "tools/edgecase/protocol/roots.h"
#include "tools/edgecase/protocol/scenes.h"
#include "tools/edgecase/protocol/session.h"
#include "wire/request_line.h"

namespace edgecase {

namespace {

using nlohmann::json;
using std::chrono::milliseconds;

// The time during which nothing may follow an answer, and the time that a program may take to end.
constexpr milliseconds kQuiet{150};
constexpr milliseconds kFarewell{2'000};

constexpr const char* kIgnore = R"(ignore unknown keys beside "scene")";
constexpr const char* kStayAlive =
    "answer every request with one line, and go on reading; what it wrote to standard error may "
    "say "
    "why it did not";
constexpr const char* kListAll =
    "list every fragment that the rasterizer makes; a test only decides what is stored";
constexpr const char* kRootFirst = "put the root right first; this may follow from it";
constexpr const char* kFollow = "compare the answer with \"The answer\" in reference/PROTOCOL.md";

// The result of a check.
struct CheckResult {
  CheckOutcome outcome = CheckOutcome::pass;
  std::string finding;
  std::string remedy;
  bool of_picture = false;  // of `fail`: judged by what is drawn, not by the answer's form
};

CheckResult failed(std::string finding, std::string remedy) {
  return {CheckOutcome::fail, std::move(finding), std::move(remedy)};
}

// The result of a check of what is drawn.
CheckResult by_picture(const std::optional<Fault>& fault) {
  return fault ? CheckResult{CheckOutcome::fail, fault->finding, fault->remedy, true}
               : CheckResult{};
}

// The result for a reply that is neither a rendering nor a refusal.
CheckResult no_answer(const Reply& reply) {
  if (reply.kind == Reply::Kind::silence) return failed(reply.problem, kStayAlive);
  return failed("its answer is refused: " + reply.problem, kFollow);
}

bool is_answer(const Reply& reply) {
  return reply.kind == Reply::Kind::rendering || reply.kind == Reply::Kind::refusal;
}

// A rendering passes, a refusal is not supported, all else fails.
CheckResult by_kind(const Reply& reply) {
  if (reply.kind == Reply::Kind::rendering) return {};
  if (reply.kind == Reply::Kind::refusal) return {CheckOutcome::not_supported, reply.problem, ""};
  return no_answer(reply);
}

class Examiner {
 public:
  Examiner(const Command& command, milliseconds patience, const std::atomic<bool>* stop)
      : session_(command, patience, stop), stop_(stop) {}

  ProtocolExamination operator()() {
    check("starts and answers", [&] { return starts(); });
    if (result_.checks.empty()) return std::move(result_);  // stopped by then
    result_.started = result_.checks.front().outcome == CheckOutcome::pass;
    if (!result_.started) return std::move(result_);
    examine_lines();
    examine_drawings();
    for (const FeatureScene& feature : feature_scenes())
      check("draws or refuses " + feature.name, feature.name,
            [&] { return optional_feature(feature); });
    find_roots();
    examine_names();
    check("ends when its input does, with exit status 0", [&] { return ends(); });
    return std::move(result_);
  }

 private:
  bool stopped() const { return stop_ != nullptr && stop_->load(); }

  void check(std::string name, const std::function<CheckResult()>& run) {
    check(std::move(name), "", run);
  }

  void check(std::string name, std::string feature, const std::function<CheckResult()>& run) {
    if (stopped()) return;
    CheckResult verdict = run();
    // After garbage, further output may follow, so the program is restarted.
    if (verdict.outcome == CheckOutcome::fail) session_.restart();
    if (stopped()) return;
    result_.checks.push_back({static_cast<int>(result_.checks.size()) + 1, std::move(name),
                              verdict.outcome, std::move(verdict.finding),
                              std::move(verdict.remedy), std::move(feature), verdict.of_picture});
  }

  // Finds roots in a picture and in what was drawn before. All failed checks of pictures may follow
  // from the former.
  void find_roots() {
    if (stopped()) return;
    for (const Primitive primitive : {Primitive::triangles, Primitive::lines, Primitive::points}) {
      const Reply reply = session_.ask("conformance/roots", root_scene(primitive));
      if (!is_answer(reply)) session_.restart();
      if (reply.kind == Reply::Kind::rendering)
        result_.roots = roots_of(primitive, reply.rendering);
      if (reply.kind != Reply::Kind::refusal) break;
    }
    for (ProtocolCheck& check : result_.checks) {
      check.follows = check.follows && !result_.roots.empty();
      if (check.follows) check.remedy = kRootFirst;
    }
    if (unlisted_.empty()) return;
    result_.roots.push_back({fmt::format("fragments that fail the {} test are not listed",
                                         fmt::join(unlisted_, " or the ")),
                             kListAll});
    for (ProtocolCheck& check : result_.checks)
      check.follows = check.follows || check.remedy == kListAll;
  }

  void examine_lines() {
    check("answers an empty scene", [&] { return empty(); });
    check("repeats the digest", [&] { return repeats_digest(); });
    check("answers one line for each request, in order", [&] { return one_line_each(); });
    check("writes nothing else to standard output", [&] { return quiet(); });
    check("draws several scenes in one process", [&] { return one_process(); });
    check("answers the same scene alike", [&] { return alike(); });
    check("has as many pixels as the target, for any size", [&] {
      return sizes({{1, 1}, {3, 5}, {5, 3}, {7, 1}, {1, 7}});
    });
    check("draws targets of 4096 pixels", [&] { return sizes({{4096, 1}, {1, 4096}}); });
    check("takes a request for coverage alone", [&] { return coverage_alone(); });
  }

  void examine_drawings() {
    for (const Primitive primitive :
         {Primitive::points, Primitive::lines, Primitive::line_strip, Primitive::line_loop,
          Primitive::triangles, Primitive::triangle_strip, Primitive::triangle_fan})
      check(fmt::format("draws {}", name_of(primitive)), name_of(primitive),
            [&] { return drawing(primitive); });
    check("numbers primitives without extent, and tells finite values only",
          [&] { return values(); });
  }

  void examine_names() {
    check("takes any character in an id", [&] { return ids(); });
    check("ignores an unknown key of the request", [&] {
      return changed([](json& request) { request["hint"] = {{"of", "a later version"}}; }, true);
    });
    const std::pair<const char*, std::function<void(json&)>> unknown[] = {
        {"an unknown key of the scene", [](json& r) { r["scene"]["fog"] = true; }},
        {"an unknown key of the target", [](json& r) { r["scene"]["target"]["layers"] = 2; }},
        {"an unknown key of a draw", [](json& r) { r["scene"]["draws"][0]["warp"] = 1.5; }},
        {"an unknown key of a vertex",
         [](json& r) { r["scene"]["draws"][0]["vertices"][0]["weight"] = 2; }},
        {"an unknown primitive", [](json& r) { r["scene"]["draws"][0]["primitive"] = "patches"; }},
        {"another version of the protocol", [](json& r) { r["edgecase"] = 2; }}};
    for (const auto& [name, change] : unknown)
      check(fmt::format("refuses {}", name),
            [&, &change = change] { return changed(change, false); });
  }

  CheckResult starts() {
    const Reply reply = session_.ask("conformance/start", empty_scene(1, 1));
    if (session_.starts() == 0)
      return failed(reply.problem, "check the path, and that the file may be executed");
    if (reply.kind == Reply::Kind::silence) return failed(reply.problem, kStayAlive);
    return {};
  }

  CheckResult empty() {
    const Scene scene = empty_scene(4, 3);
    const Reply reply = session_.ask("conformance/empty", scene);
    if (reply.kind != Reply::Kind::rendering) return by_kind(reply);
    return by_picture(fault_of_empty(scene, reply.rendering));
  }

  // Two scenes are drawn, since the second must not get the digest of the first.
  CheckResult repeats_digest() {
    for (const Scene& scene : {empty_scene(2, 2), empty_scene(3, 2)}) {
      const std::string digest = digest_of(scene_json(scene));
      const Reply reply = session_.ask("conformance/digest", scene);
      if (reply.kind == Reply::Kind::silence) return no_answer(reply);
      const json answer = json::parse(reply.line, nullptr, false);
      if (answer.is_discarded()) return failed("its answer is no JSON: " + reply.problem, kFollow);
      if (!answer.is_object() || !answer.contains("digest") || answer["digest"] != digest)
        return failed(fmt::format("the answer to digest \"{}\" does not hold it", digest),
                      "copy \"digest\" from the request into the answer, for each scene anew");
    }
    return {};
  }

  CheckResult one_line_each() {
    for (int width = 1; width <= 4; ++width) {
      const Reply reply = session_.ask("conformance/order", empty_scene(width, 2));
      if (!is_answer(reply)) return no_answer(reply);
    }
    return {};
  }

  // Checks that nothing follows the last answer.
  CheckResult quiet() {
    const Reply reply = session_.ask("conformance/quiet", scene_of(Primitive::triangles));
    if (!is_answer(reply)) return no_answer(reply);
    const std::string more = session_.process()->unasked_output(kQuiet).substr(0, 60);
    if (more.empty()) return {};
    return failed(fmt::format("after its answer comes {}",
                              json(more).dump(-1, ' ', true, json::error_handler_t::replace)),
                  "write to standard error whatever is no answer");
  }

  CheckResult one_process() {
    const int starts = session_.starts();
    for (const Primitive primitive :
         {Primitive::points, Primitive::lines, Primitive::triangles, Primitive::points}) {
      const Reply reply = session_.ask("conformance/several", scene_of(primitive));
      if (!is_answer(reply)) return no_answer(reply);
    }
    if (session_.starts() > starts + 1)
      return failed("it ended between two scenes", "read requests until standard input ends");
    return {};
  }

  CheckResult alike() {
    const Scene scene = scene_of(Primitive::triangles);
    std::array<json, 2> answers;
    for (json& answer : answers) {
      const Reply reply = session_.ask("conformance/alike", scene);
      if (!is_answer(reply)) return no_answer(reply);
      answer = json::parse(reply.line);
      answer.erase("renderer");
      const Reply between = session_.ask("conformance/between", scene_of(Primitive::points));
      if (!is_answer(between)) return no_answer(between);
    }
    if (answers[0] == answers[1]) return {};
    return failed("the same scene is answered in two ways",
                  "start each scene afresh: nothing of the one before may be left");
  }

  CheckResult sizes(const std::vector<std::pair<int, int>>& sizes) {
    for (const auto& [width, height] : sizes) {
      Scene scene = empty_scene(width, height);
      Draw draw;
      draw.primitive = Primitive::points;
      draw.vertices.emplace_back();
      draw.vertices[0].position = {Fixed::centre_of(width - 1), Fixed::centre_of(height - 1)};
      scene.draws = {draw};
      const Reply reply = session_.ask("conformance/sizes", scene);
      CheckResult verdict = by_kind(reply);
      if (verdict.outcome == CheckOutcome::pass && reply.rendering.fragments.empty())
        verdict = by_picture(Fault{"a point in the last pixel has no fragment", kFollow});
      if (verdict.outcome == CheckOutcome::pass) continue;
      verdict.finding = fmt::format("{} by {} pixels: {}", width, height, verdict.finding);
      return verdict;
    }
    return {};
  }

  CheckResult coverage_alone() {
    return by_kind(session_.ask("conformance/coverage", scene_of(Primitive::triangles), true));
  }

  CheckResult drawing(Primitive primitive) {
    const Scene scene = scene_of(primitive);
    const Reply reply = session_.ask("conformance/primitives", scene);
    if (reply.kind != Reply::Kind::rendering) return by_kind(reply);
    remember(scene, reply.rendering);
    return by_picture(fault_of_drawing(scene, reply.rendering));
  }

  CheckResult values() {
    const Reply reply = session_.ask("conformance/without-extent", scene_without_extent());
    if (reply.kind != Reply::Kind::rendering) return by_kind(reply);
    const auto fault = fault_of_values(reply.rendering);
    return fault ? failed(fault->finding, fault->remedy) : CheckResult{};
  }

  CheckResult optional_feature(const FeatureScene& feature) {
    const Reply reply = session_.ask("conformance/features", feature.scene);
    if (reply.kind == Reply::Kind::garbage) {
      CheckResult verdict = no_answer(reply);
      verdict.remedy = kRefuse;
      return verdict;
    }
    if (reply.kind != Reply::Kind::rendering) return by_kind(reply);
    if (const auto fault = fault_of_feature(feature, reply.rendering)) return by_picture(fault);
    remember(feature.scene, reply.rendering);
    if (lists_failing(feature, reply.rendering)) return {};
    unlisted_.push_back(feature.failed_test);
    return failed("no fragment that fails the test is listed", kListAll);
  }

  CheckResult ids() {
    const std::string ids[] = {"",
                               "quotes \" and \\ backslashes",
                               "a line\nbreak, a tab\t and a bell\x07",
                               "\xc3\xa9t\xc3\xa9 \xe6\xbc\xa2\xe5\xad\x97 \xf0\x9f\x94\xba",
                               "}{][:,",
                               std::string(10'000, 'x')};
    for (const std::string& id : ids) {
      const Reply reply = session_.ask(id, empty_scene(2, 1));
      if (is_answer(reply)) continue;
      CheckResult verdict = no_answer(reply);
      verdict.finding =
          fmt::format("to the id {}: {}", json(id.substr(0, 40)).dump(), verdict.finding);
      return verdict;
    }
    return {};
  }

  // Keeps the first scene that is drawn: a rendering without contrast and fragments shows nothing.
  void remember(const Scene& scene, const Rendering& rendering) {
    if (!drawn_ && (shows_contrast(rendering) || !rendering.fragments.empty()))
      drawn_ = {scene, rendering.pixels};
  }

  // Asks for a scene that the program has drawn, changed. It must be drawn like the original if
  // `draws`, and refused otherwise.
  CheckResult changed(const std::function<void(json&)>& change, bool draws) {
    if (!drawn_)
      return {CheckOutcome::not_asked, "it has drawn no scene that could be changed", ""};
    const std::string text = scene_json(drawn_->scene);
    json request = json::parse(request_line("conformance/changed", text));
    change(request);
    const Reply reply = session_.ask_text(request.dump(), digest_of(text), drawn_->scene);
    CheckResult verdict = by_kind(reply);
    if (reply.kind == Reply::Kind::silence) return verdict;
    if (!draws) {
      if (reply.kind == Reply::Kind::refusal) return {};
      if (verdict.finding.empty()) verdict.finding = "it draws the scene as if it knew";
      return failed(verdict.finding, kRefuse);
    }
    if (reply.kind == Reply::Kind::rendering && reply.rendering.pixels == drawn_->pixels) return {};
    if (reply.kind == Reply::Kind::refusal) verdict.finding = "it refuses: " + reply.problem;
    if (verdict.finding.empty()) verdict.finding = "it draws something else than without the key";
    return failed(verdict.finding, kIgnore);
  }

  CheckResult ends() {
    const Reply reply = session_.ask("conformance/end", empty_scene(1, 1));
    if (!is_answer(reply)) return no_answer(reply);
    ChildProcess& process = *session_.process();
    const bool ended = process.finish(kFarewell);
    const std::string how = process.how_it_ended();
    const std::string more = process.unasked_output(milliseconds{0}).substr(0, 60);
    const int status = process.exit_status();
    session_.restart();
    if (!ended)
      return failed("it goes on after its standard input has ended", "end where no line is left");
    if (status != 0) return failed("it ends with " + how, "end with exit status 0");
    if (more.empty()) return {};
    return failed("it writes to standard output as it ends",
                  "write to standard error whatever is no answer");
  }

  ProtocolSession session_;
  const std::atomic<bool>* stop_;
  ProtocolExamination result_;
  struct Drawn {
    Scene scene;
    std::vector<std::uint8_t> pixels;
  };
  std::optional<Drawn> drawn_;         // the first primitives that it draws
  std::vector<std::string> unlisted_;  // tests whose failing fragments it does not list
};

}  // namespace

std::size_t ProtocolExamination::count(CheckOutcome outcome) const {
  return static_cast<std::size_t>(
      std::count_if(checks.begin(), checks.end(),
                    [&](const ProtocolCheck& check) { return check.outcome == outcome; }));
}

ProtocolExamination examine_protocol(const Command& command, milliseconds patience,
                                     const std::atomic<bool>* stop) {
  return Examiner(command, patience, stop)();
}

}  // namespace edgecase
