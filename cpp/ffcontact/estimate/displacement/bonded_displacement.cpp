// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"

#include <array>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
#include "ffcontact/interface/facing_groups.hpp"
#include "ffcontact/linear/sparse_lu.hpp"

namespace ffcontact {

namespace {

/// A displacement on its way to one without jumps.
class Bonding {
 public:
  explicit Bonding(const MatchedBodies<2>& bodies)
      : bodies_(bodies),
        u_(bodies.body().displacement),
        unknown_(VectorXi::Constant(u_.size(), fixed)) {
    const ContactLine bonded =
        bonded_subset<2>(bodies.contact(), bodies.body().law).contact;
    for (const std::vector<int>& group : facing_groups(bonded))
      for (int c = 0; c < 2; ++c) join(group, c);
  }

  /// To the minimum of the potential energy.
  void relax() {
    if (unknowns_ == 0) return;
    const SparseLu factor(stiffness());
    if (!factor.is_regular()) return;  // nothing inside the bodies
    const VectorXd change = factor.solve(missing());
    for (Index dof = 0; dof < u_.size(); ++dof)
      if (unknown_[dof] >= 0) u_[dof] += change[unknown_[dof]];
  }

  const VectorXd& displacement() const { return u_; }

 private:
  static constexpr int fixed = -1;

  bool is_prescribed(int dof) const { return bodies_.prescribed()[dof]; }

  /// One value for a component of a group.
  void join(const std::vector<int>& group, int c) {
    const bool rigid = !bodies_.contact().against_a_body();
    bool is_free = !rigid;
    double value = rigid ? 0 : mean(group, c);
    for (int v : group)
      if (is_prescribed(2 * v + c)) {
        if (is_free) value = u_[2 * v + c];
        is_free = false;
      }
    for (int v : group) {
      if (is_prescribed(2 * v + c)) continue;
      u_[2 * v + c] = value;
      if (is_free) unknown_[2 * v + c] = unknowns_;
    }
    unknowns_ += is_free;
  }

  /// Of the vertices that were there before the cuts.
  double mean(const std::vector<int>& group, int c) const {
    double sum = 0;
    int count = 0;
    for (int v : group) {
      if (bodies_.is_cut(v)) continue;
      sum += u_[2 * v + c];
      ++count;
    }
    return count > 0 ? sum / count : u_[2 * group.front() + c];
  }

  /// P'r
  VectorXd missing() const {
    const Topology<2>& topology = bodies_.topology();
    const SolvedBody<2>& body = bodies_.body();
    const Matrix2Xd zero = Matrix2Xd::Zero(2, bodies_.contact().edge_count());
    const NodalResidual<2> residual =
        nodal_residual(topology, total_stresses(topology.mesh, body, u_).mean,
                       body.body_loads, bodies_.boundary_with({zero, zero}));
    VectorXd sum = VectorXd::Zero(unknowns_);
    for (Index dof = 0; dof < u_.size(); ++dof)
      if (unknown_[dof] >= 0)
        sum[unknown_[dof]] += residual.missing(dof % 2, dof / 2);
    return sum;
  }

  /// P'K P
  SparseMatrix stiffness() const {
    Triplets entries;
    for (int t = 0; t < bodies_.topology().mesh.cell_count(); ++t)
      add_triangle(t, entries);
    return packed(unknowns_, unknowns_, entries);
  }

  void add_triangle(int t, Triplets& entries) const {
    const Mesh& mesh = bodies_.topology().mesh;
    std::vector<int> corners;
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.cells(k, t);
      if (unknown_[2 * v] >= 0 || unknown_[2 * v + 1] >= 0)
        corners.push_back(k);
    }
    if (corners.empty()) return;
    const auto hats = hat_gradients(mesh, t);
    for (int k : corners)
      for (int l : corners)
        add_block({mesh.cells(k, t), mesh.cells(l, t)},
                  strain_of(hats.col(k)).transpose() *
                      (signed_volume(mesh, t) * bodies_.body().hooke[t]) *
                      strain_of(hats.col(l)),
                  entries);
  }

  /// Strain of a displacement of one vertex.
  static Matrix<double, 3, 2> strain_of(const Vector2d& gradient) {
    Matrix<double, 3, 2> B = Matrix<double, 3, 2>::Zero();
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) B(voigt_place<2>[i][j], i) = gradient[j];
    return B;
  }

  void add_block(const std::array<int, 2>& vertices, const Matrix2d& block,
                 Triplets& entries) const {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const int row = unknown_[2 * vertices[0] + i],
                  column = unknown_[2 * vertices[1] + j];
        if (row >= 0 && column >= 0)
          entries.emplace_back(row, column, block(i, j));
      }
  }

  const MatchedBodies<2>& bodies_;
  VectorXd u_;
  VectorXi unknown_;  ///< of each dof, or `fixed`
  int unknowns_ = 0;
};

}  // namespace

VectorXd bonded_displacement(const MatchedBodies<2>& bodies) {
  if (!bodies.body().law.has_bonded()) return bodies.body().displacement;
  Bonding bonding(bodies);
  bonding.relax();
  return bonding.displacement();
}

}  // namespace ffcontact
