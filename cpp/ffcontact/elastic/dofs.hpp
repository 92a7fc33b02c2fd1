// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"

/// The numbering of dofs, FreeFEM's of [P1, P1] and [P1, P1, P1]: component c at vertex v
/// is dof dim v + c.
namespace ffcontact {

/// The space of all components, in FreeFEM's words.
constexpr const char* space_in_words(Index dim) {
  return dim == 2 ? "[P1, P1]" : "[P1, P1, P1]";
}

template <int dim>
constexpr int dof_of(int vertex, int component) {
  return dim * vertex + component;
}

/// All components at one vertex of a vector of dofs.
template <int dim, class Field>
auto vector_at(Field& field, int vertex) {
  return field.template segment<dim>(dof_of<dim>(vertex, 0));
}

/// Those at the corners of a facet, one column each.
template <int dim, class Field, class Vertices>
Matrix<double, dim, dim> vectors_at(const Field& field,
                                    const Vertices& corners) {
  Matrix<double, dim, dim> vectors;
  for (int k = 0; k < dim; ++k)
    vectors.col(k) = vector_at<dim>(field, corners[k]);
  return vectors;
}

/// Unit vectors of the free dofs of a vertex, one column each.
/// @param prescribed  1 where the dof is prescribed [dofs]
template <int dim>
Matrix<double, dim, Dynamic> free_axes(int vertex, const Flags& prescribed) {
  using Axis = VectorOf<dim>;
  std::vector<Axis> axes;
  for (int c = 0; c < dim; ++c)
    if (!prescribed[dof_of<dim>(vertex, c)]) axes.push_back(Axis::Unit(c));
  return packed(axes);
}

}  // namespace ffcontact
