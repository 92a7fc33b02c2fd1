// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/law_of_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/elastic/inner_forces.hpp"
#include "ffcontact/equilibrium/difference_loads.hpp"

namespace ffcontact {

namespace {

constexpr double tolerance = 1e-6;

/// A field without order, between -1 and 1, and 0 where a dof is prescribed.
VectorXd probe(const Flags& prescribed) {
  VectorXd z(static_cast<Index>(prescribed.size()));
  unsigned number = 1;
  for (Index dof = 0; dof < z.size(); ++dof) {
    number = number * 1664525u + 1013904223u;  // Numerical Recipes' generator
    z[dof] = prescribed[dof] ? 0 : number / 2147483648.0 - 1;
  }
  return z;
}

/// int C eps(u) : eps(phi).
template <int dim>
VectorXd forces_of_law(const SimplexMesh<dim>& mesh,
                       const HookeTensors<dim>& hooke, const VectorXd& u) {
  return inner_forces<dim>(mesh, stresses<dim>(mesh, hooke, u));
}

/// K u of what the script says of a body: its law, and springs if there are any.
using StatedForces = std::function<VectorXd(const VectorXd&)>;

/// K_ii of one dof.
double diagonal_of_law(const StatedForces& forces, Index dofs, Index dof) {
  return forces(VectorXd::Unit(dofs, dof))[dof];
}

template <int dim>
std::string vertex_in_words(const SimplexMesh<dim>& mesh, Index vertex) {
  const auto v = static_cast<int>(vertex);
  return "vertex " + std::to_string(v) + " " + in_words(mesh.place(v));
}

/// What a row of A z is made of.
struct Row {
  double sum = 0, terms = 0;
};

Row row_of(const RowMatrix& A, const VectorXd& z, Index dof) {
  Row row;
  for (RowMatrix::InnerIterator a(A, dof); a; ++a) {
    const double term = a.value() * z[a.col()];
    row.sum += term;
    row.terms += std::abs(term);
  }
  return row;
}

/// A z beside K z on all dofs, 0 on prescribed ones.
struct Comparison {
  VectorXd z, of_law, of_matrix, terms;
  VectorXd off;  ///< |A z - K z| in parts of the terms

  /// @param prescribed  dofs that are left out
  Comparison(const RowMatrix& A, const StatedForces& forces,
             const Flags& prescribed)
      : z(probe(prescribed)), of_law(forces(z)) {
    of_matrix = terms = off = VectorXd::Zero(z.size());
#pragma omp parallel for
    for (Index dof = 0; dof < z.size(); ++dof)
      if (!prescribed[dof]) put(row_of(A, z, dof), dof);
  }

  /// By what A z is a multiple of K z where they differ.
  double factor() const {
    const auto elsewhere = (off.array() <= tolerance).cast<double>();
    return ((1 - elsewhere) * of_matrix.array() * of_law.array()).sum() /
           ((1 - elsewhere) * of_law.array().square()).sum();
  }
  bool is_multiple() const {
    const auto rest = (of_matrix - factor() * of_law).array().abs();
    return (rest <= tolerance * terms.array() || off.array() <= tolerance)
        .all();
  }

