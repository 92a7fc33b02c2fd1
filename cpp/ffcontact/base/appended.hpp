// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

/// What comes later, behind what is there.
namespace ffcontact {

inline void append(const Ref<const VectorXd>& values, VectorXd& all) {
  const Index before = all.size();
  all.conservativeResize(before + values.size());
  all.tail(values.size()) = values;
}

/// Columns.
template <int rows>
void append(const Matrix<double, rows, Dynamic>& columns,
            Matrix<double, rows, Dynamic>& all) {
  const Index before = all.cols();
  all.conservativeResize(Eigen::NoChange, before + columns.cols());
  all.rightCols(columns.cols()) = columns;
}

}  // namespace ffcontact
