// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checks.hpp"

namespace ffcontact::fuzz {

/// What became of a case.
struct Outcome {
  std::string
      answer;  ///< "judged", "refused: ...", "not solved: ..." as a line of the table
  Finds finds;
};

/// Solves, estimates and judges. Whatever is thrown is caught: a sentence of the library
/// is an answer, anything else a find.
Outcome outcome_of(const Case& problem);

/// A message without its numbers: what finds and refusals are counted by.
std::string without_numbers(const std::string& message);

/// A smaller case with a find of the same check and cause: loads, motions, laws and
/// triangles are taken out while it stays, for 20 seconds at most.
Case shrunk(const Case& problem, const Find& what);

}  // namespace ffcontact::fuzz
