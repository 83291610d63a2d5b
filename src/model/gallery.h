// SPDX-License-Identifier: MIT
//
// Gallery: the cases that present a policy, with the text beside their pictures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/policy.h"

namespace edgecase {

struct GalleryPicture {
  std::string case_id;  // of a case, or of a case file, which stands for the base case of its sweep
  std::string heading;
  std::string text;  // what to look at; may be empty
  Choices rules;     // deviations from the policy in this picture; usually none
};

struct Gallery {
  std::string title;
  std::string about;
  std::string policy;                // its name
  std::vector<std::string> sources;  // where the system is documented
  // rule id -> the reason for the choice; only rules that the policy chooses.
  std::map<std::string, std::string> choices;
  // rule id -> why no picture shows the choice.
  std::map<std::string, std::string> not_shown;
  std::vector<GalleryPicture> pictures;
};

}  // namespace edgecase
