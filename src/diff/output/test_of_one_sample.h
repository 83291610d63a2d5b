// SPDX-License-Identifier: MIT
//
// Tests of one sample for all (ruling 35; GL 4.6 core, 17.3.10).
//
// While GL_MULTISAMPLE is disabled, an implementation may choose a sample that it calls the
// centermost, and test a fragment's depth and stencil at that sample alone. All samples of the
// pixel then share the outcome: all get the new stencil value, and all or none get colour and
// depth. So what a sample holds depends on what the tested sample has stored before.
#pragma once

#include <span>

#include "diff/output/operations_question.h"

namespace edgecase {

// True if fragments of the pixel may be tested so: a draw without GL_MULTISAMPLE has a test that
// can fail, or changes stencil values.
bool may_test_one_sample(std::span<const OperationsQuestion> pixel);

// True if each sample of the pixel may hold what it does where every fragment of a draw without
// GL_MULTISAMPLE is tested at sample `tested` alone. `pixel`: one question for each sample.
bool agrees_by_test_of(std::span<const OperationsQuestion> pixel, int tested);

}  // namespace edgecase
