// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// |T| sigma grad phi_i on each cell of the star of vertex i.
template <int d>
Matrix<double, d, Dynamic> star_forces(const Topology<d>& topology, int vertex,
                                       const CellStresses<d>& stress) {
  const Stars& stars = topology.stars;
  Matrix<double, d, Dynamic> forces(d, stars.count(vertex));
  for (int k = 0; k < forces.cols(); ++k) {
    const int place = stars.start[vertex] + k, t = stars.cell[place];
    const Matrix<int, d, 1> facet =
        topology.mesh.cells(facet_corners<d>[stars.local[place]], t);
    // |T| grad phi_i = -A n / d of the opposite facet
    const VectorOf<d> gradient =
        facet_vector(facet_points<d>(topology.mesh, facet)) / -d;
    forces.col(k) = traction(stress.col(t), gradient);
  }
  return forces;
}

/// Adds a force on a vertex where no support answers.
template <int d>
void add_force(const VectorOf<d>& force, int vertex,
               NodalResidual<d>& residual) {
  for (int c = 0; c < d; ++c)
    if (!residual.supported(c, vertex)) residual.missing(c, vertex) += force[c];
}

/// Adds a force on a vertex and the moments of the boundary tractions there, whose
/// supports are noted.
template <int d>
void add_with_tractions(VectorOf<d> force, const Topology<d>& topology,
                        int vertex, const FacetTractions<d>& boundary,
                        NodalResidual<d>& residual) {
  for_boundary_facets(topology, vertex, [&](int facet) {
    const int place = topology.facets.place_of(vertex, facet);
    force += boundary.moments.col(facet).template segment<d>(d * place);
    for (int c = 0; c < d; ++c)
      if (!boundary.known(c, facet)) residual.supported(c, vertex) = true;
  });
  add_force<d>(force, vertex, residual);
}

}  // namespace

template <int d>
Matrix<double, d, Dynamic> star_loads(const Topology<d>& topology, int vertex,
                                      const CellStresses<d>& stress,
                                      const BodyLoadsOfCells<d>& body_loads) {
  const Stars& stars = topology.stars;
  Matrix<double, d, Dynamic> loads = star_forces(topology, vertex, stress);
  for (int k = 0; k < loads.cols(); ++k) {
    const int place = stars.start[vertex] + k;
    loads.col(k) -= body_loads.col(stars.cell[place])
                        .template segment<d>(d * stars.local[place]);
  }
  return loads;
}

template <int d>
NodalResidual<d> nodal_residual(const Topology<d>& topology,
                                const CellStresses<d>& stress,
                                const BodyLoadsOfCells<d>& body_loads,
                                const FacetTractions<d>& boundary) {
  const int vertices = topology.mesh.vertex_count();
  NodalResidual<d> residual;
  residual.missing.setZero(d, vertices);
  residual.supported.setConstant(d, vertices, false);
  double scale = max_norm(boundary.moments);
#pragma omp parallel for reduction(max : scale)
  for (int v = 0; v < vertices; ++v) {
    if (topology.stars.count(v) == 0) continue;
    const Matrix<double, d, Dynamic> loads =
        star_loads(topology, v, stress, body_loads);
    scale = std::max(scale, max_norm(loads));
    add_with_tractions<d>(-loads.rowwise().sum(), topology, v, boundary,
                          residual);
  }
  residual.scale = scale;
  return residual;
}

template <int d>
NodalResidual<d> with_forces(NodalResidual<d> residual,
                             const VectorXd& forces) {
  residual.missing.reshaped() +=
      residual.supported.reshaped().select(0, forces);
  residual.scale = std::max(residual.scale, max_norm(forces));
  return residual;
}

template <int d>
NodalResidual<d> less_stress(const Topology<d>& topology,
                             NodalResidual<d> residual,
                             const CellStresses<d>& added) {
#pragma omp parallel for
  for (int v = 0; v < topology.mesh.vertex_count(); ++v) {
    if (topology.stars.count(v) == 0) continue;
    const VectorOf<d> sum = star_forces(topology, v, added).rowwise().sum();
    add_force<d>(-sum, v, residual);
  }
  return residual;
}

template NodalResidual<FFCONTACT_DIMENSION> nodal_residual(
    const Topology<FFCONTACT_DIMENSION>&,
    const CellStresses<FFCONTACT_DIMENSION>&,
    const BodyLoadsOfCells<FFCONTACT_DIMENSION>&,
    const FacetTractions<FFCONTACT_DIMENSION>&);
template NodalResidual<FFCONTACT_DIMENSION> with_forces(
    NodalResidual<FFCONTACT_DIMENSION>, const VectorXd&);
template NodalResidual<FFCONTACT_DIMENSION> less_stress(
    const Topology<FFCONTACT_DIMENSION>&, NodalResidual<FFCONTACT_DIMENSION>,
    const CellStresses<FFCONTACT_DIMENSION>&);
template Matrix<double, FFCONTACT_DIMENSION, Dynamic>
star_loads<FFCONTACT_DIMENSION>(const Topology<FFCONTACT_DIMENSION>&, int,
                                const CellStresses<FFCONTACT_DIMENSION>&,
                                const BodyLoadsOfCells<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
