// SPDX-License-Identifier: MIT
#include "model/scene_faults.h"

#include <fmt/format.h>

namespace edgecase {

bool has_whole_chain(const Texture& texture) {
  const TextureLevel& base = texture.levels.front();
  return texture.generated ||
         static_cast<int>(texture.levels.size()) == level_count(base.width, base.height);
}

std::vector<SceneFault> faults_of(const Sampler& sampler, const Texture* texture) {
  std::vector<SceneFault> faults;
  if (sampler.min_lod > sampler.max_lod)
    faults.push_back(
        {fmt::format("min_lod is {}, above max_lod, which is {}", sampler.min_lod, sampler.max_lod),
         "exchange them"});
  if (sampler.max_level < sampler.base_level)
    faults.push_back({fmt::format("max_level is {}, below base_level, which is {}",
                                  sampler.max_level, sampler.base_level),
                      "exchange them"});
  if (texture == nullptr) return faults;
  const bool whole = has_whole_chain(*texture);
  if (sampler.mipmap != MipFilter::none && !whole)
    faults.push_back({fmt::format("the mip filter is \"{}\", and the texture has level 0 alone",
                                  name_of(sampler.mipmap)),
                      "give the texture \"mipmaps\": \"box\" or \"generated\", or \"levels\""});
  const TextureLevel& base = texture->levels.front();
  const int levels = whole ? level_count(base.width, base.height) : 1;
  if (sampler.base_level >= levels)
    faults.push_back(
        {fmt::format("base_level is {}, and the texture has {}", sampler.base_level, levels),
         fmt::format("write 0 to {}", levels - 1)});
  return faults;
}

std::optional<SceneFault> fault_of_passes(const Scene& scene) {
  const std::uint64_t work = pass_work(scene);
  if (work <= kMaxPassWork) return std::nullopt;
  const std::size_t passes = scene.supersampling.size();
  return SceneFault{
      fmt::format("{} passes of {} pixels, generated texels and vertices each are {}", passes,
                  work / passes, work),
      fmt::format("keep the product at {} at most: use a smaller target, or fewer samples",
                  kMaxPassWork)};
}

}  // namespace edgecase
