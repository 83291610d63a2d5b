// SPDX-License-Identifier: MIT
//
// Facing and fragment operations of a draw, and what a target has for them, as JSON: for src/wire
// alone. Readers throw a Refusal.
//
// Every key is left out where it has its default, so that the line of a scene without any of it is
// what it was before there were such keys.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "wire/scene_values.h"

namespace edgecase::wire {

// Members of the target, each behind a comma: stencil format, and what the buffers are cleared to.
void write_buffers(Output out, const Target& target);
// The inverse; `value` is the target, whose depth format has been read.
void read_buffers(const nlohmann::json& value, const Path& path, Target& target);

// [near, far].
void write_depth_range(Output out, const DepthRange& range);
DepthRange read_depth_range(const nlohmann::json& value, const Path& path);

// Members of a draw, each behind a comma.
void write_operations(Output out, const Draw& draw);
// The inverse; `value` is the draw.
void read_operations(const nlohmann::json& value, const Path& path, Draw& draw);

}  // namespace edgecase::wire
