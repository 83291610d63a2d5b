// SPDX-License-Identifier: MIT
//
// What is said of a sample whose fate is not what the renderer's own fragments make it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diff/output/fate_question.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

// More fragments than this are not told one by one.
constexpr std::size_t kMostTold = 6;

std::string words_of_stencil(const Arrival& arrival, std::uint8_t stored,
                             const RuleChoices& choice) {
  const StencilFace& face =
      face_of(*arrival.operations->stencil, arrival.front_facing, choice.output.stencil);
  return fmt::format("fails the stencil test ({} {} {} under mask {})", face.reference,
                     name_of(face.function), stored, face.read_mask);
}

std::string words_of_step(const Arrival& arrival, const FateState& before, const FateState& after,
                          const RuleChoices& choice, DepthFormat format) {
  switch (after.last) {
    case FateStep::none:
      return "";
    case FateStep::dropped:
      return "is left out by alpha to coverage";
    case FateStep::stencil_failed:
      return words_of_stencil(arrival, before.stencil, choice);
    case FateStep::depth_failed:
      return fmt::format("fails the depth test ({:.9g} {} {:.9g})", to_depth(arrival.depth, format),
                         name_of(arrival.operations->depth.function), before.depth);
    case FateStep::passed:
      return fmt::format("{}, ({:.6g})", arrival.operations->blending ? "is blended" : "is written",
                         fmt::join(arrival.color, ", "));
  }
  return "";
}

// "primitive 0, depth 0.25, is written, (1, 0, 0, 1)" of each.
std::vector<std::string> words_of_arrivals(const FateQuestion& question,
                                           const RuleChoices& choice) {
  const Target& target = question.target();
  const Replay replay(target, choice.output, {});
  std::vector<FateState> states{replay.cleared()};
  std::vector<std::string> words;
  for (const Arrival& arrival : question.arrivals(choice)) {
    const FateState before = states.front();
    states = replay.after(states, arrival);
    const std::string depth =
        target.depth == DepthFormat::none ? "" : fmt::format(", depth {:.9g},", arrival.depth);
    words.push_back(
        fmt::format("primitive {}{} {}", arrival.fragment->primitive, depth,
                    words_of_step(arrival, before, states.front(), choice, target.depth)));
  }
  return words;
}

std::string words_of_story(std::vector<std::string> words) {
  if (words.empty()) return "no fragment was drawn there";
  std::string left_out;
  if (words.size() > kMostTold) {
    const std::size_t more = words.size() - kMostTold;
    left_out = fmt::format("{} fragments, then ", more);
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(more));
  }
  return left_out + fmt::format("{}", fmt::join(words, "; "));
}

// The planes that are told, of exact and as they are stored.
struct PlaneWords {
  std::string exact;
  std::string rendered;
  void add(const std::string& one, const std::string& other) {
    exact += (exact.empty() ? "" : ", ") + one;
    rendered += (rendered.empty() ? "" : ", ") + other;
  }
};

PlaneWords words_of_planes(const FateState& exact, const StoredSample& stored) {
  PlaneWords words;
  if (stored.color != nullptr)
    words.add(fmt::format("({})", fmt::join(exact.color, ", ")),
              fmt::format("({})", fmt::join(stored.color, stored.color + 4, ", ")));
  if (stored.depth)
    words.add(fmt::format("depth {:.9g}", exact.depth), fmt::format("depth {:.9g}", *stored.depth));
  if (stored.stencil)
    words.add(fmt::format("stencil {}", exact.stencil), fmt::format("stencil {}", *stored.stencil));
  if (stored.hits)
    words.add(fmt::format("{} passed", exact.hits), fmt::format("{} passed", *stored.hits));
  return words;
}

}  // namespace

std::string explain_fate(const FateQuestion& question, const RuleChoices& chosen) {
  const PlaneWords planes = words_of_planes(question.exact(chosen), question.stored);
  return fmt::format(
      "by the renderer's own fragments the {} should hold {}; it holds {}. In drawing order: {}",
      question.target().samples > 1 ? fmt::format("sample {}", question.sample) : "pixel",
      planes.exact, planes.rendered, words_of_story(words_of_arrivals(question, chosen)));
}

}  // namespace edgecase
