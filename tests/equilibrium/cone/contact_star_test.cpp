// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/contact_star.hpp"

#include "ffcontact/equilibrium/cone/facet_cone.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "support/ridge_groups.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A solid on its side low_z, or the two halves of one.
JointSolid one_or_two(std::mt19937& random) {
  if (random() % 2) return {{irregular_solid(random)}, Matrix3Xd::Zero(3, 1)};
  const CutSolid cut({1, 2, 1}, false, 0.15, random);
  return {cut.pieces(random), Matrix3Xd::Zero(3, 2)};
}

/// One or two solids whose side low_z is in contact, or matches, their other sides free or
/// held, with tractions in the cone, motions and residuals at random.
struct AnyContact {
  Topology<3> topology;
  FacetForms<3> forms;
  FaceTractions boundary;
  HookeTensors<3> hooke;
  BodyLoadsOfCells<3> loads;
  LinearStresses<3> stress;
  std::vector<ContactFacet<3>> contact;
  std::vector<Matrix3d> tractions;
  double
      scale;  ///< of what moves tractions: a small one leaves most in the cone
  Matrix9Xd residual;

  explicit AnyContact(std::mt19937& random)
      : AnyContact(one_or_two(random), random) {}

  AnyContact(const JointSolid& solid, std::mt19937& random)
      : topology(solid.topology),
        forms(topology, HookeTensors<3>(topology.mesh.cell_count(),
                                        isotropic<3>(0.5, 0.4))),
        scale(random() % 2 ? 1 : 1e-3),
        residual(scale * random_matrix(9, topology.facets.count(), random)) {
    const Facets<3>& faces = topology.facets;
    KnownComponents& known = boundary.known;
    known.setConstant(3, faces.count(), false);
    const bool free[] = {false, random() % 2 == 0, random() % 2 == 0};
    const int law = static_cast<int>(random() % 4);
    const bool alone = solid.contact.empty();
    for (int f = 0; f < faces.count(); ++f) {
      if (!faces.on_boundary(f)) continue;
      const int side = topology.mesh.boundary_label[faces.boundary_index[f]];
      const bool is_high_x = side == solid.joined.label(0, high_x) ||
                             side == solid.joined.label(1, high_x);
      for (int c = 0; c < 3; ++c) known(c, f) = !(is_high_x && free[c]);
      if (alone && side == low_z) add(face_at_rest(topology, f), law, random);
    }
    for (const ContactFacet<3>& face : solid.contact) add(face, law, random);
  }

  FacetSetting<3> setting() const {
    return {{topology, hooke, boundary, loads, stress}, contact};
  }

  void add(ContactFacet<3> face, int law, std::mt19937& random) {
    Matrix3d traction;
    for (int i = 0; i < 3; ++i) {
      face.frame[i] << 0, 1, 0, 0, 0, 1, -1, 0, 0;
      if (law > 0) face.cone[i].friction = 0.5;
      if (law == 2) face.cone[i].limit = 0.2;
      if (law == 3) face.cone[i] = {0.3, 0};
      const Vector3d any = random_vector(3, random);
      traction(0, i) = random() % 3 ? -std::abs(any[0]) : 0;
      if (scale < 1) traction(0, i) -= 0.5;
      traction.col(i).tail<2>() = face.cone[i].bound(traction(0, i)) *
                                  (scale < 1 ? 0.5 : 1) * any.tail<2>() /
                                  std::max(1.0, any.tail<2>().norm());
    }
    face.paid = face.cone;
    if (law == 1) face.paid[random() % 3].friction = 5;
    Matrix3d w = 0.1 * scale * random_matrix(3, 3, random);
    w.row(0) = -w.row(0).cwiseAbs();
    face.work = facet_moments_of<3>(w, face.measure);
    Matrix3d slip = Matrix3d::Zero();
    slip.row(0) = w.bottomRows<2>().colwise().norm();
    face.slip = facet_moments_of<3>(slip, face.measure).row(0);
    face.direction = w.bottomRows<2>().colwise().normalized();
    contact.push_back(face);
    tractions.push_back(traction);
  }

  double term() const {
    double sum = 0;
    for (std::size_t m = 0; m < contact.size(); ++m)
      sum += contact_term<3>(contact[m], tractions[m]);
    return sum;
  }
};

RC_GTEST_PROP(ContactStar, lowers_what_it_says_inside_the_cone,
              (Random random)) {
  AnyContact any(random);
  const FacetSetting<3> setting = any.setting();
  const FreeContact<3> contact(setting);
  const KnownComponents known =
      without_contact<3>(any.boundary.known, any.contact);
  int changed = 0;
  for (const RidgeGroup& group : ridge_groups<3>(any.topology, any.contact)) {
    const ContactStar<3> star(any.topology, group, contact, any.forms);
    if (!star.is_free()) continue;
    const VectorXd g = -group_restricted<3>(any.topology, group, any.residual);
    const std::vector<Matrix3d> before = any.tractions;
    const double term = any.term();
    const auto change = star.change(g, {0, 1}, any.tractions);
    if (change.fall == 0) {
      RC_ASSERT(any.tractions == before);
      continue;
    }
    ++changed;
    // e^2 = 2 g'x + x'A x + 2 terms
    const VectorXd& x = change.x;
    const MatrixXd A = group_form<3>(any.topology, group, any.forms);
    const double fall = -2 * g.dot(x) - x.dot(A * x) - 2 * (any.term() - term);
    RC_ASSERT(std::abs(fall - change.fall) < 1e-9 * (1 + fall));
    RC_ASSERT(change.fall > 0);
    // what is known stays
    const FaceMoments moments =
        moments_of_unknowns(any.topology, spread(any.topology, group, x));
    for (int f = 0; f < moments.cols(); ++f)
      for (int row = 0; row < 9; ++row)
        RC_ASSERT(!known(row % 3, f) ||
                  std::abs(moments(row, f)) < 1e-9 * (1 + x.norm()));
    for (std::size_t m = 0; m < any.contact.size(); ++m) {
      RC_ASSERT(cone_violation<3>(any.contact[m], any.tractions[m]) < 1e-12);
      const Matrix3d moved =
          before[m] + traction_on<3>(any.contact[m], moments);
      RC_ASSERT((moved - any.tractions[m]).norm() < 1e-9);
    }
    // nothing is left for the same star, but for what chords cut off a cone
    const VectorXd left = g + A * x;
    const double more = star.change(left, {0, 1}, any.tractions).fall;
    bool inside = true;
    for (std::size_t m = 0; m < any.contact.size(); ++m)
      for (int i = 0; i < 3; ++i) {
        const auto r = any.tractions[m].col(i);
        const double bound = any.contact[m].cone[i].bound(r[0]);
        if (any.tractions[m] != before[m])
          inside = inside && r[0] < -1e-3 && r.tail<2>().norm() < 0.9 * bound &&
                   any.contact[m].cone[i].limit > 1;
      }
    // a free minimum is one along x, too
    if (inside) RC_ASSERT(std::abs(x.dot(A * x) - fall) < 1e-7 * fall + 1e-15);
    if (inside || any.contact[0].cone[0].frictionless())
      RC_ASSERT(more < 1e-7 * fall + 1e-15);
    any.tractions = before;
  }
  RC_ASSERT(changed > 0);
}

}  // namespace
}  // namespace ffcontact
