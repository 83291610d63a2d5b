// SPDX-License-Identifier: MIT
#include "rules/coverage/line_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "rules/coverage/loose_segment.h"

namespace edgecase {
namespace {

// The position of a pixel along a line: its column (row, if y-major), growing in the line's
// direction.
class Direction {
 public:
  explicit Direction(const Segment& segment)
      : x_major_(segment.x_major()),
        forward_(x_major_ ? segment.b.x > segment.a.x : segment.b.y > segment.a.y) {}

  int along(PixelPosition p) const {
    const int major = x_major_ ? p.x : p.y;
    return forward_ ? major : -major;
  }
  const char* column() const { return x_major_ ? "column" : "row"; }
  // The column (row) at a position along the line.
  int number_of(int along) const { return forward_ ? along : -along; }

 private:
  bool x_major_;
  bool forward_;
};

// The positions of all pixels along a line, sorted.
std::vector<int> places_along(std::span<const PixelPosition> pixels, const Direction& direction) {
  std::vector<int> places;
  for (PixelPosition p : pixels) places.push_back(direction.along(p));
  std::sort(places.begin(), places.end());
  return places;
}

std::string common_pixel(const DrawnSegment& first, const DrawnSegment& second) {
  for (PixelPosition p : first.drawn)
    if (std::find(second.drawn.begin(), second.drawn.end(), p) != second.drawn.end())
      return fmt::format("pixel ({}, {}) is drawn by both segments of a joint", p.x, p.y);
  return "";
}

// True if some fragments of the two segments are at most a unit apart in x and in y.
bool meet(const DrawnSegment& first, const DrawnSegment& second) {
  for (PixelPosition a : first.drawn)
    for (PixelPosition b : second.drawn)
      if (std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1) return true;
  return false;
}

// True if the diamond-exit rule has a fragment at this position along the line for all ends within
// reach, and the target cannot hide it, nor one that is a unit off.
bool must_be_seen(const LooseSegment& loose, int along, const Direction& direction,
                  const PixelBounds& bounds) {
  const auto pixels = certain_pixels(loose, bounds.grown(-1));
  return std::any_of(pixels.begin(), pixels.end(),
                     [&](PixelPosition p) { return direction.along(p) == along; });
}

// True if the target may hide a fragment of the segment at one of these positions along the line:
// one of the diamond-exit rule for some ends within reach, or one that is a unit off.
bool may_be_hidden(const LooseSegment& loose, int from, int to, const Direction& direction,
                   const PixelBounds& bounds) {
  const auto pixels = possible_pixels(loose, bounds.grown(2));
  return std::any_of(pixels.begin(), pixels.end(), [&](PixelPosition p) {
    const int along = direction.along(p);
    return along >= from && along <= to && !bounds.grown(-1).contains(p);
  });
}

bool may_be_hidden(const LooseSegment& loose, const PixelBounds& bounds) {
  constexpr int kAnywhere = 2 * static_cast<int>(Fixed::kMaxCoordinate);
  return may_be_hidden(loose, -kAnywhere, kAnywhere, Direction(loose.segment), bounds);
}

}  // namespace

bool goes_on(const Segment& first, const Segment& second, Fixed reach) {
  if (first.b != second.a || first.a == first.b || second.a == second.b) return false;
  const LooseSegment one{first, reach};
  const LooseSegment other{second, reach};
  // A segment with a certain major axis is longer along it than its ends can move.
  const bool same_axis = (surely_x_major(one) && surely_x_major(other)) ||
                         (surely_y_major(one) && surely_y_major(other));
  if (!same_axis) return false;
  return first.x_major() ? (first.b.x > first.a.x) == (second.b.x > second.a.x)
                         : (first.b.y > first.a.y) == (second.b.y > second.a.y);
}

std::string broken_joint_clause(const DrawnSegment& first, std::span<const Segment> between,
                                const DrawnSegment& second, Fixed reach) {
  const PixelBounds bounds{std::max(first.bounds.x_min, second.bounds.x_min),
                           std::max(first.bounds.y_min, second.bounds.y_min),
                           std::min(first.bounds.x_max, second.bounds.x_max),
                           std::min(first.bounds.y_max, second.bounds.y_max)};
  // A segment between, which may have drawn hidden fragments, has joints of its own.
  for (const Segment& segment : between)
    if (may_be_hidden({segment, reach}, bounds)) return "";
  if (std::string clause = common_pixel(first, second); !clause.empty()) return clause;
  const Direction direction(first.segment);
  const int last = places_along(first.drawn, direction).back();
  const int next = places_along(second.drawn, direction).front();

  std::vector<Segment> segments{first.segment};
  segments.insert(segments.end(), between.begin(), between.end());
  segments.push_back(second.segment);
  for (int along = last + 1; along < next; ++along)
    for (const Segment& segment : segments)
      if (must_be_seen({segment, reach}, along, direction, bounds))
        return fmt::format("{} {} is empty between the two segments of a joint", direction.column(),
                           direction.number_of(along));

  // The visible fragments next to the joint are adjacent to it if nothing there is hidden.
  const bool side_by_side = next <= last + 1;
  const bool is_seen = std::none_of(segments.begin(), segments.end(), [&](const Segment& segment) {
    return may_be_hidden({segment, reach}, std::min(last, next) - 1, std::max(last, next) + 1,
                         direction, bounds);
  });
  if (side_by_side && is_seen && !meet(first, second))
    return fmt::format(
        "the fragments of {}s {} and {}, where a joint lies, are more than one apart",
        direction.column(), direction.number_of(last), direction.number_of(next));
  return "";
}

Rule line_joint_rule() {
  Rule rule;
  rule.id = RuleId::line_joint;
  rule.title = "Connected segments of one direction make one line: no fragment twice, no gap";
  rule.spec = "14.5.1 (basic line segment rasterization)";
  rule.latitude = "anything where connected segments differ in major axis or direction";
  rule.rulings = {
      {14,
       "Joints of lines of width 1: where one segment ends bit-identically where another starts, "
       "and both have the same major axis (45 degrees counts as x-major) and direction, as given "
       "and as read under ruling 1, no pixel is drawn by both, no column (row, if y-major) "
       "between their fragments is empty, and the fragments next to the joint are at most one "
       "unit apart. Segments that draw nothing are skipped, if their diamond-exit fragments lie "
       "one unit or more inside the target's border: others may have drawn fragments that are "
       "not seen. An empty column counts if that rule has a fragment as far inside, and the "
       "distance next to the joint counts if all its fragments there are as far inside. Two "
       "fragments in one column, one of each segment, interrupt nothing and are allowed. Two "
       "segments that start at one point, or that turn, may draw a pixel twice."}};
  return rule;
}

}  // namespace edgecase
