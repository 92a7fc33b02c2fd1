// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace ffcontact {

// Eigen's types by their own names.
using Eigen::Dynamic;
using Eigen::Index;
using Eigen::Map;
using Eigen::Matrix;
using Eigen::Matrix2d;
using Eigen::Matrix2Xd;
using Eigen::Matrix2Xi;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Matrix3Xi;
using Eigen::Matrix4d;
using Eigen::Matrix4Xd;
using Eigen::MatrixXd;
using Eigen::MatrixXi;
using Eigen::Ref;
using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;
using Eigen::Vector3i;
using Eigen::Vector4d;
using Eigen::Vector4i;
using Eigen::VectorXd;
using Eigen::VectorXi;

/// Vector2d and Matrix2d, or Vector3d and Matrix3d.
template <int dim>
using VectorOf = Matrix<double, dim, 1>;
template <int dim>
using MatrixOf = Matrix<double, dim, dim>;

using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace ffcontact
