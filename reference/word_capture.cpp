// SPDX-License-Identifier: MIT
#include "reference/word_capture.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "reference/programs.h"

namespace edgecase {

namespace {

constexpr int kBytesOfPart = 3;
constexpr int kBytesOfWord = 4;

// Words of the shader's array: those of the largest record, and gl_SampleMaskIn.
constexpr std::size_t kPrimitiveWord = 0;
std::size_t samples_word() {
  return words_of(Capture::Form::textured) - kPixelWords;
}

// The words that a scene requests, without those of which nothing is reported.
std::vector<WordRange> requested_words(const Scene& scene, Capture::Form form, bool coverage_only) {
  if (coverage_only) return {{kPrimitiveWord, kPrimitiveWord + 1}};
  std::vector<WordRange> ranges = {{0, words_of(Capture::Form::plain) - kPixelWords}};
  for (const auto& [first, end] : detail_words(form, scene.details))
    ranges.push_back({first - kPixelWords, end - kPixelWords});
  if (scene.target.samples > 1) ranges.push_back({samples_word(), samples_word() + 1});
  return ranges;
}

// The number of the primitive in the first part: 24 bits.
std::uint32_t primitive_of(const std::uint8_t* color) {
  return std::uint32_t{color[0]} | std::uint32_t{color[1]} << 8 | std::uint32_t{color[2]} << 16;
}

}  // namespace

void WordCapture::begin(const Scene& scene, Capture::Form form, bool coverage_only,
                        const Rendering& rendering) {
  const bool fits = width_ == rendering.width && height_ == rendering.height;
  width_ = rendering.width;
  height_ = rendering.height;
  form_ = form;
  asked_ = scene.details;
  multisampled_ = rendering.samples > 1;
  parts_.clear();
  for (const auto& [first, end] : requested_words(scene, form, coverage_only)) {
    stride_ = end;
    const int bytes = static_cast<int>(end) * kBytesOfWord;
    for (int part = static_cast<int>(first) * kBytesOfWord / kBytesOfPart;
         part * kBytesOfPart < bytes; ++part)
      if (parts_.empty() || parts_.back() < part) parts_.push_back(part);
  }
  const std::size_t area = rendering.pixel_index(0, height_);
  limits_.assign(area, std::numeric_limits<std::int32_t>::max());
  told_.assign(area * static_cast<std::size_t>(rendering.samples), 0);
  doubt_.clear();
  gl_->ActiveTexture(GL_TEXTURE0 + kLimitsUnit);
  if (!fits) {
    limits_image_ = make_texture(*gl_);
    gl_->BindTexture(GL_TEXTURE_2D, limits_image_.name());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  upload_limits();
}

void WordCapture::upload_limits() {
  gl_->ActiveTexture(GL_TEXTURE0 + kLimitsUnit);
  gl_->BindTexture(GL_TEXTURE_2D, limits_image_.name());
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R32I, width_, height_, 0, GL_RED_INTEGER, GL_INT,
                  limits_.data());
  gl_->ActiveTexture(GL_TEXTURE0);
}

std::string WordCapture::location_of(std::size_t pixel) const {
  const auto width = static_cast<std::size_t>(width_);
  return fmt::format("({}, {})", pixel % width, pixel / width);
}

bool WordCapture::take_first(const std::vector<std::uint8_t>& colors) {
  sites_.clear();
  const std::size_t area = limits_.size();
  for (std::size_t pixel = 0; pixel < area; ++pixel) {
    const std::size_t before = sites_.size();
    std::uint32_t latest = 0;
    for (std::size_t index = pixel; index < told_.size(); index += area) {
      const std::uint8_t* color = &colors[4 * index];
      if (color[3] == 0) continue;
      const std::uint32_t primitive = primitive_of(color);
      if (sites_.size() > before && primitive < latest) continue;
      if (primitive > latest) sites_.resize(before);
      latest = primitive;
      Site& site = sites_.emplace_back();
      site.index = index;
      site.tag = color[3];
    }
  }
  words_.assign(sites_.size() * stride_, 0);
  take(parts_.front(), colors);
  return !sites_.empty();
}

void WordCapture::take(int part, const std::vector<std::uint8_t>& colors) {
  std::uint32_t* words = words_.data();
  for (const Site& site : sites_) {
    const std::uint8_t* color = &colors[4 * site.index];
    if (color[3] != site.tag && doubt_.empty())
      doubt_ =
          fmt::format("pixel {} was drawn otherwise when asked again", location_of(pixel_of(site)));
    for (int i = 0; i < kBytesOfPart; ++i) {
      const int byte = kBytesOfPart * part + i;
      const auto word = static_cast<std::size_t>(byte / kBytesOfWord);
      if (word < stride_) words[word] |= std::uint32_t{color[i]} << 8 * (byte % kBytesOfWord);
    }
    words += stride_;
  }
}

void WordCapture::append(std::size_t site, Rendering& rendering) const {
  const std::size_t pixel = pixel_of(sites_[site]);
  const auto width = static_cast<std::size_t>(width_);
  const std::span<const std::uint32_t> words = words_at(site);
  std::vector<std::uint32_t> record(kPixelWords + words.size());
  record[0] = static_cast<std::uint32_t>(pixel % width);
  if (multisampled_) record[0] |= words[samples_word()] << 16;
  record[1] = static_cast<std::uint32_t>(pixel / width);
  std::ranges::copy(words, record.begin() + kPixelWords);
  append_record(form_, record, asked_, rendering);
}

// Of the sites from `first` on, which belong to one pixel: those of one invocation are equal.
void WordCapture::append_samples(std::size_t first, std::size_t end, Rendering& rendering) {
  for (std::size_t site = first; site < end; ++site) {
    std::size_t same = first;
    while (words_at(same)[samples_word()] != words_at(site)[samples_word()]) ++same;
    if (same == site)
      append(site, rendering);
    else if (!std::ranges::equal(words_at(same), words_at(site)) && doubt_.empty())
      doubt_ = fmt::format("samples of pixel {} with one gl_SampleMaskIn show several fragments",
                           location_of(pixel_of(sites_[site])));
  }
}

void WordCapture::finish_layer(Rendering& rendering) {
  for (std::size_t first = 0, end = 0; first < sites_.size(); first = end) {
    const std::size_t pixel = pixel_of(sites_[first]);
    while (end < sites_.size() && pixel_of(sites_[end]) == pixel) ++told_[sites_[end++].index];
    if (multisampled_)
      append_samples(first, end, rendering);
    else
      append(first, rendering);
    const auto primitive = static_cast<std::int32_t>(words_at(first)[kPrimitiveWord]);
    if (primitive >= limits_[pixel] && doubt_.empty())
      doubt_ = fmt::format("pixel {} shows a fragment that was discarded", location_of(pixel));
    limits_[pixel] = primitive;
  }
  upload_limits();
}

std::string WordCapture::doubt_of_hits(const std::vector<std::uint32_t>& hits) const {
  const auto found = std::mismatch(hits.begin(), hits.end(), told_.begin(), std::less_equal());
  if (found.first == hits.end()) return "";
  const auto index = static_cast<std::size_t>(found.first - hits.begin());
  return fmt::format(
      "pixel {} has {} hits, and {} fragments: without storage blocks "
      "a primitive's second fragment of a pixel is not told",
      location_of(index % limits_.size()), *found.first, *found.second);
}

}  // namespace edgecase
