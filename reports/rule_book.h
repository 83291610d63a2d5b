// SPDX-License-Identifier: MIT
//
// The rule book: a page for each chapter, which teaches its rules, and an index.
//
// Static HTML files without a script that load and send nothing, like a gallery's. Every text is
// escaped. Reports know no rules: the caller supplies the catalogue's texts, and the texts and
// pictures of `edgecase explain`.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "reports/pixel_svg.h"

namespace edgecase {

struct BookAlternative {
  std::string name;
  std::string openness;
  std::string meaning;
};

struct BookRuling {
  int number = 0;
  std::string text;
  std::vector<std::pair<std::string, std::string>> facts;  // name -> text
};

struct BookRule {
  std::string id;
  std::string title;
  std::string spec;
  std::string latitude;
  std::string standard;  // the alternative of policy `opengl`
  std::vector<BookAlternative> alternatives;
  std::string alike;  // id of an earlier rule with the same alternatives; empty: none
  std::vector<BookRuling> rulings;
};

// A case, one of its pixels, and why it is drawn or not.
struct BookScene {
  std::string case_id;
  std::string title;
  std::string why;     // the case's own words
  std::string answer;  // "Drawn by primitive 0", and so on
  bool is_drawn = false;
  std::string words;    // the output of `command` about the pixel
  std::string command;  // as one would type it
  PixelPicture picture;
  std::string rule;  // whose alternatives are compared
  // Alternatives of the rule, including the standard one, that draw the pixel and that do not;
  // shown if there are both.
  std::vector<std::string> drawn_by;
  std::vector<std::string> left_out_by;
};

struct BookSection {
  std::string title;
  std::string essay;  // lines; those that start with a space stay as they are
  std::vector<BookRule> rules;
  std::vector<BookScene> scenes;
};

struct BookChapter {
  std::string name;  // of its file, without suffix
  std::string title;
  std::string about;
  std::vector<BookSection> sections;
};

struct RuleBook {
  std::string tool;
  std::vector<BookChapter> chapters;
};

// The page NAME.html of a chapter, and index.html. The caller checks the stream's state afterwards.
void write_book_chapter(const RuleBook& book, std::size_t chapter, std::ostream& out);
void write_book_index(const RuleBook& book, std::ostream& out);

}  // namespace edgecase
