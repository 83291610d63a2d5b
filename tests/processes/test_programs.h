// SPDX-License-Identifier: MIT
//
// A folder of small programs that behave or misbehave, for the tests of renderers in processes.
#pragma once

#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "processes/process_renderer.h"

namespace edgecase {

// What every Python program starts with: `answer` answers a request with the clear colour.
inline constexpr const char* kPrelude = R"(
import json, os, signal, sys, time
def answer(request, **more):
    target = request["scene"]["target"]
    pixels = [round(255 * c) for c in target["clear"]] * (target["width"] * target["height"])
    print(json.dumps({"digest": request["digest"], "pixels": pixels, "fragments": [], **more}),
          flush=True)
def requests():
    return map(json.loads, sys.stdin)
)";

inline Scene scene_of(int width, int height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.target.clear = {0, 0, 1, 1};
  scene.viewport = {0, 0, width, height};
  return scene;
}

// A scene whose request is more than a pipe holds: about 10 MB.
inline Scene big_scene() {
  Scene scene = scene_of(4, 4);
  Draw draw;
  draw.vertices.resize(120'000);
  scene.draws.push_back(draw);
  return scene;
}

class ProcessRendererTest : public ::testing::Test {
 protected:
  ProcessRendererTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "edgecase-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~ProcessRendererTest() override {
    std::filesystem::remove_all(folder_);
    // Nobody is left behind: neither a running child nor a zombie.
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }

  std::string write(const std::string& name, const std::string& text) {
    const auto path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
  ProcessSpec python(const std::string& body) {
    ProcessSpec spec;
    spec.name = "exec:test";
    spec.command.argv = {EDGECASE_PYTHON, write("program.py", kPrelude + body)};
    spec.timeout = std::chrono::milliseconds(5000);
    return spec;
  }
  ProcessSpec shell(const std::string& body) {
    ProcessSpec spec;
    spec.name = "exec:test";
    spec.command.argv = {"sh", write("program.sh", body)};
    spec.timeout = std::chrono::milliseconds(5000);
    return spec;
  }
  // How often the program started, by the lines of a file that each start adds to.
  std::string count_start() const { return "echo >> " + (folder_ / "starts").string() + "\n"; }
  std::size_t starts() const {
    std::error_code none;
    const auto size = std::filesystem::file_size(folder_ / "starts", none);
    return none ? 0 : static_cast<std::size_t>(size);
  }

  std::filesystem::path folder_;
};

inline std::vector<Outcome> render(Renderer& renderer, const std::vector<Scene>& scenes) {
  std::vector<Task> tasks;
  for (const Scene& scene : scenes) tasks.push_back({"test", &scene});
  std::vector<Outcome> outcomes;
  renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
    EXPECT_EQ(index, outcomes.size());
    outcomes.push_back(std::move(outcome));
  });
  EXPECT_EQ(outcomes.size(), scenes.size());
  return outcomes;
}

inline bool is_rendering(const Outcome& outcome) {
  return std::holds_alternative<Rendering>(outcome);
}

inline std::string kind_of(const Outcome& outcome) {
  const auto* failure = std::get_if<Failure>(&outcome);
  return failure == nullptr ? "rendering" : name_of(failure->kind);
}

inline std::string reason_of(const Outcome& outcome) {
  const auto* failure = std::get_if<Failure>(&outcome);
  return failure == nullptr ? "" : failure->reason;
}

inline std::size_t open_descriptors() {
  std::size_t count = 0;
  DIR* folder = opendir("/proc/self/fd");
  while (readdir(folder) != nullptr) ++count;
  closedir(folder);
  return count;
}

}  // namespace edgecase
