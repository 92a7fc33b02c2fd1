// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace ffcontact {

namespace {

using EnergyMatrix = Eigen::Matrix<double, 14, 14>;

TriangleCorners corners_of(const Mesh& mesh, int t) {
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = mesh.corner(t, k);
  return corners;
}

/// Moments (b_i, b_j) of one spoke for the unknowns A / l0, A_x, A_y at the vertex and dA/dn at the middle of the spoke,
/// with the traction taken on the normal to the right of i -> j.
Eigen::Matrix4d spoke_moments(const Eigen::Vector2d& spoke, double l0) {
  const double length = spoke.norm();
  const Eigen::Vector2d s = spoke / length, n(s.y(), -s.x());
  Eigen::Matrix<double, 2, 4> gradient_i = Eigen::Matrix<double, 2, 4>::Zero(), gradient_m;
  gradient_i.middleCols<2>(1).setIdentity();
  gradient_m << -1.5 * l0 / length * s, -0.25 * s * s.transpose(), n;
  Eigen::Matrix2d psi;  // (A_x, A_y) -> (A_y, -A_x)
  psi << 0, 1, -1, 0;
  Eigen::Matrix4d moments;
  moments.topRows<2>() = psi * (-5 * gradient_i + 4 * gradient_m) / 6;
  moments.bottomRows<2>() = psi * (-gradient_i - 4 * gradient_m) / 6;
  return moments;
}

/// One vertex and its star, with the moments of each spoke as functions of the unknowns.
class Star {
 public:
  Star(const Mesh& mesh, const Edges& edges, const Stars& stars, int vertex)
      : vertex_(vertex),
        triangles_(stars.triangle_count(vertex)),
        spokes_(stars.spoke_count(vertex)),
        triangle_(stars.triangle.data() + stars.triangle_start[vertex]),
        local_(stars.local.data() + stars.triangle_start[vertex]),
        spoke_(stars.spoke.data() + stars.spoke_start[vertex]) {
    moments_.resize(spokes_);
    std::vector<Eigen::Vector2d> vectors(spokes_);
    double l0 = 0;
    for (int k = 0; k < spokes_; ++k) {
      const double sign = edges.vertices(0, spoke_[k]) == vertex ? 1 : -1;
      vectors[k] = sign * edge_vector(mesh, edges, spoke_[k]);
      l0 += vectors[k].norm() / spokes_;
    }
    for (int k = 0; k < spokes_; ++k) moments_[k] = spoke_moments(vectors[k], l0);
  }

  int unknowns() const { return 3 + spokes_; }
  int triangles() const { return triangles_; }
  int triangle(int k) const { return triangle_[k]; }

  /// Loads of triangle k for (A, A_x, A_y, dA/dn right spoke, dA/dn left spoke): eight rows, two edges.
  /// `rows` receives where these rows stand in TriangleLoads.
  Eigen::Matrix<double, 8, 5> triangle_loads(int k, std::array<int, 8>& rows) const {
    Eigen::Matrix<double, 8, 5> loads = Eigen::Matrix<double, 8, 5>::Zero();
    const Eigen::Matrix4d& right = moments_[k];
    const Eigen::Matrix4d& left = moments_[left_spoke(k)];
    loads.topLeftCorner<4, 4>() = right;
    loads.bottomLeftCorner<4, 3>() = -left.leftCols<3>();
    loads.bottomRightCorner<4, 1>() = -left.rightCols<1>();
    // The right spoke is the edge opposite to local + 2, from vertex i to local + 1: moments in order i, j. The left spoke is
    // the edge opposite to local + 1, from local + 2 to i: moments in order j, i.
    const int right_row = 4 * ((local_[k] + 2) % 3), left_row = 4 * ((local_[k] + 1) % 3);
    for (int c = 0; c < 4; ++c) {
      rows[c] = right_row + c;
      rows[4 + c] = left_row + (c + 2) % 4;
    }
    return loads;
  }

  /// Places of the five unknowns of triangle k among all.
  std::array<int, 5> columns(int k) const { return {0, 1, 2, 3 + k, 3 + left_spoke(k)}; }

  /// Basis of the unknowns that leave the known boundary tractions alone [unknowns x n]; empty when nothing is known.
  Eigen::MatrixXd admissible_unknowns(const BoundaryTractions& boundary) const {
    if (triangles_ == spokes_) return {};
    Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(8, unknowns());
    int row = 0;
    for (int k : {0, spokes_ - 1})
      for (int c = 0; c < 2; ++c)
        if (boundary.known(c, spoke_[k])) {
          // psi_i and psi_m vanish exactly when the moments b_i and b_j do.
          for (int end = 0; end < 2; ++end, ++row) {
            conditions.row(row).head<3>() = moments_[k].row(2 * end + c).head<3>();
            conditions(row, 3 + k) = moments_[k](2 * end + c, 3);
          }
        }
    if (row == 0) return {};
    Eigen::FullPivLU<Eigen::MatrixXd> lu(conditions.topRows(row));
    lu.setThreshold(1e-10);
    if (lu.dimensionOfKernel() == 0) return Eigen::MatrixXd(unknowns(), 0);
    return lu.kernel();
  }

