// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "parallel/shared_bodies.hpp"
#include "problem/nodal_results.hpp"

namespace ffcontact::plugin {

/// The contact nodes at the vertices of one process's parts, and what a solution left
/// there.
struct ShownNodes {
  std::vector<long> own_vertex, first_node, side;
  VectorXd abscissa;  ///< of plane bodies
  MatrixXd normal;    ///< [dim x nodes]
  std::optional<NodalResults> solved;
};

/// What a process knows of a contact that processes share; process 0 has the problem and
/// its solution besides.
struct SharedContact {
  std::shared_ptr<Team> team;
  std::optional<SharedBodies<2>> plane;
  std::optional<SharedBodies<3>> solid;  ///< one of them is there
  ShownNodes shown;

  int body_count() const {
    return plane ? plane->own.body_count() : solid->own.body_count();
  }
};

template <int dim>
SharedBodies<dim>& bodies_of(SharedContact& shared) {
  if constexpr (dim == 2)
    return *shared.plane;
  else
    return *shared.solid;
}

}  // namespace ffcontact::plugin
