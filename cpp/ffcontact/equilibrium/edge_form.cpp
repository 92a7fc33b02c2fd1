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
  const Hinges<3>& edges = topology.edges;
  return wrench_shift(topology, edges.facet[edges.facet_start[edge] + place],
                      edge);
}

}  // namespace

int unknowns_around(const Hinges<3>& edges, int edge) {
  return 6 + 3 * edges.facet_count(edge);
}

std::vector<Wedge> wedges_of(const SolidTopology& topology, int edge) {
  const auto& [mesh, faces, edges, stars] = topology;
  const int first = edges.facet_start[edge], count = edges.facet_count(edge);
  std::vector<Wedge> wedges;
  for (int b = 1; b < count; ++b)
    for (int t : faces.cells.col(edges.facet[first + b]))
      for (int a = 0; a < b && t >= 0; ++a) {
        const int face = edges.facet[first + a];
        if (faces.cells(0, face) == t || faces.cells(1, face) == t)
          wedges.push_back({t,
                            {a, b},
                            {local_face(faces, face, t),
                             local_face(faces, edges.facet[first + b], t)}});
      }
  return wedges;
}

MatrixXd edge_form(const SolidTopology& topology, int edge,
                   const FaceForms& forms) {
  const int size = unknowns_around(topology.edges, edge);
  MatrixXd A = MatrixXd::Zero(size, size);
  for (const Wedge& wedge : wedges_of(topology, edge)) {
    const Matrix6d shifts[] = {
        shift_at(topology, edge, wedge.place[0]).matrix(),
        shift_at(topology, edge, wedge.place[1]).matrix()};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const Matrix9d H =
            forms.block(wedge.cell, wedge.local[i], wedge.local[j]);
        const int bars_i = 6 + 3 * wedge.place[i],
                  bars_j = 6 + 3 * wedge.place[j];
        const Matrix<double, 6, 9> above =
            shifts[i].transpose() * H.topRows<6>();
        A.topLeftCorner<6, 6>() += above.leftCols<6>() * shifts[j];
        A.block<6, 3>(0, bars_j) += above.rightCols<3>();
        A.block<3, 6>(bars_i, 0) += H.bottomLeftCorner<3, 6>() * shifts[j];
        A.block<3, 3>(bars_i, bars_j) += H.bottomRightCorner<3, 3>();
      }
  }
  return A;
}

MatrixXd edge_conditions(const SolidTopology& topology, int edge,
                         const KnownComponents& known) {
  const Hinges<3>& edges = topology.edges;
  const Facets<3>& faces = topology.faces;
  MatrixXd rows = MatrixXd::Zero(18, unknowns_around(edges, edge));
  int next = 0;
  for (int i = 0; i < edges.facet_count(edge); ++i) {
    const int face = edges.facet[edges.facet_start[edge] + i];
    if (!faces.on_boundary(face)) continue;
    const Matrix3d corners =
        topology.mesh.vertices(Eigen::all, faces.vertices.col(face));
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
    const auto of_face = g.col(edges.facet[edges.facet_start[edge] + i]);
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
