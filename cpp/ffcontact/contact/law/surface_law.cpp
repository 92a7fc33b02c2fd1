// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/surface_law.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

void require_coefficient(const char* name, const VectorXd& values,
                         const ContactSurface& surface) {
  require_size(name, values.size(), surface.node_count());
  require_nonnegative(name, values);
}

/// |P_t + b v_t / |v_t||: 0 where the force is the largest and opposes the slip.
double missed_slip(const Vector2d& Pt, const Vector2d& vt, double bound) {
  return (Pt + bound * vt.stableNormalized()).norm();
}

/// P, v and the cone's c and k relative.
double surface_violation_at(const FrictionCone& cone, const Vector3d& P,
                            const Vector3d& v) {
  if (cone.bonded) return max_norm(v);
  const Vector2d Pt = P.tail<2>(), vt = v.tail<2>();
  const double bound =
      std::min(cone.cohesion - cone.friction * P[0], cone.limit);
  return std::max({P[0], v[0], either_violation(P[0], v[0]), Pt.norm() - bound,
                   either_violation(missed_slip(Pt, vt, bound), vt.norm())});
}

}  // namespace

SurfaceLaw on_layer(SurfaceLaw law, const Ref<const Matrix3Xd>& traction) {
  if (!law.layer.given()) return law;
  law.carried = traction;
  const Matrix3Xd moved = law.layer.given_way(law.carried);
  law.gap = beyond<VectorXd>(law.gap, moved.row(0).transpose());
  law.previous = beyond<Matrix2Xd>(law.previous, moved.bottomRows<2>());
  return law;
}

void require_valid(const SurfaceLaw& law, const ContactSurface& surface) {
  require_valid(law.layer);
  require_coefficient("friction", law.friction, surface);
  if (law.slip_bound.size() > 0)
    require_coefficient("slipbound", law.slip_bound, surface);
  if (law.shear_limit.size() > 0)
    require_coefficient("shear limit", law.shear_limit, surface);
  if (law.gap.size() > 0) {
    require_size("gap", law.gap.size(), surface.node_count());
    require_finite("gap", law.gap);
  }
  if (law.previous.size() > 0) {
    require_size("previous tangential displacement", law.previous.cols(),
                 surface.node_count());
    require_finite("previous tangential displacement", law.previous.reshaped());
  }
}

Matrix3Xd lumped_pressures(const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& force) {
  return force * surface.area.cwiseInverse().asDiagonal();
}

std::vector<FrictionCone> law_cones(const SurfaceLaw& law,
                                    const ContactSurface& surface) {
  std::vector<FrictionCone> cones(surface.node_count());
  for (int i = 0; i < surface.node_count(); ++i) {
    FrictionCone& cone = cones[i];
    if (law.slip_bound.size() > 0)
      cone.cohesion = law.slip_bound[i];
    else
      cone.friction = law.friction[i];
    if (law.shear_limit.size() > 0) cone.limit = law.shear_limit[i];
    cone.bonded = law.bonded;
  }
  return cones;
}

NodalLaw nodal_law(const SurfaceLaw& law, const ContactSurface& surface) {
  NodalLaw nodal{law_cones(law, surface)};
  for (int i = 0; i < surface.node_count(); ++i) {
    nodal.cone[i].cohesion *= surface.area[i];
    nodal.cone[i].limit *= surface.area[i];
  }
  return nodal;
}

Matrix3Xd displacement_against_foundation(
    const ContactSurface& surface, const SurfaceLaw& law,
    const Ref<const VectorXd>& displacement) {
  Matrix3Xd v = contact_components(surface, displacement);
  if (law.gap.size() > 0) v.row(0) -= law.gap.transpose();
  if (law.previous.size() > 0) v.bottomRows<2>() -= law.previous;
  return v;
}

double largest_displacement(const SurfaceLaw& law,
                            const Ref<const VectorXd>& displacement) {
  return std::max(
      {max_norm(displacement), max_norm(law.gap), max_norm(law.previous)});
}

double surface_violation(const NodalLaw& law, const Ref<const VectorXd>& P,
                         const Ref<const VectorXd>& v,
                         const LawScales& scales) {
  if (!P.allFinite() || !v.allFinite()) return infinity;
  const double p_scale = std::max(scales.P, max_norm(P));
  const double p = relative(1, p_scale), length = relative(1, scales.v);
  double largest = 0;
  for (int i = 0; i < law.node_count(); ++i) {
    FrictionCone cone = law.cone[i];
    cone.cohesion *= p;
    if (cone.limit < infinity) cone.limit *= p;
    largest =
        std::max(largest, surface_violation_at(cone, p * P.segment<3>(3 * i),
                                               length * v.segment<3>(3 * i)));
  }
  return largest;
}

}  // namespace ffcontact
