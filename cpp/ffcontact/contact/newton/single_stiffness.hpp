// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/linear/single.hpp"

namespace ffcontact {

/// R S R of a condensed relation in single precision, R = diag(S)^-1/2, for steps that are
/// corrected. Its rows stand at places of their own, normal ones first: those that are in
/// use then stand beside each other.
class SingleStiffness {
 public:
  explicit SingleStiffness(const CondensedContact& contact);

  int size() const { return static_cast<int>(row_.size()); }
  /// The primary row 3 i + c at a place.
  int row(int place) const { return row_[place]; }
  /// Of each row, or -1 [3 p].
  int place(int row) const { return place_[row]; }
  /// R at a place.
  double scale(int place) const { return scale_[place]; }

  /// R S R x at all places, the same digits on any number of threads.
  /// @param places  where x is not 0, ascending
  /// @param x       there
  VectorXf product(const std::vector<int>& places, const VectorXf& x) const;

  /// The lower triangle of its rows and columns at some places.
  MatrixXf lower_block(const std::vector<int>& places) const;

 private:
  std::vector<int> row_, place_;
  VectorXd scale_;
  MatrixXf values_;
};

}  // namespace ffcontact