 private:
  void put(const Row& row, Index dof) {
    of_matrix[dof] = row.sum;
    terms[dof] = row.terms;
    off[dof] = relative(std::abs(row.sum - of_law[dof]), row.terms);
  }
};

/// Refuses a matrix that differs by something on one dof's diagonal.
template <int dim>
void require_no_penalty(const SimplexMesh<dim>& mesh,
                        const ElasticSystem& system, const StatedForces& forces,
                        const Comparison& comparison, Index dof) {
  const auto& [z, of_law, of_matrix, terms, off] = comparison;
  const double more = (of_matrix[dof] - of_law[dof]) / z[dof];
  const double added =
      system.stiffness.coeff(dof, dof) - diagonal_of_law(forces, z.size(), dof);
  if (std::abs(more - added) <= 1e-3 * std::abs(added))
    refuse("A has ", added, " more on its diagonal at ",
           vertex_in_words(mesh, dof / dim),
           " than lambda and G (or hooke) give: a penalty in place of a "
           "prescribed displacement, or a spring at a point; prescribe with "
           "on() and tgv 1e30, -1 or -2, and spread springs over an edge");
}

/// Refuses a matrix that differs along the boundary alone, by what a spring would add.
void require_springs_of_matrix(const Mesh& mesh, const ElasticSystem& system,
                               const StatedForces& forces,
                               const Comparison& comparison, bool given,
                               Index dof) {
  Flags on_boundary(mesh.vertex_count(), 0);
  for (const int v : mesh.boundary.reshaped()) on_boundary[v] = 1;
  for (Index k = 0; k < comparison.off.size(); ++k)
    if (comparison.off[k] > tolerance && !on_boundary[k / 2]) return;
  const double added = system.stiffness.coeff(dof, dof) -
                       diagonal_of_law(forces, comparison.z.size(), dof);
  if (given)
    refuse("spring= is not that of A: at ", vertex_in_words(mesh, dof / 2),
           " A has ", added,
           " more on its diagonal; give the stiffness of the script's int1d on "
           "its labels, [kx, ky] or [kxx, kxy, kyy]");
  if (added > 0)
    refuse(
        "A is stiffer along the boundary than lambda and G (or hooke) make "
        "it, by ",
        added, " on its diagonal at ", vertex_in_words(mesh, dof / 2),
        ": where the script has springs, int1d of k u v, give "
        "spring=[kx*(label == ...), ky*(label == ...)]");
}

/// C times a coordinate at the centroids: r C, whose integrals are exact.
Hooke weighted(const Mesh& mesh, const Hooke& hooke, int radial) {
  Hooke result = hooke;
  for (int t = 0; t < mesh.cell_count(); ++t)
    result[t] *= mesh.origin[radial] + centroid_of(mesh, t)[radial];
  return result;
}

/// Is A a multiple of the stiffness of a body of revolution, r the given coordinate? On
/// axial displacements alone, which stretch no hoop, it is int r C eps(z) : eps(phi).
bool is_axisymmetric(const Mesh& mesh, const ElasticSystem& system,
                     const Hooke& hooke, int radial) {
  Flags left_out = system.prescribed;
  for (std::size_t dof = radial; dof < left_out.size(); dof += 2)
    left_out[dof] = 1;
  const Hooke by_radius = weighted(mesh, hooke, radial);
  const Comparison axial(
      system.stiffness,
      [&](const VectorXd& u) { return forces_of_law<2>(mesh, by_radius, u); },
      left_out);
  return axial.of_matrix.norm() > 0 && axial.is_multiple();
}

void require_plane(const Mesh& mesh, const ElasticSystem& system,
                   const Hooke& hooke) {
  constexpr const char* axis[] = {"x = 0", "y = 0"};
  for (int radial = 0; radial < 2; ++radial)
    if (is_axisymmetric(mesh, system, hooke, radial))
      refuse("A is the stiffness of an axisymmetric body about ", axis[radial],
             ": contactsolve solves it, but contacterror judges plane bodies "
             "alone");
}

/// The dof at which A is off the most, or -1.
Index worst_dof(const Comparison& comparison) {
  Index worst;
  return comparison.off.maxCoeff(&worst) <= tolerance ? -1 : worst;
}

template <int dim>
void require_no_factor(const SimplexMesh<dim>& mesh,
                       const Comparison& comparison, Index dof) {
  if (comparison.is_multiple())
    refuse("lambda and G (or hooke) are not those of A: A is ",
           comparison.factor(), " times the stiffness of the law at ",
           vertex_in_words(mesh, dof / dim),
           "; give the constants of the script's varf");
}

template <int dim>
[[noreturn]] void refuse_row(const SimplexMesh<dim>& mesh,
                             const Comparison& comparison, Index dof) {
  refuse("A is not the stiffness of lambda and G (or hooke): its row of ",
         vertex_in_words(mesh, dof / dim), " is off by ", comparison.off[dof],
         " of its terms; give the law of the script's varf in every region, "
         "and A without springs",
         dim == 2 ? " that spring= does not name" : "");
}

/// @param other  (comparison, dof): refuses what else may explain the difference at a dof
template <int dim, class Other>
void require_forces_of_matrix(const SimplexMesh<dim>& mesh,
                              const ElasticSystem& system,
                              const StatedForces& forces, const Other& other) {
  const Comparison comparison(system.stiffness, forces, system.prescribed);
  const Index worst = worst_dof(comparison);
  if (worst < 0) return;
  require_no_penalty(mesh, system, forces, comparison, worst);
  require_no_factor(mesh, comparison, worst);
  other(comparison, worst);
  refuse_row(mesh, comparison, worst);
}

}  // namespace

void require_law_of_matrix(const Mesh& mesh, const ElasticSystem& system,
                           const Hooke& hooke, const BoundarySprings& springs) {
  const StatedForces forces = [&](const VectorXd& u) -> VectorXd {
    const VectorXd of_law = forces_of_law<2>(mesh, hooke, u);
    if (springs.empty()) return of_law;
    return of_law -
           boundary_forces(mesh, spring_moment_changes(mesh, springs, u));
  };
  const auto require_plane_body = [&](const Comparison& comparison,
                                      Index worst) {
    require_plane(mesh, system, hooke);
    require_springs_of_matrix(mesh, system, forces, comparison,
                              !springs.empty(), worst);
  };
  require_forces_of_matrix(mesh, system, forces, require_plane_body);
}

void require_law_of_matrix(const SolidMesh& mesh, const ElasticSystem& system,
                           const HookeTensors<3>& hooke) {
  const auto nothing_else = [](const Comparison&, Index) {};
  require_forces_of_matrix(
      mesh, system,
      [&](const VectorXd& u) { return forces_of_law<3>(mesh, hooke, u); },
      nothing_else);
}

}  // namespace ffcontact
