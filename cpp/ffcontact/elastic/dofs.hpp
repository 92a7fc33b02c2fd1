// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

/// The numbering of dofs, FreeFEM's of [P1, P1] and [P1, P1, P1]: component c at vertex v
/// is dof dim v + c.
namespace ffcontact {

template <int dim>
constexpr int dof_of(int vertex, int component) {
  return dim * vertex + component;
}

/// All components at one vertex of a vector of dofs.
template <int dim, class Field>
auto vector_at(Field& field, int vertex) {
  return field.template segment<dim>(dof_of<dim>(vertex, 0));
}

}  // namespace ffcontact
