// SPDX-License-Identifier: MIT
//
// Places: how often the shader runs for pixels of a multisampled target, and where it has its
// attributes, as the colours of plane scenes tell.
#pragma once

#include "model/rendering.h"
#include "profile/samples/sample_profile.h"
#include "profile/samples/sample_scenes.h"

namespace edgecase {

InvocationRow empty_row(const InvocationsAsked& asked, int samples);

// Counts the fragments of a plane scene of one triangle.
void add_invocations(const Rendering& rendering, InvocationRow& row);

}  // namespace edgecase
