// SPDX-License-Identifier: GPL-3.0-or-later
#include "ground.hpp"

#include <Eigen/LU>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact::fuzz {

namespace {

VectorXd on_ground(const Assembled& parts, const Ground& ground,
                   const VectorXd& values) {
  if (values.size() == 0 || &ground.line == &parts.line) return values;
  VectorXd result(ground.line.node_count());
  for (int i = 0; i < ground.line.node_count(); ++i)
    result[i] = value_on_line(parts, values,
                              ground.mesh.vertices.col(ground.line.vertex[i]),
                              ground.line.normal.col(i));
  return result;
}

/// A vertex of the refinement is prescribed where it is an old one that is, or lies
/// between two that are.
std::vector<char> prescribed_on(const Mesh& old_mesh,
                                const std::vector<char>& old, const Mesh& mesh,
                                const std::vector<int>& parent) {
  std::vector<char> result(2 * mesh.vertices.cols(), 1);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Corners corners = corners_at(old_mesh, parent[t]);
    for (int v : mesh.cells.col(t)) {
      const Vector3d w = weights_at(corners, mesh.vertices.col(v));
      for (int c = 0; c < 2; ++c)
        for (int k = 0; k < 3; ++k)
          if (w[k] > 1e-7 && !old[2 * old_mesh.cells(k, parent[t]) + c])
            result[2 * v + c] = 0;
    }
  }
  return result;
}

}  // namespace

Corners corners_at(const Mesh& mesh, int triangle) {
  Corners corners;
  for (int k = 0; k < 3; ++k)
    corners.col(k) = mesh.vertices.col(mesh.cells(k, triangle));
  return corners;
}

Corners subtriangle(const Corners& corners, int k) {
  Corners sub;
  sub << corners.col((k + 1) % 3), corners.col((k + 2) % 3),
      corners.rowwise().mean();
  return sub;
}

Ground ground_of(const Assembled& parts, const Estimate<2>& estimate) {
  if (!estimate.refinement) {
    std::vector<int> parent(parts.mesh().cells.cols());
    for (std::size_t t = 0; t < parent.size(); ++t)
      parent[t] = static_cast<int>(t);
    return {parts.mesh(),  parts.line,         parts.region,
            parent,        parts.law.friction, parts.law.slip_bound,
            parts.law.gap, parts.law.previous, parts.prescribed};
  }
  const CommonRefinement& refinement = *estimate.refinement;
  Ground ground{refinement.mesh,
                refinement.line,
                {},
                {refinement.parent.begin(), refinement.parent.end()},
                {},
                {},
                {},
                {},
                {}};
  for (int t : ground.parent) ground.region.push_back(parts.region[t]);
  ground.friction = on_ground(parts, ground, parts.law.friction);
  ground.slip_bound = on_ground(parts, ground, parts.law.slip_bound);
  ground.gap = on_ground(parts, ground, parts.law.gap);
  ground.previous = on_ground(parts, ground, parts.law.previous);
  ground.prescribed =
      prescribed_on(parts.mesh(), parts.prescribed, ground.mesh, ground.parent);
  return ground;
}

double missed_push(const RigidTool& tool, const Matrix2Xd& x,
                   const Matrix2Xd& f, double length) {
  Vector3d sum(0, 0, 0);
  double size = tool.push.head<2>().norm() + std::abs(tool.push[2]) / length;
  for (Index k = 0; k < x.cols(); ++k) {
    const Vector2d arm = x.col(k) - tool.about, F = f.col(k);
    sum += Vector3d(F.x(), F.y(), arm.x() * F.y() - arm.y() * F.x());
    size += F.norm() * (1 + arm.norm() / length);
  }
  Vector3d off = sum - tool.push;
  off[2] = tool.free.cols() > 2 ? off[2] / length : 0;
  return size > 0 ? off.norm() / size : 0;
}

Dense mass_of(const Mesh& mesh, const ContactLine& line) {
  Dense M = Dense::Zero(line.node_count(), line.node_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    const double length =
        (mesh.vertices.col(line.vertex[i]) - mesh.vertices.col(line.vertex[j]))
            .norm();
    M(i, i) += length / 3;
    M(j, j) += length / 3;
    M(i, j) += length / 6;
    M(j, i) += length / 6;
  }
  return M;
}

