// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/edge_form.hpp"

namespace ffcontact {

namespace {

/// Which face of a tetrahedron.
int local_face(const Facets<3>& faces, int face, int cell) {
  int k = 0;
  while (faces.of_cell(k, cell) != face) ++k;
  return k;
}

WrenchShift shift_at(const SolidTopology& topology, int edge, int place) {
  return wrench_shift(topology, topology.edges.facets_of(edge)[place], edge);
}

/// Z_i' H Z_j, Z = diag(s Shift, I) of a face, Shift = (I, 0; -arm x, ratio I).
Matrix9d shifted(const WrenchShift& rows, Matrix9d H,
                 const WrenchShift& columns) {
  H.topRows<3>() += cross_product_with(rows.arm) * H.middleRows<3>(3);
  H.topRows<3>() *= rows.sign;
  H.middleRows<3>(3) *= rows.sign * rows.ratio;
  H.leftCols<3>() -= H.middleCols<3>(3) * cross_product_with(columns.arm);
  H.leftCols<3>() *= columns.sign;
  H.middleCols<3>(3) *= columns.sign * columns.ratio;
  return H;
}

}  // namespace

int unknowns_around(const Hinges<3>& edges, int edge) {
  return 6 + 3 * edges.facet_count(edge);
}

std::vector<int> faces_around(const Hinges<3>& edges, int edge) {
  const auto faces = edges.facets_of(edge);
  return {faces.begin(), faces.end()};
}

std::vector<Wedge> wedges_of(const SolidTopology& topology, int edge) {
  const auto& [mesh, faces, edges, stars] = topology;
  const auto around = edges.facets_of(edge);
  const int count = edges.facet_count(edge);
  std::vector<Wedge> wedges;
  wedges.reserve(count);
  for (int b = 1; b < count; ++b)
    for (int t : faces.cells.col(around[b]))
      for (int a = 0; a < b && t >= 0; ++a) {
        const int face = around[a];
        if (faces.cells(0, face) == t || faces.cells(1, face) == t)
          wedges.push_back(
              {t,
               {a, b},
               {local_face(faces, face, t), local_face(faces, around[b], t)}});
      }
  return wedges;
}

MatrixXd edge_form(const SolidTopology& topology, int edge,
                   const FaceForms& forms) {
  const int size = unknowns_around(topology.edges, edge);
  std::vector<WrenchShift> shifts;
  for (int i = 0; i < topology.edges.facet_count(edge); ++i)
    shifts.push_back(shift_at(topology, edge, i));
  MatrixXd A = MatrixXd::Zero(size, size);  // its lower triangle at first
  for (const auto& [cell, place, local] : wedges_of(topology, edge)) {
    const auto block = [&, t = cell](int k, int l) {
      return forms.block(t, k, l).cast<double>().eval();
    };
    const int a = place[0], b = place[1], bars_a = 6 + 3 * a,
              bars_b = 6 + 3 * b;
    const Matrix9d aa =
                       shifted(shifts[a], block(local[0], local[0]), shifts[a]),
                   ba =
                       shifted(shifts[b], block(local[1], local[0]), shifts[a]),
                   bb =
                       shifted(shifts[b], block(local[1], local[1]), shifts[b]);
    A.topLeftCorner<6, 6>() +=
        aa.topLeftCorner<6, 6>() + bb.topLeftCorner<6, 6>() +
        ba.topLeftCorner<6, 6>() + ba.topLeftCorner<6, 6>().transpose();
    A.block<3, 6>(bars_a, 0) +=
        aa.bottomLeftCorner<3, 6>() + ba.topRightCorner<6, 3>().transpose();
    A.block<3, 6>(bars_b, 0) +=
        bb.bottomLeftCorner<3, 6>() + ba.bottomLeftCorner<3, 6>();
    A.block<3, 3>(bars_a, bars_a) += aa.bottomRightCorner<3, 3>();
    A.block<3, 3>(bars_b, bars_b) += bb.bottomRightCorner<3, 3>();
    A.block<3, 3>(bars_b, bars_a) += ba.bottomRightCorner<3, 3>();
  }
  A.triangularView<Eigen::StrictlyUpper>() = A.transpose();
  return A;
}

MatrixXd edge_conditions(const SolidTopology& topology, int edge,
                         const KnownComponents& known) {
  const Hinges<3>& edges = topology.edges;
  const Facets<3>& faces = topology.faces;
  MatrixXd rows = MatrixXd::Zero(18, unknowns_around(edges, edge));
  int next = 0;
  for (int i = 0; i < edges.facet_count(edge); ++i) {
    const int face = edges.facets_of(edge)[i];
    if (!faces.on_boundary(face)) continue;
    const Matrix3d corners =
        facet_points<3>(topology.mesh, faces.vertices.col(face));
    const Matrix9d V = wrench_basis(corners);
    const Matrix6d shift = shift_at(topology, edge, i).matrix();
    for (int row = 0; row < 9; ++row) {
      if (!known(row % 3, face)) continue;
      rows.block<1, 6>(next, 0) = V.block<1, 6>(row, 0) * shift;
      rows.block<1, 3>(next++, 6 + 3 * i) = V.block<1, 3>(row, 6);
    }
  }
  return rows.topRows(next);
}

VectorXd restricted(const SolidTopology& topology, int edge,
                    const Matrix9Xd& g) {
  const Hinges<3>& edges = topology.edges;
  VectorXd x = VectorXd::Zero(unknowns_around(edges, edge));
  for (int i = 0; i < edges.facet_count(edge); ++i) {
    const auto of_face = g.col(edges.facets_of(edge)[i]);
    x.head<6>() +=
        shift_at(topology, edge, i).transposed_times(of_face.head<6>());
    x.segment<3>(6 + 3 * i) = of_face.tail<3>();
  }
  return x;
}

Vector9d at_place(const SolidTopology& topology, int edge, int place,
                  const VectorXd& x) {
  Vector9d of_face;
  of_face << shift_at(topology, edge, place).times(x.head<6>()),
      x.segment<3>(6 + 3 * place);
  return of_face;
}

}  // namespace ffcontact
