// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// Values of more nodes, behind those of others.
inline void append(const VectorXd& values, VectorXd& all) {
  const Index before = all.size();
  all.conservativeResize(before + values.size());
  all.tail(values.size()) = values;
}

/// Columns of more edges, behind those of others.
inline void append(const Matrix2Xd& values, Matrix2Xd& all) {
  const Index before = all.cols();
  all.conservativeResize(Eigen::NoChange, before + values.cols());
  all.rightCols(values.cols()) = values;
}

}  // namespace ffcontact::plugin
