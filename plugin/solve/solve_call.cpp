// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solve_call.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/boundary_vertices.hpp"
//
#include "freefem/progress_lines.hpp"
#include "freefem/views.hpp"
#include "problem/systems.hpp"

namespace ffcontact::plugin {

namespace {

ContactState state_of_number(long number) {
  switch (number) {
    case 0: return ContactState::open;
    case 1: return ContactState::stick;
    case 2: return ContactState::slip_forward;
    case -2: return ContactState::slip_backward;
    default:
      refuse(
          "an initial state must be 0 (open), 1 (stick), 2 or -2 (slip), got ",
          number);
  }
}

bool is_same(const RowMatrix& A, const RowMatrix& B) {
  const auto same = [](const auto* a, const auto* b, Index count) {
    return std::equal(a, a + count, b);
  };
  if (A.rows() != B.rows() || A.nonZeros() != B.nonZeros()) return false;
  return same(A.valuePtr(), B.valuePtr(), A.nonZeros()) &&
         same(A.innerIndexPtr(), B.innerIndexPtr(), A.nonZeros()) &&
         same(A.outerIndexPtr(), B.outerIndexPtr(), A.rows() + 1);
}

/// The vertices inside a body.
template <int dim>
std::vector<int> inner_vertices(const SimplexMesh<dim>& mesh) {
  const Flags on_boundary = boundary_vertices(mesh);
  return numbers_where(mesh.vertex_count(),
                       [&](int v) { return !on_boundary[v]; });
}

/// Are b and u exchanged? Loads on the boundary alone are 0 inside, displacements are
/// not.
template <int dim>
void require_order(const SimplexMesh<dim>& mesh, const VectorXd& load,
                   const VectorXd& displacement) {
  if (!load.isZero(0) || displacement.isZero(0)) return;
  const std::vector<int> inner = inner_vertices(mesh);
  for (int v : inner)
    if (!displacement.segment<dim>(dim * v).isZero(0)) return;
  if (!inner.empty())
    refuse(
        "b is 0 and u is 0 inside the body, but not on its boundary: they are "
        "exchanged, give A, b, u");
}

/// solver=
void put_solver(Stack stack, const NamedArguments& named, int dim,
                ContactSettings& settings) {
  enum class Solver { newton, fixed_point, direct, multigrid };
  const Solver chosen = named.choice(stack, "solver", Solver::newton,
                                     {{"newton", Solver::newton},
                                      {"fixedpoint", Solver::fixed_point},
                                      {"direct", Solver::direct},
                                      {"multigrid", Solver::multigrid}});
  if (chosen == Solver::multigrid && dim == 2)
    refuse(
        "solver=\"multigrid\" is for solids: leave it out, plane bodies are "
        "solved by a factor");
  if (chosen == Solver::fixed_point)
    settings.solver = ContactSolver::fixed_point;
  if (chosen == Solver::direct) settings.linear = LinearSolver::direct;
  if (chosen == Solver::multigrid) settings.linear = LinearSolver::multigrid;
}

}  // namespace

template <int dim>
ElasticSystem system_of(const SolveCall& call, const BodyDofs& bodies,
                        const SimplexMesh<dim>& mesh) {
  bodies.require_bodies("A, b, u", call.matrix.size());
  if (call.shared) return std::move(call.shared->whole);
  std::vector<ElasticSystem> systems;
  VectorXd load(bodies.dof_count());
  for (int k = 0; k < bodies.body_count(); ++k) {
    RowMatrix A = matrix_of_body(call.stack, bodies, k, call.matrix[k], mesh);
    const VectorXd b =
        vector_of(value_of<KN<double>*>(call.stack, call.load[k]));
    bodies.require_dofs("b", k, b.size());
    load.segment(bodies.first_dof(k), bodies.dof_count(k)) = b;
    systems.push_back(elastic_system(std::move(A), b, dim));
  }
  require_order(mesh, load, joined_displacement(bodies, call.u));
  return joined(std::move(systems));
}

template ElasticSystem system_of(const SolveCall&, const BodyDofs&,
                                 const Mesh&);
template ElasticSystem system_of(const SolveCall&, const BodyDofs&,
                                 const SolidMesh&);

ContactSettings settings_of(const SolveCall& call, ContactStates states,
                            int dim) {
  const Stack stack = call.stack;
  const NamedArguments& named = call.named;
  ContactSettings settings;
  put_solver(stack, named, dim, settings);
  settings.max_iterations =
      static_cast<int>(named.integer(stack, "maxit", settings.max_iterations));
  settings.tolerance = named.number(stack, "tol", settings.tolerance);
  if (!(settings.tolerance > 0))
    refuse("tol must be positive, got ", settings.tolerance);
  settings.report = progress_lines("contactsolve", call.verbosity(), dim);
  settings.initial_state = std::move(states);
  if (call.shared) settings.factorise = call.shared->factorise;
  if (named.given("initial")) settings.initial_state.clear();
  for (long number : named.integers(stack, "initial"))
    settings.initial_state.push_back(state_of_number(number));
  return settings;
}

bool is_same(const ElasticSystem& a, const ElasticSystem& b) {
  return a.prescribed == b.prescribed && is_same(a.stiffness, b.stiffness);
}

void write_displacement(const SolveCall& call, const BodyDofs& bodies,
                        const VectorXd& displacement) {
  if (call.shared) {
    call.shared->displacement = displacement;
    return;
  }
  for (int k = 0; k < bodies.body_count(); ++k)
    vector_of(call.u[k]) =
        displacement.segment(bodies.first_dof(k), bodies.dof_count(k));
}

void put(const SolveCall& call, const std::vector<long>& own_vertex,
         const VectorXd& abscissa, const NodalResults& nodes) {
  for (const char* name : all_nodal_names()) {
    const int column = nodal_column(nodes.dimension(), name);
    if (column >= 0) call.named.put(call.stack, name, nodes.values.col(column));
  }
  call.named.put_integers(call.stack, "node", own_vertex);
  call.named.put_integers(call.stack, "state", nodes.state);
  call.named.put(call.stack, "abscissa", abscissa);
}

std::vector<long> state_numbers(const ContactStates& states) {
  std::vector<long> numbers;
  for (ContactState state : states)
    numbers.push_back(state == ContactState::stick ? 1 : 2 * slip_sign(state));
  return numbers;
}

}  // namespace ffcontact::plugin
