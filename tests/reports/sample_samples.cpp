// SPDX-License-Identifier: MIT
//
// A multisampled case: a renderer that lacks sample 0 of a pixel, and one that has its samples
// elsewhere.
#include "tests/reports/sample.h"
#include "tests/support/causes.h"

namespace edgecase::sample {
namespace {

constexpr int kWidth = 8;
constexpr int kHeight = 6;
constexpr int kSamples = 4;

std::size_t item(int x, int y, int s) {
  return static_cast<std::size_t>((s * kHeight + y) * kWidth + x);
}

SamplePositions positions(bool mirrored) {
  SamplePositions all;
  for (const auto& [x, y] : {std::pair{6, 2}, {14, 6}, {2, 10}, {10, 14}})
    all.push_back({Fixed::from_raw((mirrored ? 16 - x : x) * Fixed::kOne / 16),
                   Fixed::from_raw(y * Fixed::kOne / 16)});
  return all;
}

// An image whose samples are written one by one.
struct Samples {
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(4 * kSamples * kWidth * kHeight);
  std::vector<std::uint32_t> hits = std::vector<std::uint32_t>(kSamples * kWidth * kHeight);
  std::vector<std::uint32_t> coverage = std::vector<std::uint32_t>(kWidth * kHeight);

  void write(int x, int y, int s, bool covered) {
    hits[item(x, y, s)] = covered ? 1 : 0;
    std::uint32_t& mask = coverage[item(x, y, 0)];
    mask = covered ? mask | 1U << s : mask & ~(1U << s);
    const std::uint8_t colors[2][4] = {{40, 0, 60, 255}, {250, 200, 20, 255}};
    std::copy_n(colors[covered ? 1 : 0], 4,
                pixels.begin() + static_cast<std::ptrdiff_t>(4 * item(x, y, s)));
  }
  SampleImage image(const SamplePositions& positions) const {
    return {kSamples, positions, pixels, hits, coverage};
  }
};

// All samples to the lower right of a diagonal.
Samples below_diagonal(const SamplePositions& positions) {
  Samples samples;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int s = 0; s < kSamples; ++s) {
        const Point& at = positions[static_cast<std::size_t>(s)];
        samples.write(x, y, s, x + at.x.to_double() > y + at.y.to_double());
      }
  return samples;
}

// The mean of each pixel's samples, rounded down.
std::vector<std::uint8_t> resolved(const SampleImage& image) {
  const std::vector<std::uint8_t> samples = image.pixels->bytes();
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        int sum = 0;
        for (int s = 0; s < kSamples; ++s) sum += samples[4 * item(x, y, s) + c];
        pixels.push_back(static_cast<std::uint8_t>(sum / kSamples));
      }
  return pixels;
}

Result shown(const SampleImage& image) {
  Result result;
  result.verdict = Verdict::agree;
  result.samples = image;
  result.pixels = resolved(image);
  return result;
}

Result without_sample_0(Samples samples) {
  samples.write(3, 3, 0, false);
  Result result = shown(samples.image(positions(false)));
  result.verdict = Verdict::violation;
  result.standing = Standing::unexpected;
  Disagreement d = disagreement(3, 3, DisagreementKind::missing, false);
  d.rule = rule_named("triangle.fill-rule");
  d.sample = 0;
  d.figure.marks = {{MarkRole::sample, false, {{3.375, 3.125}}, ""}};
  d.explanation = "exact draws sample 0, the renderer does not.";
  Disagreement whole = disagreement(3, 3, DisagreementKind::value, false);
  whole.rule = RuleId::sample_resolve;
  whole.sample = -1;
  whole.primitive = -1;
  whole.explanation = "the resolved pixel should be the mean of its samples.";
  result.disagreements = {whole, d};
  return result;
}

}  // namespace

CaseResults multisampled_case() {
  const Samples samples = below_diagonal(positions(false));
  const SampleImage exact = samples.image(positions(false));
  CaseResults one;
  one.id = "samples/diagonal";
  one.title = "An edge across four samples";
  one.why = "Each sample is decided by itself.";
  one.rules = {"triangle.fill-rule"};
  one.spec = "GL 4.6 core, 14.3.1";
  one.file = "cases/samples/diagonal.json";
  one.surface = "fbo";
  one.width = kWidth;
  one.height = kHeight;
  one.samples = exact;
  one.pixels = resolved(exact);
  one.fragments = 27;
  const SampleImage mirrored = below_diagonal(positions(true)).image(positions(true));
  Result elsewhere = shown(mirrored);
  elsewhere.exact_samples = mirrored;
  elsewhere.exact_pixels = resolved(mirrored);
  Result silent = shown(exact);
  silent.samples.positions.clear();
  silent.samples.hits = {};
  one.results = {shown(exact), without_sample_0(samples), elsewhere, silent};
  return one;
}

}  // namespace edgecase::sample
