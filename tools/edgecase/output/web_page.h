// SPDX-License-Identifier: MIT
//
// Pages that draw with the GPU of whatever browser opens them (reference/web): one file each, which
// needs no network.
#pragma once

#include <string>

#include "model/case.h"
#include "suite/case_store.h"

namespace edgecase {

// A page that draws all of the cases and hands back a recording. It holds each case's scene as a
// request has it, and how many fragments exact has at each pixel.
std::string web_suite_page(const CaseStore& cases, const std::string& title);

// A page that draws one case beside what exact draws.
std::string web_show_page(const Case& one);

}  // namespace edgecase
