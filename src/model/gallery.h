// SPDX-License-Identifier: MIT
//
// Gallery: the cases by which a policy is shown, with the words beside their pictures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/policy.h"

namespace edgecase {

struct GalleryPicture {
  std::string case_id;  // of a case, or of a case file: then the base case of its sweep
  std::string heading;
  std::string text;  // what to look at; may be empty
  Choices rules;     // what this picture has otherwise than the policy; usually nothing
};

struct Gallery {
  std::string title;
  std::string about;
  std::string policy;                // its name
  std::vector<std::string> sources;  // where the system is described
  // rule id -> why the system has it so. Only rules that the policy chooses.
  std::map<std::string, std::string> choices;
  // rule id -> why none of the pictures shows it.
  std::map<std::string, std::string> not_shown;
  std::vector<GalleryPicture> pictures;
};

}  // namespace edgecase
