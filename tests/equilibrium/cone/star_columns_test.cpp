// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/star_columns.hpp"

#include "ffcontact/equilibrium/cone/facing_star.hpp"
#include "support/facing_contact.hpp"

namespace ffcontact {
namespace {

using namespace test;

Matrix9Xd spread(const Topology<3>& topology, const StarColumns<3>& columns,
                 const VectorXd& t) {
  Matrix9Xd all = Matrix9Xd::Zero(9, topology.facets.count());
  for (std::size_t k = 0; k < columns.facet.size(); ++k)
    all.col(columns.facet[k]) = columns.of_facet(static_cast<int>(k)) * t;
  return all;
}

/// H x of all facets.
Matrix9Xd image(const Topology<3>& topology, const FacetForms<3>& forms,
                const Matrix9Xd& x) {
  Matrix9Xd all = Matrix9Xd::Zero(9, x.cols());
  for (int cell = 0; cell < topology.mesh.cell_count(); ++cell) {
    const CellVector<3> of_cell =
        forms.times(cell, unknowns_at<3>(topology.facets, x, cell));
    for (int side = 0; side < 4; ++side)
      all.col(topology.facets.of_cell(side, cell)) +=
          of_cell.segment<9>(9 * side);
  }
  return all;
}

RC_GTEST_PROP(StarColumns, modes_inside_make_the_energy_least,
              (Random random)) {
  const FacingContact facing({0, 0, -1}, 0.5, random);
  const Topology<3>& topology = facing.topology;
  const FacetForms<3> forms(topology, facing.hooke);
  for (const FacingStar<3>& star : facing_stars<3>(topology, facing.contact)) {
    MatrixXd form;
    const StarColumns<3> least =
        with_least_modes<3>(topology, forms, star.columns, form);
    const VectorXd t = random_vector(form.rows(), random);
    const Matrix9Xd x = spread(topology, least, t),
                    Hx = image(topology, forms, x),
                    first = spread(topology, star.columns, t);
    const double energy = x.cwiseProduct(Hx).sum();
    RC_ASSERT(std::abs(t.dot(form * t) - energy) < 1e-4 * energy);
    const double before =
        first.cwiseProduct(image(topology, forms, first)).sum();
    RC_ASSERT(energy < (1 + 1e-6) * before);
    for (int f : least.facet) {
      if (topology.facets.on_boundary(f))
        RC_ASSERT(x.col(f) == first.col(f));
      else
        RC_ASSERT(Hx.col(f).tail<3>().norm() < 1e-4 * (1 + Hx.norm()));
    }
  }
}

RC_GTEST_PROP(StarColumns, are_taken_from_the_residual, (Random random)) {
  const FacingContact facing({0, 0, -1}, 0.5, random);
  const Topology<3>& topology = facing.topology;
  const FacetForms<3> forms(topology, facing.hooke);
  for (const FacingStar<3>& star : facing_stars<3>(topology, facing.contact)) {
    const VectorXd t = random_vector(star.columns.Z.cols(), random);
    const Matrix9Xd g = random_matrix(9, topology.facets.count(), random),
                    x = spread(topology, star.columns, t);
    Matrix9Xd corrections = g, residual = g;
    add_columns<3>(topology, forms, star.columns, t, corrections, residual);
    RC_ASSERT((corrections - g - x).norm() < 1e-12 * (1 + x.norm()));
    const Matrix9Xd Hx = image(topology, forms, x);
    RC_ASSERT((residual - g + Hx).norm() < 1e-10 * (1 + Hx.norm()));
    RC_ASSERT(std::abs(restricted<3>(star.columns, g).dot(t) -
                       g.cwiseProduct(x).sum()) < 1e-10 * (1 + x.norm()));
  }
}

}  // namespace
}  // namespace ffcontact
