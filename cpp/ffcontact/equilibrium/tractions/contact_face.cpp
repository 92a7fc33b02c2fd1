// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/contact_face.hpp"

#include <algorithm>

#include "ffcontact/base/over.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"

namespace ffcontact {

double contact_term(const ContactFace& face, const Matrix3d& traction) {
  return sum_over(3, [&](int i) {
    return face.paid[i].bound(traction(0, i)) * face.slip[i] +
           traction.col(i).dot(face.work.col(i));
  });
}

KnownComponents without_contact(KnownComponents known,
                                const std::vector<ContactFace>& contact) {
  for (const ContactFace& face : contact) {
    known.col(face.face).setConstant(false);
    if (face.opposite >= 0) known.col(face.opposite).setConstant(false);
  }
  return known;
}

Matrix3d traction_of(const ContactFace& face, const Matrix3d& moments) {
  const Matrix3d density = facet_density<3>(moments, face.area);
  Matrix3d traction;
  for (int i = 0; i < 3; ++i)
    traction.col(i) = face.frame[i].transpose() * density.col(i);
  return traction;
}

Matrix3d moments_of(const ContactFace& face, const Matrix3d& traction) {
  Matrix3d density;
  for (int i = 0; i < 3; ++i) density.col(i) = face.frame[i] * traction.col(i);
  return facet_moments_of<3>(density, face.area);
}

double cone_violation(const ContactFace& face, const Matrix3d& traction) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const double rn = traction(0, i), rt = traction.col(i).tail<2>().norm();
    largest = std::max({largest, rn, rt - face.cone[i].bound(rn)});
  }
  return largest;
}

}  // namespace ffcontact
