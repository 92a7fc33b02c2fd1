// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/local_mending.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/base/quadratic_minimum.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/estimate/rebalancing_displacement.hpp"

namespace ffcontact {

namespace {

/// edges: the quadratic problem has four unknowns an edge
constexpr int largest_window = 16;
constexpr int layers = 3;  ///< of triangles around a window
constexpr double resultant_tolerance = 1e-12;

/// Whether edge e + 1 of the line begins where edge e ends.
bool joined(const ContactLine& line, int e) {
  return line.vertex[line.edge_node(1, e)] == line.vertex[line.edge_node(0, e + 1)];
}

/// Edges that may be in a window with edge e: of one chain of the line.
LineWindow chain_of(const ContactLine& line, int e) {
  LineWindow chain{e, e};
  while (chain.first > 0 && chain.count() <= 2 * largest_window &&
         joined(line, chain.first - 1))
    --chain.first;
  while (chain.last + 1 < line.edge_count() && chain.count() <= 4 * largest_window &&
         joined(line, chain.last))
    ++chain.last;
  return chain;
}

/// The quadratic problem of a window. Unknown 4 k + 2 end + c is component c (0 normal, 1
/// tangential) of edge k at an end.
struct WindowProblem {
  MatrixXd mass, cone, equations;
  VectorXd computed, limits, right;
};

/// Force and moment of the end values of one edge [3 x 4]; x cross r about the first end
/// of the window.
Matrix<double, 3, 4> edge_resultants(const Mesh& mesh, const ContactLine& line, int e,
                                     const Vector2d& origin) {
  Matrix2d frame;
  frame << line.edge_normal(e), line.edge_tangent(e);
  Matrix<double, 3, 4> result = Matrix<double, 3, 4>::Zero();
  for (int end = 0; end < 2; ++end)
    for (int at = 0; at < 2; ++at) {  // int phi_end phi_at
      const Vector2d x = mesh.vertices.col(line.vertex[line.edge_node(at, e)]) - origin;
      const Matrix2d force = line.length[e] / (at == end ? 3 : 6) * frame;
      result.block<2, 2>(0, 2 * end) += force;
      result.block<1, 2>(2, 2 * end) += x.x() * force.row(1) - x.y() * force.row(0);
    }
  return result;
}

WindowProblem window_problem(const Mesh& mesh, const ContactLine& line,
                             const ContactLaw& law, const ContactDensities& computed,
                             const LineWindow& window) {
  const int unknowns = 4 * window.count();
  WindowProblem problem{MatrixXd::Zero(unknowns, unknowns),
                        {},
                        MatrixXd::Zero(3, unknowns),
                        VectorXd(unknowns),
                        {},
                        {}};
  std::vector<std::pair<Eigen::RowVectorXd, double>> conditions;
  std::vector<int> zero;  // r_t where there is no friction
  const Vector2d origin = mesh.vertices.col(line.vertex[line.edge_node(0, window.first)]);
  double span = 0;
  for (int e = window.first; e <= window.last; ++e) span += line.length[e];
  for (int k = 0; k < window.count(); ++k) {
    const int e = window.first + k;
    problem.equations.middleCols<4>(4 * k) =
        edge_resultants(mesh, line, e, origin) / span;
    problem.equations.block<1, 4>(2, 4 * k) /= span;
    for (int end = 0; end < 2; ++end) {
      const int first = 4 * k + 2 * end;
      problem.computed.segment<2>(first) << computed.normal(end, e),
          computed.tangential(end, e);
      for (int other = 0; other < 2; ++other)
        problem.mass.block<2, 2>(first, 4 * k + 2 * other) =
            line.length[e] / (span * (other == end ? 3 : 6)) * Matrix2d::Identity();
    }
    const EdgeCone cone = edge_cone(line, law, e);
    for (int end = 0; end < 2; ++end)
      if (cone.frictionless[end]) zero.push_back(4 * k + 2 * end + 1);
    for (Index row = 0; row < cone.d.size(); ++row) {
      conditions.emplace_back(Eigen::RowVectorXd::Zero(unknowns), cone.d[row]);
      conditions.back().first.segment<4>(4 * k) = cone.C.row(row);
    }
  }
  problem.right = problem.equations * problem.computed;
  const auto known = static_cast<Index>(zero.size());
  problem.equations.conservativeResize(3 + known, Eigen::NoChange);
  problem.right.conservativeResize(3 + known);
  for (Index k = 0; k < known; ++k) {
    problem.equations.row(3 + k) = Eigen::RowVectorXd::Unit(unknowns, zero[k]);
    problem.right[3 + k] = 0;
  }
  problem.cone.resize(static_cast<Index>(conditions.size()), unknowns);
  problem.limits.resize(problem.cone.rows());
  for (Index row = 0; row < problem.cone.rows(); ++row) {
    problem.cone.row(row) = conditions[row].first;
    problem.limits[row] = conditions[row].second;
  }
  return problem;
}

/// The end values in the cone that are nearest to the computed ones; empty when there are
/// none.
VectorXd nearest(const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
                 const ContactDensities& computed, const LineWindow& window) {
  const WindowProblem problem = window_problem(mesh, line, law, computed, window);
  const double scale = std::max(problem.computed.cwiseAbs().maxCoeff(),
                                problem.limits.cwiseAbs().maxCoeff());
  const auto solves = [&](const VectorXd& values) {
    return (problem.equations * values - problem.right).cwiseAbs().maxCoeff() <=
           resultant_tolerance * scale;
  };
  const VectorXd start =
      problem.computed +
      least_squares(problem.equations,
                    problem.right - problem.equations * problem.computed);
  const MatrixXd Z = kernel_basis(problem.equations);
  if (!solves(start) || Z.cols() == 0) return {};
  const auto x =
      quadratic_minimum(Z.transpose() * problem.mass * Z,
                        Z.transpose() * problem.mass * (start - problem.computed),
                        problem.cone * Z, problem.limits - problem.cone * start);
  if (!x) return {};
  VectorXd values = start + Z * *x;
  for (int k = 0; k < window.count(); ++k)
    values.segment<4>(4 * k) =
        clamped_to_cone(line, law, window.first + k, values.segment<4>(4 * k));
  return solves(values) ? values : VectorXd();
}

/// A window and its end values.
struct MendedWindow {
  LineWindow window;
  VectorXd values;
};

/// The smallest window that has an answer, contains `must` and lies in `may`; no values
/// if there is none.
MendedWindow smallest_window(const Mesh& mesh, const ContactLine& line,
                             const ContactLaw& law, const ContactDensities& computed,
                             const LineWindow& must, const LineWindow& may) {
  for (int size = must.count(); size <= largest_window; ++size) {
    const int extra = size - must.count();
    for (int before : std::set<int>{0, extra / 2, extra}) {
      const LineWindow window{must.first - before, must.first - before + size - 1};
      if (window.first < may.first || window.last > may.last) continue;
      VectorXd values = nearest(mesh, line, law, computed, window);
      if (values.size() > 0) return {window, std::move(values)};
    }
  }
  return {must, {}};
}

/// A part of the mesh with its own numbers.
struct Patch {
  Mesh mesh;
  std::vector<int> triangle;  ///< of the whole mesh
  ContactLine line;           ///< the window's edges and nodes
};

Patch patch_around(const Mesh& mesh, const Stars& stars, const ContactLine& line,
                   const LineWindow& window) {
  std::set<int> vertices, triangles;
  for (int e = window.first; e <= window.last; ++e)
    for (int node : line.edge_node.col(e)) vertices.insert(line.vertex[node]);
  for (int layer = 0; layer < layers; ++layer) {
    for (int v : vertices)
      triangles.insert(stars.triangle.begin() + stars.triangle_start[v],
                       stars.triangle.begin() + stars.triangle_start[v + 1]);
    for (int t : triangles)
      vertices.insert(mesh.cells.col(t).begin(), mesh.cells.col(t).end());
  }
  Patch patch;
  patch.triangle.assign(triangles.begin(), triangles.end());
  std::unordered_map<int, int> number;
  patch.mesh.vertices.resize(2, static_cast<Index>(vertices.size()));
  for (int v : vertices) {
    const int next = static_cast<int>(number.size());
    number[v] = next;
    patch.mesh.vertices.col(next) = mesh.vertices.col(v);
  }
  patch.mesh.cells.resize(3, static_cast<Index>(triangles.size()));
  for (std::size_t t = 0; t < patch.triangle.size(); ++t)
    for (int k = 0; k < 3; ++k)
      patch.mesh.cells(k, static_cast<Index>(t)) =
          number[mesh.cells(k, patch.triangle[t])];
  const int count = window.count();
  patch.line.vertex.resize(2 * count);
  patch.line.normal.resize(2, 2 * count);
  patch.line.edge_node.resize(2, count);
  patch.line.edge = line.edge.segment(window.first, count);
  patch.line.length = line.length.segment(window.first, count);
  for (int k = 0; k < count; ++k)
    for (int end = 0; end < 2; ++end) {
      const int node = line.edge_node(end, window.first + k);
      patch.line.edge_node(end, k) = 2 * k + end;
      patch.line.vertex[2 * k + end] = number[line.vertex[node]];
      patch.line.normal.col(2 * k + end) = line.normal.col(node);
    }
  return patch;
}

/// Windows around all edges, apart from each other; nothing if an edge has none.
std::optional<std::vector<MendedWindow>> mended_windows(const Mesh& mesh,
                                                        const ContactLine& line,
                                                        const ContactLaw& law,
                                                        const ContactDensities& computed,
                                                        const std::vector<int>& edges) {
  std::vector<MendedWindow> windows;
  for (int e : edges) {
    if (!windows.empty() && e <= windows.back().window.last) continue;
    LineWindow must{e, e}, may = chain_of(line, e);
    for (;;) {  // beside the window before, or together with it
      if (!windows.empty())
        may.first = std::max(may.first, windows.back().window.last + 1);
      MendedWindow mended = smallest_window(mesh, line, law, computed, must, may);
      if (mended.values.size() > 0) {
        windows.push_back(std::move(mended));
        break;
      }
      const LineWindow chain = chain_of(line, e);
      if (windows.empty() || windows.back().window.first < chain.first)
        return std::nullopt;
      must.first = windows.back().window.first;
      may.first = chain.first;
      windows.pop_back();
    }
  }
  return windows;
}

}  // namespace

std::optional<LocalMending> mend_locally(const Mesh& mesh, const ContactLine& line,
                                         const ContactLaw& law,
                                         const ContactDensities& computed) {
  const ConeCorrection correction = correct_edges_to_cone(mesh, line, law, computed);
  LocalMending mending{
      {correction.densities, computed, correction.shift, correction.uncorrected}, {}};
  const auto windows = mended_windows(mesh, line, law, computed, correction.uncorrected);
  if (!windows) return std::nullopt;
  AdmissibleTractions& tractions = mending.tractions;
  for (const auto& [window, values] : *windows) {
    mending.windows.push_back(window);
    for (int k = 0; k < window.count(); ++k) {
      const int e = window.first + k;
      set_end_values(tractions.balanced, e, values.segment<4>(4 * k));
      set_end_values(tractions.densities, e, values.segment<4>(4 * k));
      tractions.shift[e] = 0;
    }
  }
  return mending;
}

void add_balancing_stresses(const Mesh& mesh, const Stars& stars, const Hooke& hooke,
                            const ContactLine& line, const ContactDensities& computed,
                            const LocalMending& mending, Matrix3Xd& stress) {
  const ContactDensities& balanced = mending.tractions.balanced;
  for (const LineWindow& window : mending.windows) {
    const Patch patch = patch_around(mesh, stars, line, window);
    const int first = window.first, count = window.count();
    const ContactDensities change{balanced.normal.middleCols(first, count) -
                                      computed.normal.middleCols(first, count),
                                  balanced.tangential.middleCols(first, count) -
                                      computed.tangential.middleCols(first, count)};
    Hooke patch_hooke;
    for (int t : patch.triangle) patch_hooke.push_back(hooke[t]);
    const Index dofs = 2 * patch.mesh.vertices.cols();
    const ElasticSystem system{stiffness(patch.mesh, patch_hooke), VectorXd::Zero(dofs),
                               std::vector<char>(dofs, 0), VectorXd::Zero(dofs)};
    const VectorXd u = rebalancing_displacement(
        system, patch.line, nodal_forces(patch.mesh, patch.line, change),
        free_rigid_motions(patch.mesh, system.prescribed));
    const Matrix3Xd added = stresses(patch.mesh, patch_hooke, u);
    for (std::size_t k = 0; k < patch.triangle.size(); ++k)
      stress.col(patch.triangle[k]) += added.col(static_cast<Index>(k));
  }
}

}  // namespace ffcontact
