// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

/// What comes later, behind what is there.
namespace ffcontact {

inline void append(const Ref<const VectorXd>& values, VectorXd& all) {
  all.conservativeResize(all.size() + values.size());
  all.tail(values.size()) = values;
}

/// Columns.
template <int rows>
void append(const Matrix<double, rows, Dynamic>& columns,
            Matrix<double, rows, Dynamic>& all) {
  all.conservativeResize(Eigen::NoChange, all.cols() + columns.cols());
  all.rightCols(columns.cols()) = columns;
}

}  // namespace ffcontact
