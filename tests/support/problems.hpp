// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/elastic/loads_and_supports.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "support/meshes.hpp"

/// Contact problems that the tests share.
namespace ffcontact::test {

/// Lame's constants of plane strain [MPa].
struct Material {
  double lambda, G;
  Matrix3d hooke() const { return isotropic(lambda, G); }
};
inline Material material(double youngs_modulus, double nu) {
  return {youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu)),
          youngs_modulus / (2 * (1 + nu))};
}

/// End values of the traction with moments (b_i, b_j) on an edge.
inline Vector4d density_of(const Vector4d& moments, double length) {
  return facet_density<2>(moments.reshaped(2, 2), length).reshaped();
}

constexpr Multiplier both_multipliers[] = {Multiplier::force,
                                           Multiplier::pressure};

constexpr double penalty = 1e30;  ///< FreeFEM's tgv

using Field = std::function<Vector2d(const Vector2d&)>;

/// A body with its loads and supports as FreeFEM assembles them, and the law on its
/// contact line.
struct Problem {
  Mesh mesh;
  Edges edges;
  ContactLine line;
  Hooke hooke;
  RowMatrix A;
  VectorXd b;
  Matrix4Xd neumann;  ///< moments of the given tractions [4 x Mesh::boundary]
  Matrix2Xd body_force;  ///< per triangle
  ContactLaw<2> law;

  ElasticSystem system() const { return elastic_system(A, b); }
};

inline VectorXd everywhere(const ContactLine& line, double value) {
  return VectorXd::Constant(line.node_count(), value);
}

/// A body without loads and supports, and without friction.
inline Problem body(const Mesh& mesh, const Material& material,
                    const std::vector<int>& contact_labels = {bottom}) {
  Problem problem;
  problem.mesh = mesh;
  problem.edges = edges_of(mesh);
  problem.line = contact_line(mesh, problem.edges, contact_labels);
  problem.hooke = Hooke(mesh.cell_count(), material.hooke());
  problem.A = stiffness(mesh, problem.hooke);
  problem.b = VectorXd::Zero(problem.A.rows());
  problem.neumann = Matrix4Xd::Zero(4, mesh.boundary.cols());
  problem.body_force = Matrix2Xd::Zero(2, mesh.cells.cols());
  problem.law.friction = everywhere(problem.line, 0);
  return problem;
}

/// Adds a constant traction [MPa] on the edges of a label.
inline void add_traction(Problem& problem, int label,
                         const Vector2d& traction) {
  add_traction(problem.mesh, label, traction, problem.b, problem.neumann);
}

/// Adds a constant body force [N/mm^3].
inline void add_body_force(Problem& problem, const Vector2d& force) {
  for (int t = 0; t < problem.mesh.cell_count(); ++t) {
    problem.body_force.col(t) += force;
    for (int v : problem.mesh.cells.col(t))
      problem.b.segment<2>(2 * v) += signed_area(problem.mesh, t) / 3 * force;
  }
}

inline void prescribe_dof(Problem& problem, int dof, double value) {
  problem.A.coeffRef(dof, dof) = penalty;
  problem.b[dof] = penalty * value;
}

/// Prescribes one component on the vertices of a label.
inline void prescribe(Problem& problem, int label, int component,
                      const Field& value) {
  for (Index e = 0; e < problem.mesh.boundary.cols(); ++e)
    if (problem.mesh.boundary_label[e] == label)
      for (int v : problem.mesh.boundary.col(e))
        prescribe_dof(problem, 2 * v + component,
                      value(problem.mesh.vertices.col(v))[component]);
}

inline Vector2d no_displacement(const Vector2d&) { return Vector2d::Zero(); }

inline void prescribe(Problem& problem, int label, int component) {
  prescribe(problem, label, component, no_displacement);
}

inline void clamp(Problem& problem, int label,
                  const Field& value = no_displacement) {
  prescribe(problem, label, 0, value);
  prescribe(problem, label, 1, value);
}

inline void set_friction(Problem& problem, double mu) {
  problem.law.friction = everywhere(problem.line, mu);
}

/// Example 1 of [CHH01]: 80 x 40, clamped at the top, pushed from the left by 10 MPa,
/// symmetric at the right.
inline Problem example_1(Multiplier multiplier, int cells = 16) {
  Problem problem =
      body(rectangle(2 * cells, cells, 80, 40), material(13e3, 0.2));
  add_traction(problem, left, {10, 0});
  clamp(problem, top);
  prescribe(problem, right, 0);
  set_friction(problem, 0.5);
  problem.law.multiplier = multiplier;
  return problem;
}

/// Example 2 of [CHH01]: 40 x 40, pressed from the top by 5 MPa, symmetric at the right;
/// only contact holds it vertically.
inline Problem example_2(Multiplier multiplier, double mu, int cells = 16) {
  Problem problem = body(rectangle(cells, cells, 40, 40), material(13e3, 0.2));
  add_traction(problem, top, {0, -5});
  prescribe(problem, right, 0);
  set_friction(problem, mu);
  problem.law.multiplier = multiplier;
  return problem;
}

/// Benchmark B1 (Raous, Chabrand, Lebon 1988; code_aster SSNV128): 40 x 40, pressed from
/// the top by 50 MPa and pushed from the left by 150 MPa, symmetric at the right; the
/// contact line opens, slips and sticks from left to right.
inline Problem block_with_three_zones(int cells) {
  Problem problem = body(rectangle(cells, cells, 40, 40), material(130e3, 0.2));
  add_traction(problem, top, {0, -50});
  add_traction(problem, left, {150, 0});
  prescribe(problem, right, 0);
  // the lower right corner is held in both directions
  prescribe_dof(problem, 2 * cells + 1, 0);
  set_friction(problem, 1);
  return problem;
}

inline ContactSolution<2> solved(const Problem& problem,
                                 const ContactSettings& settings = {}) {
  return solve_contact(problem.mesh, problem.line, problem.law,
                       problem.system(), settings);
}

inline VectorXd nodal_values(const Mesh& mesh, const Field& field) {
  VectorXd values(2 * mesh.vertices.cols());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    values.segment<2>(2 * v) = field(mesh.vertices.col(v));
  return values;
}

/// Largest difference relative to the largest value of the second.
inline double relative_difference(const Ref<const MatrixXd>& a,
                                  const Ref<const MatrixXd>& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

}  // namespace ffcontact::test
