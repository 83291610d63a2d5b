// SPDX-License-Identifier: MIT
#include "suite/policy_contrast.h"

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "suite/expectation_check.h"

namespace edgecase {
namespace {

std::string named_alternative(const Policy& policy, Surface surface, const std::string& rule) {
  if (const auto own = policy.surfaces.find(surface); own != policy.surfaces.end())
    if (const auto choice = own->second.find(rule); choice != own->second.end())
      return choice->second;
  const auto choice = policy.rules.find(rule);
  return choice == policy.rules.end() ? "" : choice->second;
}

// Draws a scene with some of a policy's choices put back.
class Trials {
 public:
  Trials(const Scene& scene, const Policy& policy, const SamplePositions& reported,
         const Rendering& wanted)
      : scene_(scene), policy_(policy), reported_(reported), wanted_(wanted) {
    for (const ContrastingChoice& choice : contrasting_choices(policy, scene.target.surface))
      rules_.push_back(choice.rule);
  }

  std::vector<std::string> alone() const {
    std::vector<std::string> found;
    for (const std::string& rule : rules_)
      if (restores({rule})) found.push_back(rule);
    return found;
  }

  std::vector<std::string> together() const {
    for (const std::size_t size : {2U, 3U})
      if (const auto found = first_of(size, 0, {}); !found.empty()) return found;
    return rules_;
  }

 private:
  bool restores(const std::vector<std::string>& rules) const {
    return is_same_picture(rasterize(scene_, with_standard(policy_, rules), reported_), wanted_);
  }

  // The first set of that size that holds `begun` and rules from `next` on; empty: none.
  std::vector<std::string> first_of(std::size_t size, std::size_t next,
                                    const std::vector<std::string>& begun) const {
    if (begun.size() == size) return restores(begun) ? begun : std::vector<std::string>{};
    for (std::size_t i = next; i < rules_.size(); ++i) {
      std::vector<std::string> more = begun;
      more.push_back(rules_[i]);
      if (auto found = first_of(size, i + 1, more); !found.empty()) return found;
    }
    return {};
  }

  const Scene& scene_;
  const Policy& policy_;
  const SamplePositions& reported_;
  const Rendering& wanted_;
  std::vector<std::string> rules_;
};

}  // namespace

std::vector<ContrastingChoice> contrasting_choices(const Policy& policy, Surface surface) {
  std::vector<ContrastingChoice> choices;
  for (const Rule& rule : all_rules()) {
    const std::string alternative = named_alternative(policy, surface, name_of(rule.id));
    if (!alternative.empty() && alternative != rule.standard)
      choices.push_back({name_of(rule.id), alternative, rule.standard});
  }
  return choices;
}

Policy with_standard(const Policy& policy, const std::vector<std::string>& rules) {
  Policy result = policy;
  for (const std::string& id : rules) {
    result.rules[id] = find_rule(id)->standard;
    for (auto& [surface, choices] : result.surfaces) choices.erase(id);
  }
  return result;
}

bool is_same_picture(const Rendering& a, const Rendering& b) {
  return a.pixels == b.pixels && hits_of(a) == hits_of(b);
}

PolicyContrast contrast_with_opengl(const Scene& scene, const Policy& policy,
                                    const SamplePositions& reported) {
  PolicyContrast contrast;
  contrast.under_policy = rasterize(scene, policy, reported);
  contrast.under_opengl = rasterize(scene, {}, reported);
  contrast.is_same = is_same_picture(contrast.under_policy, contrast.under_opengl);
  if (contrast.is_same) return contrast;
  const Trials trials(scene, policy, reported, contrast.under_opengl);
  contrast.alone = trials.alone();
  if (contrast.alone.empty()) contrast.together = trials.together();
  return contrast;
}

}  // namespace edgecase
