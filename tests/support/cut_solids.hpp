// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

/// Solids cut in pieces, whose faces match where they were cut.
namespace ffcontact::test {

constexpr int cut_label = 7;

/// The tetrahedra of one piece, labelled as a brick, its cuts that are no coordinate
/// planes with a label of their own.
inline SolidMesh piece_of(const SolidMesh& whole,
                          const std::vector<int>& piece_of_cell, int piece) {
  std::vector<int> number(whole.vertex_count(), -1), vertices, cells;
  for (int t = 0; t < whole.cell_count(); ++t)
    if (piece_of_cell[t] == piece) {
      cells.push_back(t);
      for (int v : whole.cells.col(t))
        if (number[v] < 0) {
          number[v] = static_cast<int>(vertices.size());
          vertices.push_back(v);
        }
    }
  SolidMesh mesh;
  mesh.vertices = whole.vertices(Eigen::all, vertices);
  mesh.cells = whole.cells(Eigen::all, cells).unaryExpr([&](int v) {
    return number[v];
  });
  add_boundary(mesh);
  for (Index f = 0; f < mesh.boundary.cols(); ++f) {
    const Matrix3d x = mesh.vertices(Eigen::all, mesh.boundary.col(f));
    const Vector3d size = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    if (size.minCoeff() > 0) mesh.boundary_label[f] = cut_label;
  }
  return mesh;
}

/// The brick (0, 4) x (0, 2) x (-1, 1), its upper half on its lower half, which may be cut
/// in two at x = 2. The cut at z = 0 is a plane; vertices elsewhere are moved.
struct CutSolid {
  SolidMesh whole;
  std::vector<int> piece_of_cell;

  CutSolid(const Vector3i& half_cells, bool lower_is_two, double fraction,
           std::mt19937& random)
      : whole(brick(half_cells + Vector3i(half_cells.x(), 0, half_cells.z()),
                    {4, 2, 2})) {
    whole.vertices.row(2).array() -= 1;
    for (int t = 0; t < whole.cell_count(); ++t) {
      const Vector3d x =
          whole.vertices(Eigen::all, whole.cells.col(t)).rowwise().mean();
      piece_of_cell.push_back(x.z() > 0                   ? 0
                              : lower_is_two && x.x() > 2 ? 2
                                                          : 1);
    }
    const Matrix3Xd before = whole.vertices;
    whole = moved(
        std::move(whole),
        Vector3d(2, 2, 1).cwiseQuotient(half_cells.cast<double>()).minCoeff(),
        fraction, random);
    for (int v = 0; v < whole.vertex_count(); ++v)
      if (before(2, v) == 0) whole.vertices(2, v) = 0;
  }

  int piece_count() const {
    return 1 + *std::max_element(piece_of_cell.begin(), piece_of_cell.end());
  }
  /// In random order.
  std::vector<SolidMesh> pieces(std::mt19937& random) const {
    std::vector<SolidMesh> all;
    for (int k = 0; k < piece_count(); ++k)
      all.push_back(shuffled(piece_of(whole, piece_of_cell, k), random));
    return all;
  }
};

/// A contact face where nothing moves, along x, y, z.
inline ContactFacet<3> face_at_rest(const Topology<3>& topology, int face) {
  ContactFacet<3> contact;
  contact.facet = face;
  contact.opposite_corner.setZero();
  contact.measure = facet_measure(topology.mesh, topology.facets, face);
  contact.frame.fill(Matrix3d::Identity());
  contact.work.setZero();
  contact.slip.setZero();
  contact.direction.setZero();
  return contact;
}

/// Pieces of a solid as one mesh, each moved, and the faces at which they match: those of
/// the piece with the lower number carry the contact tractions.
struct JointSolid {
  JoinedSolids joined;
  Topology<3> topology;
  std::vector<ContactFacet<3>> contact;  ///< at rest

  JointSolid(std::vector<SolidMesh> pieces, const Matrix3Xd& shift) {
    Matrix3Xd before(3, 0);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      Matrix3Xd& x = pieces[k].vertices;
      before.conservativeResize(3, before.cols() + x.cols());
      before.rightCols(x.cols()) = x;
      x.colwise() += shift.col(static_cast<Index>(k));
    }
    joined = joined_mesh(pieces);
    topology = topology_of(joined.mesh);
    find_contact(before);
  }

 private:
  void find_contact(const Matrix3Xd& before) {
    const Facets<3>& faces = topology.facets;
    for (int f = 0; f < faces.count(); ++f)
      for (int g = f + 1; g < faces.count(); ++g) {
        if (!faces.on_boundary(f) || !faces.on_boundary(g)) continue;
        const Matrix3d x = before(Eigen::all, faces.vertices.col(f)),
                       y = before(Eigen::all, faces.vertices.col(g));
        if ((x - y).rowwise().sum().norm() > 1e-6) continue;
        ContactFacet<3> face = face_at_rest(topology, f);
        face.index = static_cast<int>(contact.size());
        face.opposite = g;
        for (int k = 0; k < 3; ++k)
          (y.colwise() - x.col(k))
              .colwise()
              .norm()
              .minCoeff(&face.opposite_corner[k]);
        contact.push_back(face);
      }
  }
};

}  // namespace ffcontact::test
