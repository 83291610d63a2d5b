// SPDX-License-Identifier: MIT
//
// WordCapture: the fragments of a scene where shaders cannot write to buffers.
//
// A record (reference/capture.h) without x and y is an array of words. The scene is drawn again for
// each part of it, three bytes, which its fragments write to red, green and blue of the scene's own
// target, as multiples of 1/255: so the rules of that target decide what is drawn, a window's too.
// Alpha has the fragment's tag, its primitive's number mod 255, plus 1, and is 0 where nothing was
// drawn. A part with another tag than the first is of another fragment, which is an error.
//
// Of a pixel's fragments the last one shows. So the parts are drawn layer by layer: an image has
// for each pixel the number of the primitive that was told last, and the fragments of this and of
// later primitives are discarded, until a layer is empty. A primitive that reaches a pixel twice
// is told once, which a count of all hits shows: then there is doubt.
//
// Of a multisampled target the samples are read. The fragments of a pixel in a layer are those of
// the latest primitive there: one for each gl_SampleMaskIn that its samples have.
//
// It does not draw: reference/word_passes.cpp does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "reference/capture.h"
#include "reference/gl_objects.h"

namespace edgecase {

class WordCapture {
 public:
  // The context must be current and outlive the capture.
  explicit WordCapture(const GladGLContext& gl) : gl_(&gl) {}

  // Starts with all fragments of a scene, for a rendering with known size and samples. `form` is
  // that of its records; words that the scene does not request are zeros in them. With
  // `coverage_only`, so are depths and colours.
  void begin(const Scene& scene, Capture::Form form, bool coverage_only,
             const Rendering& rendering);

  // The values of the part uniform for each layer, the first one first.
  const std::vector<int>& parts() const { return parts_; }

  // Takes what was drawn for the first part: RGBA8 of the target, for each sample one plane. False
  // if the layer is empty.
  bool take_first(const std::vector<std::uint8_t>& colors);
  // The same for another part.
  void take(int part, const std::vector<std::uint8_t>& colors);
  // Appends the layer's fragments to the rendering, and hides them from the next one.
  void finish_layer(Rendering& rendering);

  // What contradicts itself up to now, as a sentence; empty if nothing does.
  const std::string& doubt() const { return doubt_; }
  // Why `hits`, the fragments that reach each sample, are not those that were told; empty if there
  // are no more.
  std::string doubt_of_hits(const std::vector<std::uint32_t>& hits) const;

 private:
  // A sample that shows a fragment of the present layer.
  struct Site {
    std::size_t index = 0;  // in the planes
    std::uint8_t tag = 0;
  };

  std::size_t pixel_of(const Site& site) const { return site.index % limits_.size(); }
  std::span<const std::uint32_t> words_at(std::size_t site) const {
    return std::span(words_).subspan(site * stride_, stride_);
  }
  std::string location_of(std::size_t pixel) const;
  void upload_limits();
  void append(std::size_t site, Rendering& rendering) const;
  void append_samples(std::size_t first, std::size_t end, Rendering& rendering);

  const GladGLContext* gl_;
  GlTexture limits_image_;
  int width_ = 0;
  int height_ = 0;
  Capture::Form form_ = Capture::Form::plain;
  Details asked_;
  std::vector<int> parts_;
  std::vector<std::int32_t> limits_;  // by pixel: primitives from this one on are not drawn
  std::vector<std::uint32_t> told_;   // by sample: fragments that were told
  std::vector<Site> sites_;           // by pixel
  std::vector<std::uint32_t> words_;  // of the sites, `stride_` for each
  std::size_t stride_ = 0;
  bool multisampled_ = false;
  std::string doubt_;
};

}  // namespace edgecase
