// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/joint_edge.hpp"

#include <set>

#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "support/cells.hpp"
#include "support/cut_solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Two or three bodies that lie on each other, or apart.
JointSolid any_joint_solid(Random& random) {
  const Vector3i half_cells(1 + random() % 2, 1 + random() % 2,
                            1 + random() % 2);
  const CutSolid cut(half_cells, random() % 2, 0.15, random);
  const Matrix3Xd shift =
      (random() % 2) * random_matrix(3, cut.piece_count(), random);
  return {cut.pieces(random), shift};
}

/// The unknowns of all faces that those of a joint are.
Matrix9Xd spread(const Topology<3>& topology, const JointEdge& joint,
                 const VectorXd& x) {
  Matrix9Xd all = Matrix9Xd::Zero(9, topology.facets.count());
  for (const JointEdge::Part& part : joint.parts) {
    const std::vector<int> faces = facets_around<3>(topology.ridges, part.edge);
    for (std::size_t i = 0; i < faces.size(); ++i)
      all.col(faces[i]) +=
          at_place<3>(topology, part.edge, static_cast<int>(i), part.of(x));
  }
  return all;
}

FaceMoments moments_of_unknowns(const Topology<3>& topology,
                                const Matrix9Xd& unknowns) {
  FaceMoments moments(9, unknowns.cols());
  for (Index f = 0; f < unknowns.cols(); ++f) {
    const Matrix3d corners =
        topology.mesh.vertices(Eigen::all, topology.facets.vertices.col(f));
    moments.col(f) = wrench_basis<3>(corners) * unknowns.col(f);
  }
  return moments;
}

/// The largest force or moment left on a tetrahedron.
double largest_imbalance(const Topology<3>& topology,
                         const FaceMoments& moments) {
  double largest = 0;
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    largest = std::max(
        largest,
        out_of_balance<3>(corners_of(topology.mesh, t),
                          loads_of(topology.mesh, topology.facets, moments, t),
                          CellBodyLoads<3>::Zero())
            .cwiseAbs()
            .maxCoeff());
  return largest;
}

/// On both sides of the faces that match: how far from opposite.
double largest_difference(const JointSolid& solid, const FaceMoments& moments) {
  double largest = 0;
  for (const ContactFace& face : solid.contact)
    for (int k = 0; k < 3; ++k) {
      const Vector3d own = moments.col(face.face).segment<3>(3 * k),
                     opposite = moments.col(face.opposite)
                                    .segment<3>(3 * face.opposite_corner[k]);
      largest = std::max(largest, (own + opposite).norm());
    }
  return largest;
}

RC_GTEST_PROP(JointEdge, corrections_are_balanced_in_all_bodies,
              (Random random)) {
  const JointSolid solid = any_joint_solid(random);
  const Topology<3>& topology = solid.topology;
  const FacetForms<3> forms(
      topology,
      HookeTensors<3>(topology.mesh.cell_count(), isotropic<3>(0.5, 0.4)));
  const std::vector<JointEdge> joints = joint_edges(topology, solid.contact);
  RC_ASSERT(!joints.empty());
  for (const JointEdge& joint : joints) {
    RC_ASSERT(joint.parts.size() >= 2u);
    const VectorXd x = random_vector(joint.size, random);
    const Matrix9Xd unknowns = spread(topology, joint, x);
    const FaceMoments moments = moments_of_unknowns(topology, unknowns);
    RC_ASSERT(largest_imbalance(topology, moments) < 1e-12);
    RC_ASSERT(largest_difference(solid, moments) < 1e-12);
    RC_ASSERT(unknowns.norm() > 0.1 * x.norm());

    double energy = 0;
    for (int t = 0; t < topology.mesh.cell_count(); ++t) {
      const CellVector<3> of_cell =
          unknowns_at<3>(topology.facets, unknowns, t);
      energy += of_cell.dot(forms.times(t, of_cell));
    }
    const MatrixXd A = joint_form(topology, joint, forms);
    RC_ASSERT(std::abs(x.dot(A * x) - energy) < 1e-4 * energy);
    const Matrix9Xd g = random_matrix(9, topology.facets.count(), random);
    RC_ASSERT(std::abs(joint_restricted(topology, joint, g).dot(x) -
                       g.cwiseProduct(unknowns).sum()) < 1e-11);
  }
}

/// Every correction that is balanced and opposite where faces match: 6 + 3 M of them
/// around M faces, those that match counted once.
RC_GTEST_PROP(JointEdge, has_all_faces_around_once, (Random random)) {
  const JointSolid solid = any_joint_solid(random);
  const Topology<3>& topology = solid.topology;
  std::set<int> opposite, edges;
  for (const ContactFace& face : solid.contact) opposite.insert(face.opposite);
  for (const JointEdge& joint : joint_edges(topology, solid.contact)) {
    int own = 0;
    for (const JointEdge::Part& part : joint.parts) {
      RC_ASSERT(edges.insert(part.edge).second);
      for (int face : facets_around<3>(topology.ridges, part.edge))
        own += opposite.count(face) == 0;
    }
    RC_ASSERT(joint.size == 6 + 3 * own);
  }
  for (const ContactFace& face : solid.contact)
    for (int k = 0; k < 3; ++k) {
      RC_ASSERT(edges.count(topology.ridges.of_facet(k, face.face)) == 1u);
      RC_ASSERT(edges.count(topology.ridges.of_facet(k, face.opposite)) == 1u);
    }
}

/// Known tractions of either body stay.
RC_GTEST_PROP(JointEdge, conditions_are_those_of_all_parts, (Random random)) {
  const JointSolid solid = any_joint_solid(random);
  const Topology<3>& topology = solid.topology;
  KnownComponents known;
  known.setConstant(3, topology.facets.count(), false);
  for (int f = 0; f < topology.facets.count(); ++f)
    for (int c = 0; c < 3 && topology.facets.on_boundary(f); ++c)
      known(c, f) = random() % 3 == 0;
  for (const JointEdge& joint : joint_edges(topology, solid.contact)) {
    const VectorXd x = random_vector(joint.size, random);
    const FaceMoments moments =
        moments_of_unknowns(topology, spread(topology, joint, x));
    std::vector<double> expected;
    for (const JointEdge::Part& part : joint.parts)
      for (int face : facets_around<3>(topology.ridges, part.edge))
        for (int row = 0; row < 9; ++row)
          if (known(row % 3, face)) expected.push_back(moments(row, face));
    const VectorXd found = joint_conditions(topology, joint, known) * x;
    RC_ASSERT(found.size() == static_cast<Index>(expected.size()));
    for (Index i = 0; i < found.size(); ++i)
      RC_ASSERT(std::abs(found[i] - expected[i]) < 1e-12);
  }
}

}  // namespace
}  // namespace ffcontact
