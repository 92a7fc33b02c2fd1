// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/clearing.hpp"

#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/bodies/smallest_change.hpp"

namespace ffcontact {

namespace {

bool is_free(int vertex, int component, double of_normal,
             const Flags& prescribed) {
  return !prescribed[dof_of<3>(vertex, component)] &&
         std::abs(of_normal) > least_component;
}

}  // namespace

bool is_free_along(int vertex, const Vector3d& normal,
                   const Flags& prescribed) {
  for (int c = 0; c < 3; ++c)
    if (is_free(vertex, c, normal[c], prescribed)) return true;
  return false;
}

double largest_clearing(const ContactLaw<3>& law,
                        const Ref<const VectorXd>& displacement) {
  return farthest * largest_displacement(law, displacement);
}

Vector3d clearing(int vertex, const Ref<const Matrix3Xd>& away,
                  const VectorXd& deep, const Flags& prescribed,
                  double largest) {
  MatrixXd free = away.transpose();
  for (Index k = 0; k < free.rows(); ++k)
    for (int c = 0; c < 3; ++c)
      if (!is_free(vertex, c, free(k, c), prescribed)) free(k, c) = 0;
  return smallest_change(free, deep, largest).value_or(Vector3d::Zero());
}

}  // namespace ffcontact