Matrix2Xd against_foundation(const ContactLine& line, const VectorXd& gap,
                             const VectorXd& previous, const VectorXd& u) {
  Matrix2Xd w(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i) {
    Vector2d jump = u.segment<2>(2 * line.vertex[i]);
    if (line.opposite.rows() > 0)
      for (WeightsByNode::InnerIterator part(line.opposite, i); part; ++part)
        jump -= part.value() * u.segment<2>(2 * part.col());
    const Vector2d n = line.normal.col(i), t(-n.y(), n.x());
    w(0, i) = jump.dot(n) - (gap.size() > 0 ? gap[i] : 0);
    w(1, i) = jump.dot(t) - (previous.size() > 0 ? previous[i] : 0);
  }
  return w;
}

Vector3d stress_of(const Mesh& mesh, int triangle, const Matrix3d& C,
                   const VectorXd& u) {
  const Corners x = corners_at(mesh, triangle);
  Vector3d strain = Vector3d::Zero();
  const Vector2d u0 = u.segment<2>(2 * mesh.cells(0, triangle));
  for (int k = 1; k < 3;
       ++k) {  // differences to the first corner: rigid motions cancel
    const Vector2d side = x.col((k + 2) % 3) - x.col((k + 1) % 3);
    const Vector2d g = Vector2d(-side.y(), side.x()) / (2 * area_of(x));
    const Vector2d d = u.segment<2>(2 * mesh.cells(k, triangle)) - u0;
    strain +=
        Vector3d(g.x() * d.x(), g.y() * d.y(), g.y() * d.x() + g.x() * d.y());
  }
  return C * strain;
}

double displacement_scale(const Assembled& parts, const VectorXd& u) {
  double scale =
      std::max({max_norm(u), max_norm(parts.value), max_norm(parts.law.gap),
                max_norm(parts.law.previous)});
  const VectorXd diagonal = parts.stiffness.diagonal();
  for (Index dof = 0; dof < diagonal.size(); ++dof)
    if (!parts.prescribed[dof])
      scale = std::max(scale, std::abs(parts.load[dof]) / diagonal[dof]);
  return scale;
}

double stress_scale(const Assembled& parts, const Ground& ground,
                    const VectorXd& u) {
  // of a displacement, in units of 1e-12: 1e-16 with all that cancels
  constexpr double rounding = 1e-4;
  double scale = 0;
  const double largest = displacement_scale(parts, u);
  for (int t = 0; t < ground.mesh.cell_count(); ++t) {
    const Matrix3d& C = parts.elasticity[ground.region[t]];
    scale =
        std::max(scale, stress_of(ground.mesh, t, C, u).cwiseAbs().maxCoeff());
    const Corners x = corners_at(ground.mesh, t);
    double side = 0;
    for (int k = 0; k < 3; ++k)
      side = std::max(side, (x.col(k) - x.col((k + 1) % 3)).norm());
    scale = std::max(scale, rounding * C.cwiseAbs().maxCoeff() * largest *
                                side / area_of(x));
    scale = std::max(scale, parts.body_force.col(ground.parent[t]).norm() *
                                std::sqrt(area_of(x)));
  }
  for (int e = 0; e < parts.mesh().boundary.cols(); ++e) {
    const double length =
        (parts.mesh().vertices.col(parts.mesh().boundary(0, e)) -
         parts.mesh().vertices.col(parts.mesh().boundary(1, e)))
            .norm();
    scale = std::max(scale,
                     2 * parts.neumann.col(e).cwiseAbs().maxCoeff() / length);
  }
  return scale;
}

double square_called_zero(const Assembled& parts, const Ground& ground,
                          const Estimate<2>& estimate) {
  if (estimate.e != 0) return 0;
  double compliance = 0;
  for (int t = 0; t < ground.mesh.cell_count(); ++t)
    compliance +=
        area_of(corners_at(ground.mesh, t)) *
        parts.elasticity[ground.region[t]].inverse().cwiseAbs().maxCoeff();
  return compliance *
         std::pow(1e-8 * stress_scale(parts, ground, estimate.displacement), 2);
}

}  // namespace ffcontact::fuzz
