// SPDX-License-Identifier: MIT
#include "run/invariant_renderer.h"

#include <fmt/format.h>

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diff/invariance.h"
#include "model/fnv.h"

namespace edgecase {
namespace {

// One scene with all that is asked for it.
struct Question {
  std::size_t task = 0;  // its index
  std::vector<SceneImage> images;
  std::size_t asked = 0;  // requests that belong to it
};

// A request: the scene of a task, or one of an image.
struct Request {
  Question* question = nullptr;
  const SceneImage* image = nullptr;  // null: the scene itself
  bool is_second = false;             // of the image's scenes
};

bool is_not_asked(const Failure& failure) {
  return failure.kind == FailureKind::unsupported || failure.kind == FailureKind::unavailable;
}

}  // namespace

void InvariantRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  std::deque<Question> questions;
  std::vector<Request> requests;
  std::vector<Task> all;
  std::deque<std::string> ids;
  const auto ask = [&](const Request& request, const std::string& id, const Scene& scene) {
    ids.push_back(id);
    Task task = tasks[request.question->task];
    task.id = ids.back();
    const SceneImage* const image = request.image;
    if (image != nullptr && !image->has_values && !image->has_pixels) task.coverage_only = true;
    task.scene = &scene;
    all.push_back(std::move(task));
    requests.push_back(request);
    ++request.question->asked;
  };
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    Question& question = questions.emplace_back(Question{
        i,
        tasks[i].with_images ? images_of(*tasks[i].scene, suggested_) : std::vector<SceneImage>{},
        0});
    ask({&question, nullptr, false}, tasks[i].id, *tasks[i].scene);
    std::shared_ptr<const Scene> first;
    for (const SceneImage& image : question.images) {
      const std::string id = fmt::format("{}~{}", tasks[i].id, &image - question.images.data() + 1);
      if (image.first && image.first != first)
        ask({&question, &image, false}, id + "a", *image.first);
      first = image.first;
      ask({&question, &image, true}, id, image.second);
    }
  }
  Outcome outcome;                  // of the scene
  std::optional<Rendering> before;  // of the first scene of an image
  std::size_t left = 0;             // requests of the scene
  std::uint64_t digest = 0;
  bool has_digest = true;
  inner_->render(all, [&](std::size_t index, Outcome own) {
    const auto& [question, image, is_second] = requests[index];
    if (image == nullptr) {
      left = question->asked;
      digest = kFnvStart;
      has_digest = true;
    }
    const std::uint64_t of_own = inner_->outcome_digest();
    digest = fnv_step(digest, of_own);
    has_digest = has_digest && of_own != 0;
    if (image == nullptr) {
      outcome = std::move(own);
    } else if (auto* rendering = std::get_if<Rendering>(&outcome)) {
      auto* const drawn = std::get_if<Rendering>(&own);
      const auto* const failure = std::get_if<Failure>(&own);
      if (failure != nullptr && !is_not_asked(*failure)) {
        outcome = Failure{failure->kind,
                          fmt::format("of the scene as it {}: {}", image->text, failure->reason)};
      } else if (!is_second) {
        before.reset();
        if (drawn != nullptr) before = std::move(*drawn);
      } else if (drawn != nullptr && (!image->first || before)) {
        find_variances(*image, image->first ? *before : *rendering, *drawn, rendering->variances);
        ++rendering->images.drawn;
      } else {
        ++rendering->images.refused;
      }
    }
    if (--left > 0) return;
    digest_ = has_digest ? digest : 0;
    sink(question->task, std::move(outcome));
  });
}

}  // namespace edgecase
