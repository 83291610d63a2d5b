// SPDX-License-Identifier: MIT
#include "model/texture.h"

#include <algorithm>

#include "model/name_table.h"

namespace edgecase {
namespace {

constexpr Named<TextureFormat> kFormats[] = {{TextureFormat::rgba8, "rgba8"},
                                             {TextureFormat::srgb8, "srgb8"},
                                             {TextureFormat::rgba32f, "rgba32f"}};
constexpr Named<Wrap> kWraps[] = {{Wrap::repeat, "repeat"},
                                  {Wrap::mirrored_repeat, "mirrored-repeat"},
                                  {Wrap::clamp_to_edge, "clamp-to-edge"},
                                  {Wrap::clamp_to_border, "clamp-to-border"}};
constexpr Named<Filter> kFilters[] = {{Filter::nearest, "nearest"}, {Filter::linear, "linear"}};
constexpr Named<MipFilter> kMipFilters[] = {
    {MipFilter::none, "none"}, {MipFilter::nearest, "nearest"}, {MipFilter::linear, "linear"}};
constexpr Named<LookupKind> kLookups[] = {{LookupKind::implicit, "implicit"},
                                          {LookupKind::bias, "bias"},
                                          {LookupKind::lod, "lod"},
                                          {LookupKind::gradients, "gradients"}};

}  // namespace

int level_size(int size, int level) {
  return level < 31 ? std::max(1, size >> level) : 1;
}

int level_count(int width, int height) {
  int count = 1;
  for (int size = std::max(width, height); size > 1; size /= 2) ++count;
  return count;
}

const char* name_of(TextureFormat value) {
  return find_name(kFormats, value);
}
const char* name_of(Wrap value) {
  return find_name(kWraps, value);
}
const char* name_of(Filter value) {
  return find_name(kFilters, value);
}
const char* name_of(MipFilter value) {
  return find_name(kMipFilters, value);
}
const char* name_of(LookupKind value) {
  return find_name(kLookups, value);
}

bool parse_name(const std::string& name, TextureFormat& value) {
  return find_value(kFormats, name, value);
}
bool parse_name(const std::string& name, Wrap& value) {
  return find_value(kWraps, name, value);
}
bool parse_name(const std::string& name, Filter& value) {
  return find_value(kFilters, name, value);
}
bool parse_name(const std::string& name, MipFilter& value) {
  return find_value(kMipFilters, name, value);
}
bool parse_name(const std::string& name, LookupKind& value) {
  return find_value(kLookups, name, value);
}

}  // namespace edgecase