 private:
  int left_spoke(int k) const { return (k + 1) % spokes_; }

  int vertex_, triangles_, spokes_;
  const int *triangle_, *local_, *spoke_;
  std::vector<Eigen::Matrix4d> moments_;
};

/// Minimises the energy over the corrections of one star; returns by how much it fell.
double relax(const Star& star, const BoundaryTractions& boundary, const std::vector<EnergyMatrix>& energies,
             LoadsPerTriangle& difference) {
  const int n = star.unknowns();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n);
  std::array<int, 8> rows;
  for (int k = 0; k < star.triangles(); ++k) {
    const int t = star.triangle(k);
    const Eigen::Matrix<double, 8, 5> loads = star.triangle_loads(k, rows);
    const std::array<int, 5> columns = star.columns(k);
    Eigen::Matrix<double, 8, 14> A;
    for (int r = 0; r < 8; ++r) A.row(r) = energies[t].row(rows[r]);
    Eigen::Matrix<double, 8, 8> A_rows;
    for (int r = 0; r < 8; ++r) A_rows.col(r) = A.col(rows[r]);
    const Eigen::Matrix<double, 5, 5> H_local = loads.transpose() * A_rows * loads;
    const Eigen::Matrix<double, 5, 1> g_local = loads.transpose() * (A * difference.col(t));
    for (int a = 0; a < 5; ++a) {
      g[columns[a]] += g_local[a];
      for (int b = 0; b < 5; ++b) H(columns[a], columns[b]) += H_local(a, b);
    }
  }
  const Eigen::MatrixXd Z = star.admissible_unknowns(boundary);
  Eigen::VectorXd y;
  if (Z.size() == 0 && Z.rows() > 0) return 0;
  if (Z.size() == 0)
    y = -H.llt().solve(g);
  else
    y = -Z * (Z.transpose() * H * Z).llt().solve(Z.transpose() * g);
  if (!y.allFinite()) return 0;

  for (int k = 0; k < star.triangles(); ++k) {
    const std::array<int, 5> columns = star.columns(k);
    Eigen::Matrix<double, 5, 1> y_local;
    for (int a = 0; a < 5; ++a) y_local[a] = y[columns[a]];
    const Eigen::Matrix<double, 8, 1> change = star.triangle_loads(k, rows) * y_local;
    for (int r = 0; r < 8; ++r) difference(rows[r], star.triangle(k)) += change[r];
  }
  return -y.dot(g);
}

}  // namespace

LoadsPerTriangle difference_loads(const Mesh& mesh, const Edges& edges, const EdgeMoments& moments,
                                  const Eigen::Ref<const Eigen::Matrix2Xd>& body_force,
                                  const Eigen::Ref<const Eigen::Matrix3Xd>& stress) {
  LoadsPerTriangle loads(14, mesh.triangles.cols());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int edge = edges.of_triangle(k, t);
      const double eta = edges.eta(k, t);
      const Eigen::Vector4d b = eta * moments.col(edge);
      const Eigen::Vector2d side = eta * edge_vector(mesh, edges, edge);  // from vertex k+1 to k+2
      const Eigen::Vector2d half = 0.5 * traction(stress.col(t), Eigen::Vector2d(side.y(), -side.x()));
      loads.block<2, 1>(4 * k, t) = (eta > 0 ? b.head<2>() : b.tail<2>()) - half;
      loads.block<2, 1>(4 * k + 2, t) = (eta > 0 ? b.tail<2>() : b.head<2>()) - half;
    }
    loads.block<2, 1>(12, t) = signed_area(mesh, t) * body_force.col(t);
  }
  return loads;
}

std::vector<double> relax_stars(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                                const BoundaryTractions& boundary, int sweeps, LoadsPerTriangle& difference) {
  std::vector<EnergyMatrix> energies(mesh.triangle_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.triangle_count(); ++t)
    energies[t] = composite_energy(corners_of(mesh, t), hooke[t].inverse());

  double squared = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) squared += difference.col(t).dot(energies[t] * difference.col(t));
  std::vector<double> history{squared};

  const std::vector<std::vector<int>> colours = vertex_colours(mesh, stars);
  std::vector<double> fall(mesh.vertex_count());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const std::vector<int>& colour : colours)
#pragma omp parallel for
      for (std::size_t k = 0; k < colour.size(); ++k)
        fall[colour[k]] = stars.triangle_count(colour[k]) == 0
                              ? 0
                              : relax(Star(mesh, edges, stars, colour[k]), boundary, energies, difference);
    for (double f : fall) squared -= f;
    history.push_back(squared);
  }
  return history;
}

}  // namespace ffcontact
