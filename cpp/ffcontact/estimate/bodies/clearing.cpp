// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/clearing.hpp"

#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// As for a line: what a free component has of a normal at least, and how far vertices
/// move against the largest displacement or gap.
constexpr double along_the_surface = 1e-9, farthest_on_surface = 1e3;

bool is_free(int vertex, int component, double of_normal,
             const Flags& prescribed) {
  return !prescribed[dof_of<3>(vertex, component)] &&
         std::abs(of_normal) > along_the_surface;
}

}  // namespace

bool is_free_along(int vertex, const Vector3d& normal,
                   const Flags& prescribed) {
  for (int c = 0; c < 3; ++c)
    if (is_free(vertex, c, normal[c], prescribed)) return true;
  return false;
}

double largest_clearing(const SurfaceLaw& law,
                        const Ref<const VectorXd>& displacement) {
  return farthest_on_surface * largest_displacement(law, displacement);
}

Vector3d clearing(int vertex, const Ref<const Matrix3Xd>& away,
                  const VectorXd& deep, const Flags& prescribed,
                  double largest) {
  if (deep.maxCoeff() <= 0) return Vector3d::Zero();
  MatrixXd free = away.transpose();
  for (Index k = 0; k < free.rows(); ++k)
    for (int c = 0; c < 3; ++c)
      if (!is_free(vertex, c, free(k, c), prescribed)) free(k, c) = 0;
  const auto change = quadratic_minimum(MatrixXd::Identity(3, 3),
                                        VectorXd::Zero(3), free, deep);
  if (!change || max_norm(*change) > largest) return Vector3d::Zero();
  return *change;
}

}  // namespace ffcontact
