// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/data_defect.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/equilibrium/difference_loads.hpp"
#include "ffcontact/estimate/nodal_forces.hpp"

namespace ffcontact {

namespace {

constexpr double tolerance = 1e-6;

/// A field without order, between -1 and 1, and 0 where a dof is prescribed.
VectorXd probe(const std::vector<char>& prescribed) {
  VectorXd z(static_cast<Index>(prescribed.size()));
  unsigned number = 1;
  for (Index dof = 0; dof < z.size(); ++dof) {
    number = number * 1664525u + 1013904223u;  // Numerical Recipes' generator
    z[dof] = prescribed[dof] ? 0 : number / 2147483648.0 - 1;
  }
  return z;
}

/// Adds int sigma : eps(phi) over one cell.
template <int dim>
void add_forces(const SimplexMesh<dim>& mesh, int t,
                const VoigtVector<dim>& stress, VectorXd& forces) {
  const auto gradients = hat_gradients(mesh, t);
  const double volume = signed_volume(mesh, t);
  for (int k = 0; k <= dim; ++k) {
    const Matrix<double, dim, 1> gradient = gradients.col(k);
    vector_at<dim>(forces, mesh.cells(k, t)) +=
        volume * traction(stress, gradient);
  }
}

/// int sigma : eps(phi) for all phi, sigma constant on each cell [N/mm, N].
template <int dim, class Stresses>
VectorXd inner_forces(const SimplexMesh<dim>& mesh, const Stresses& stress) {
  VectorXd forces = VectorXd::Zero(dim * mesh.vertices.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    add_forces<dim>(mesh, t, stress.col(t), forces);
  return forces;
}

/// int C eps(u) : eps(phi).
template <int dim>
VectorXd inner_forces(const SimplexMesh<dim>& mesh,
                      const HookeTensors<dim>& hooke, const VectorXd& u) {
  return inner_forces(mesh, stresses<dim>(mesh, hooke, u));
}

/// int (C eps(u_h) + tau0) : eps(phi).
VectorXd inner_forces(const Mesh& mesh, const SolvedBody& body) {
  return inner_forces(mesh, total_stresses(mesh, body, body.displacement).mean);
}

/// K u of what the script says of a body: its law, and springs if there are any.
using StatedForces = std::function<VectorXd(const VectorXd&)>;

/// K_ii of one dof.
double diagonal_of_law(const StatedForces& forces, Index dofs, Index dof) {
  return forces(VectorXd::Unit(dofs, dof))[dof];
}

template <int dim>
std::string in_words(const SimplexMesh<dim>& mesh, Index vertex) {
  const Matrix<double, dim, 1> x = mesh.place(static_cast<int>(vertex));
  std::ostringstream text;
  text << "vertex " << vertex << " (" << x[0];
  for (int c = 1; c < dim; ++c) text << ", " << x[c];
  text << ")";
  return text.str();
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

/// Nodal pressures [2 x p] of the other multiplier.
Matrix2Xd pressures_of_other_multiplier(const ContactLine& line,
                                        const ElasticSystem& system,
                                        const SolvedBody& body) {
  if (body.law.multiplier == Multiplier::force)
    return lumped_pressures(line, forces_of(line, body.pressure));
  return multiplier_density(line, Multiplier::force, system.prescribed,
                            body.pressure);
}

/// Takes the given loads off.
/// @param vertices  one column for each column of loads, which has two rows per vertex
template <class Vertices, class Loads>
void subtract_loads(const Vertices& vertices, const Loads& loads,
                    VectorXd& forces) {
  for (Index column = 0; column < vertices.cols(); ++column)
    for (Index k = 0; k < vertices.rows(); ++k)
      forces.segment<2>(2 * vertices(k, column)) -=
          loads.template block<2, 1>(2 * k, column);
}

/// Forces on all dofs that the loads leave over for contact pressures of the other
/// multiplier.
VectorXd left_over_with_other_multiplier(const Mesh& mesh,
                                         const ContactLine& line,
                                         const ElasticSystem& system,
                                         const SolvedBody& body) {
  const Matrix2Xd other = pressures_of_other_multiplier(line, system, body);
  VectorXd left = inner_forces(mesh, body) -
                  nodal_forces(mesh, line, edge_densities(line, other));
  subtract_loads(mesh.cells, body.body_loads, left);
  subtract_loads(mesh.boundary, boundary_moments(mesh, body), left);
  for (Index dof = 0; dof < left.size(); ++dof)
    if (system.prescribed[dof]) left[dof] = 0;
  return left;
}

const char* name_of(Multiplier multiplier) {
  return multiplier == Multiplier::force ? "\"force\"" : "\"pressure\"";
}

/// A z beside K z on all dofs, 0 on prescribed ones.
struct Comparison {
  VectorXd z, of_law, of_matrix, terms;
  VectorXd off;  ///< |A z - K z| in parts of the terms

  /// @param prescribed  dofs that are left out
  Comparison(const RowMatrix& A, const StatedForces& forces,
             const std::vector<char>& prescribed)
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
    off[dof] = row.terms > 0 ? std::abs(row.sum - of_law[dof]) / row.terms : 0;
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
           in_words(mesh, dof / dim),
           " than lambda and G (or hooke) give: a penalty in place of a "
           "prescribed displacement, or a spring at a point; prescribe with "
           "on() and tgv 1e30, -1 or -2, and spread springs over an edge");
}

/// Refuses a matrix that differs along the boundary alone, by what a spring would add.
void require_springs_of_matrix(const Mesh& mesh, const ElasticSystem& system,
                               const StatedForces& forces,
                               const Comparison& comparison, bool given,
                               Index dof) {
  std::vector<char> on_boundary(mesh.vertex_count(), 0);
  for (const int v : mesh.boundary.reshaped()) on_boundary[v] = 1;
  for (Index k = 0; k < comparison.off.size(); ++k)
    if (comparison.off[k] > tolerance && !on_boundary[k / 2]) return;
  const double added = system.stiffness.coeff(dof, dof) -
                       diagonal_of_law(forces, comparison.z.size(), dof);
  if (given)
    refuse("spring= is not that of A: at ", in_words(mesh, dof / 2), " A has ",
           added,
           " more on its diagonal; give the stiffness of the script's int1d on "
           "its labels, [kx, ky] or [kxx, kxy, kyy]");
  if (added > 0)
    refuse(
        "A is stiffer along the boundary than lambda and G (or hooke) make "
        "it, by ",
        added, " on its diagonal at ", in_words(mesh, dof / 2),
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
  std::vector<char> left_out = system.prescribed;
  for (std::size_t dof = radial; dof < left_out.size(); dof += 2)
    left_out[dof] = 1;
  const Hooke by_radius = weighted(mesh, hooke, radial);
  const Comparison axial(
      system.stiffness,
      [&](const VectorXd& u) { return inner_forces(mesh, by_radius, u); },
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

/// Are the given pressures those of the other multiplier?
bool fits_other_multiplier(const Imbalance& imbalance, const Mesh& mesh,
                           const ContactLine& line, const ElasticSystem& system,
                           const SolvedBody& body) {
  const VectorXd left =
      left_over_with_other_multiplier(mesh, line, system, body);
  const double scale = inner_forces(mesh, body).cwiseAbs().maxCoeff();
  return std::abs(left[2 * imbalance.vertex + imbalance.component]) <=
         tolerance * scale;
}

std::string other_multiplier_in_words(Multiplier own) {
  const Multiplier other =
      own == Multiplier::force ? Multiplier::pressure : Multiplier::force;
  return std::string("pn and pt fit u with multiplier=") + name_of(other) +
         ", not with " + name_of(own);
}

/// What else may be missing at a vertex.
std::string missing_loads(const Mesh& mesh, int vertex, bool on_line) {
  if (!(mesh.boundary.array() == vertex).any())
    return "inside the body: give the bodyforce=, initialstrain= and "
           "initialstress= u was computed with";
  if (on_line)
    return "on the contact line: give pn and pt of the solution u, and the "
           "same label=, normal= and traction=";
  return "on the boundary: give the traction=, initialstrain= and "
         "initialstress= u was computed with";
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
           in_words(mesh, dof / dim),
           "; give the constants of the script's varf");
}

template <int dim>
[[noreturn]] void refuse_row(const SimplexMesh<dim>& mesh,
                             const Comparison& comparison, Index dof) {
  refuse("A is not the stiffness of lambda and G (or hooke): its row of ",
         in_words(mesh, dof / dim), " is off by ", comparison.off[dof],
         " of its terms; give the law of the script's varf in every region, "
         "and A without springs",
         dim == 2 ? " that spring= does not name" : "");
}

}  // namespace

void require_law_of_matrix(const Mesh& mesh, const ElasticSystem& system,
                           const Hooke& hooke, const BoundarySprings& springs) {
  const StatedForces forces = [&](const VectorXd& u) -> VectorXd {
    const VectorXd of_law = inner_forces(mesh, hooke, u);
    if (springs.empty()) return of_law;
    return of_law -
           boundary_forces(mesh, spring_moment_changes(mesh, springs, u));
  };
  const Comparison comparison(system.stiffness, forces, system.prescribed);
  const Index worst = worst_dof(comparison);
  if (worst < 0) return;

  require_no_penalty(mesh, system, forces, comparison, worst);
  require_no_factor(mesh, comparison, worst);
  require_plane(mesh, system, hooke);
  require_springs_of_matrix(mesh, system, forces, comparison, !springs.empty(),
                            worst);
  refuse_row(mesh, comparison, worst);
}

void require_law_of_matrix(const SolidMesh& mesh, const ElasticSystem& system,
                           const HookeTensors<3>& hooke) {
  const StatedForces forces = [&](const VectorXd& u) {
    return inner_forces(mesh, hooke, u);
  };
  const Comparison comparison(system.stiffness, forces, system.prescribed);
  const Index worst = worst_dof(comparison);
  if (worst < 0) return;

  require_no_penalty(mesh, system, forces, comparison, worst);
  require_no_factor(mesh, comparison, worst);
  refuse_row(mesh, comparison, worst);
}

std::string cause_of(const Imbalance& imbalance, const Mesh& mesh,
                     const ContactLine& line, const ElasticSystem& system,
                     const SolvedBody& body) {
  if (system.prescribed[2 * imbalance.vertex + imbalance.component])
    return "it is the reaction of a point support, which no admissible stress "
           "has: prescribe displacements on whole edges";
  const bool on_line = (line.vertex.array() == imbalance.vertex).any();
  if (on_line && fits_other_multiplier(imbalance, mesh, line, system, body))
    return other_multiplier_in_words(body.law.multiplier);
  return missing_loads(mesh, imbalance.vertex, on_line);
}

}  // namespace ffcontact
