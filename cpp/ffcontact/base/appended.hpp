// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

/// What comes later, behind what is there.
namespace ffcontact {

template <class Values, class Value>
void append(const Eigen::MatrixBase<Values>& values,
            Matrix<Value, Dynamic, 1>& all) {
  all.conservativeResize(all.size() + values.size());
  all.tail(values.size()) = values;
}

/// Columns.
template <class Value, int rows>
void append(const Matrix<Value, rows, Dynamic>& columns,
            Matrix<Value, rows, Dynamic>& all) {
  all.conservativeResize(Eigen::NoChange, all.cols() + columns.cols());
  all.rightCols(columns.cols()) = columns;
}

}  // namespace ffcontact
