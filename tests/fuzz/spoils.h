// SPDX-License-Identifier: MIT
//
// Spoils a renderer's answer as lines of JSON have it, in ways that keep it an answer: most spoilt
// ones are still read, and lie.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tests/fuzz/choices.h"

namespace edgecase {

// Leaves out fields that a renderer need not tell, as the choices say.
void tell_less(nlohmann::json& answer, ByteChoices& choices);

// Changes one part of the answer: a number to an extreme or a neighbouring one, or all numbers of a
// plane; elements of a list left out, doubled, exchanged or moved; a member left out.
void spoil(nlohmann::json& answer, ByteChoices& choices);

}  // namespace edgecase
