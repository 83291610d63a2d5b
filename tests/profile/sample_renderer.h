// SPDX-License-Identifier: MIT
//
// The exact rasterizer as a renderer of multisampled targets to measure, and what is found of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "profile/samples/samples.h"
#include "raster/rasterizer.h"
#include "tests/profile/found_traits.h"

namespace edgecase {

using SampleAlter = std::function<void(const Scene&, Rendering&)>;

// Random scenes, of which coverage is inferred: that takes longer than all else.
enum class RandomScenes { all, triangles, none };

// Makes some numbers of samples, has the standard positions reported, and puts something wrong.
class SampleRenderer final : public Renderer {
 public:
  explicit SampleRenderer(Choices rules, SampleAlter alter = {}, std::vector<int> made = {4})
      : alter_(std::move(alter)), made_(std::move(made)) {
    policy_.rules = std::move(rules);
  }
  // The same, refusing other random scenes.
  SampleRenderer with(RandomScenes random) && {
    random_ = random;
    return std::move(*this);
  }
  const RendererInfo& info() const override {
    static const RendererInfo info{"samples", "", "", "samples", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Scene& scene = *tasks[i].scene;
      EXPECT_FALSE(tasks[i].coverage_only);
      EXPECT_EQ(scene.target.surface, Surface::fbo);
      const int samples = scene.target.samples;
      if (std::find(made_.begin(), made_.end(), samples) == made_.end()) {
        sink(i, Failure{FailureKind::unsupported, "not so many"});
        continue;
      }
      if (is_refused(tasks[i].id)) {
        sink(i, Failure{FailureKind::unsupported, "not this test's"});
        continue;
      }
      Rendering rendering = rasterize(scene, policy_, standard_pattern(samples));
      rendering.sample_positions = standard_pattern(samples);
      if (alter_) alter_(scene, rendering);
      sink(i, std::move(rendering));
    }
  }

 private:
  bool is_refused(std::string_view id) const {
    const bool is_line =
        id.starts_with("multisampled-line/") || id.starts_with("multisampled-wide-line/");
    return (random_ != RandomScenes::all && is_line) ||
           (random_ == RandomScenes::none && id.starts_with("multisampled-triangle/"));
  }

  Policy policy_;
  SampleAlter alter_;
  std::vector<int> made_;
  RandomScenes random_ = RandomScenes::all;
};

inline SurfaceFindings findings_of(SampleRenderer renderer, const Choices& found = {},
                                   Surface surface = Surface::fbo) {
  SurfaceFindings before;
  before.choices = found;
  return measured(kSampleSubject, renderer, {1, surface, 100}, std::move(before));
}

// Without random scenes, where coverage is not what is asked.
inline SurfaceFindings plane_findings_of(const Choices& rules, SampleAlter alter = {}) {
  return findings_of(SampleRenderer(rules, std::move(alter)).with(RandomScenes::none));
}

// Those of OpenGL's own rules, measured once.
inline const SurfaceFindings& opengl_findings() {
  static const SurfaceFindings findings = findings_of(SampleRenderer({}));
  return findings;
}

}  // namespace edgecase
