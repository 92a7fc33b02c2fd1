// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/mesh/mesh.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/stopwatch.hpp"
#include "problem/body_dofs.hpp"
#include "problem/contact_type.hpp"

namespace ffcontact::plugin {

/// A system that processes share, as process 0 solves it.
struct SharedSystem {
  ElasticSystem whole;
  decltype(ContactSettings::factorise) factorise;
  VectorXd displacement{};  ///< that was found; empty: none
};

/// A call of contactsolve: its named parameters, and A, b, u of each body.
struct SolveCall {
  Stack stack;
  const NamedArguments& named;
  const std::vector<Expression>&matrix, &load;
  std::vector<KN<double>*> u;
  Stopwatch watch;                 ///< since the call
  SharedSystem* shared = nullptr;  ///< null: A, b, u are those of the whole

  long verbosity() const { return named.verbosity_level(stack); }
};

/// @throws std::invalid_argument  if what the call gives is not of these bodies, or b and
///                                u are exchanged
template <int dim>
ElasticSystem system_of(const SolveCall& call, const BodyDofs& bodies,
                        const SimplexMesh<dim>& mesh);

/// What solver=, maxit=, tol= and initial= say; without initial= it starts from `states`.
ContactSettings settings_of(const SolveCall& call, ContactStates states,
                            int dim);

bool is_same(const ElasticSystem& a, const ElasticSystem& b);

/// The factor of the last solution, where it is one of this system; or null.
template <int d>
std::shared_ptr<const CondensedStiffness> known_stiffness(
    const ContactOf<d>& contact, const ElasticSystem& system) {
  const auto& last = contact.solved;
  if (!last || !is_same(*last->system, system)) return nullptr;
  return last->solution.stiffness;
}

/// The displacement of each body in the script's u.
void write_displacement(const SolveCall& call, const BodyDofs& bodies,
                        const VectorXd& displacement);

/// Results at the nodes, node=, state= and abscissa= of them.
/// @param abscissa  of plane bodies
void put(const SolveCall& call, const std::vector<long>& own_vertex,
         const VectorXd& abscissa, const NodalResults& nodes);

/// 0 open, 1 stick, 2 slip along t (of a solid: in any direction), -2 slip against t.
std::vector<long> state_numbers(const ContactStates& states);

}  // namespace ffcontact::plugin
