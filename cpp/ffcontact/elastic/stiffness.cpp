// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/stiffness.hpp"

#include <array>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

template <int dim>
constexpr int dofs_of_cell = dim*(dim + 1);
template <int dim>
using StrainMatrix = Matrix<double, voigt_size<dim>, dofs_of_cell<dim>>;
template <int dim>
using ElementMatrix = Matrix<double, dofs_of_cell<dim>, dofs_of_cell<dim>>;

/// B with eps(u_h) = B u for the dofs of one cell.
template <int dim>
StrainMatrix<dim> strain_matrix(const SimplexMesh<dim>& mesh, int cell) {
  const auto hats = hat_gradients(mesh, cell);
  StrainMatrix<dim> B = StrainMatrix<dim>::Zero();
  for (int k = 0; k <= dim; ++k)
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        B(voigt_place<dim>[i][j], dof_of<dim>(k, i)) = hats(j, k);
  return B;
}

template <int dim>
ElementMatrix<dim> element_stiffness(const SimplexMesh<dim>& mesh,
                                     const VoigtMatrix<dim>& C, int cell) {
  const auto B = strain_matrix(mesh, cell);
  return (signed_volume(mesh, cell) * B.transpose() * C).lazyProduct(B);
}

template <int dim>
std::array<int, dofs_of_cell<dim>> dofs_of(const SimplexMesh<dim>& mesh,
                                           int cell) {
  std::array<int, dofs_of_cell<dim>> dofs;
  for (int k = 0; k <= dim; ++k)
    for (int c = 0; c < dim; ++c)
      dofs[dof_of<dim>(k, c)] = dof_of<dim>(mesh.cells(k, cell), c);
  return dofs;
}

template <class Dofs, class Element>
void add_element(const Dofs& dofs, const Element& element, Triplets& entries) {
  for (std::size_t i = 0; i < dofs.size(); ++i)
    for (std::size_t j = 0; j < dofs.size(); ++j)
      entries.emplace_back(dofs[i], dofs[j], element(i, j));
}

}  // namespace

template <int dim>
RowMatrix stiffness(const SimplexMesh<dim>& mesh,
                    const HookeTensors<dim>& hooke) {
  constexpr std::size_t size = dofs_of_cell<dim>;
  Triplets entries;
  entries.reserve(size * size * mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    add_element(dofs_of(mesh, t), element_stiffness(mesh, hooke[t], t),
                entries);
  const Index n = dim * mesh.vertices.cols();
  return packed<RowMatrix>(n, n, entries);
}

template RowMatrix stiffness(const Mesh&, const HookeTensors<2>&);
template RowMatrix stiffness(const SolidMesh&, const HookeTensors<3>&);

}  // namespace ffcontact
