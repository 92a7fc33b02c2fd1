// SPDX-License-Identifier: GPL-3.0-or-later
#include "assembly.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/solve_contact.hpp"

namespace ffcontact::fuzz {

namespace {

/// B of one triangle, strain = B u, and twice its area.
struct Element {
  Matrix<double, 3, 6> strain;
  double area;
};

Element element_of(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d u = b - a, v = c - a, w = c - b;
  const double twice = u.x() * v.y() - u.y() * v.x();
  Element element;
  element.area = twice / 2;
  element.strain << -w.y(), 0, v.y(), 0, -u.y(), 0,  //
      0, w.x(), 0, -v.x(), 0, u.x(),                 //
      w.x(), -w.y(), -v.x(), v.y(), u.x(), -u.y();
  element.strain /= twice;
  return element;
}

void put_bodies(const Case& problem, Assembled& parts) {
  const Mesh& mesh = parts.mesh();
  const Index dofs = 2 * mesh.vertices.cols();
  parts.load = parts.value = VectorXd::Zero(dofs);
  parts.prescribed.assign(dofs, 0);
  parts.neumann = Matrix4Xd::Zero(4, mesh.boundary.cols());
  parts.body_force.resize(2, mesh.cells.cols());
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    const Body& body = problem.bodies[k];
    const int first = static_cast<int>(parts.elasticity.size()),
              vertex = parts.joined.first_vertex[k];
    for (const Material& material : body.materials)
      parts.elasticity.push_back(elasticity_of(material));
    for (int region : body.region) parts.region.push_back(first + region);
    for (int t = 0; t < body.mesh.cell_count(); ++t)
      parts.body_force.col(parts.joined.first_cell[k] + t) = body.force;
    for (int e = 0; e < body.mesh.boundary.cols(); ++e) {
      const int a = body.mesh.boundary(0, e), b = body.mesh.boundary(1, e),
                label = body.mesh.boundary_label[e];
      const double length =
          (body.mesh.vertices.col(b) - body.mesh.vertices.col(a)).norm();
      for (const Traction& traction : body.tractions)
        if (traction.label == label)
          parts.neumann.col(parts.joined.first_boundary[k] + e) +=
              (length / 2 * traction.value).replicate<2, 1>();
      for (const Support& support : body.supports)
        if (support.label == label)
          for (int v : {a, b}) {
            parts.prescribed[2 * (vertex + v) + support.component] = 1;
            parts.value[2 * (vertex + v) + support.component] =
                support.value.at(problem.place(body.mesh.vertices.col(v)));
          }
    }
  }
}

void put_stiffness(Assembled& parts) {
  const Mesh& mesh = parts.mesh();
  std::vector<Eigen::Triplet<double>> entries;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Element element =
        element_of(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    const Matrix3d& C = parts.elasticity[parts.region[t]];
    parts.hooke.push_back(C);
    const Matrix<double, 6, 6> K =
        element.area * element.strain.transpose() * C * element.strain;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        entries.emplace_back(2 * mesh.cells(i / 2, t) + i % 2,
                             2 * mesh.cells(j / 2, t) + j % 2,
                             0.5 * (K(i, j) + K(j, i)));
    for (int v : mesh.cells.col(t))
      parts.load.segment<2>(2 * v) +=
          element.area / 3 * parts.body_force.col(t);
  }
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    for (int end = 0; end < 2; ++end)
      parts.load.segment<2>(2 * mesh.boundary(end, e)) +=
          parts.neumann.block<2, 1>(2 * end, e);
  parts.stiffness.resize(parts.load.size(), parts.load.size());
  parts.stiffness.setFromTriplets(entries.begin(), entries.end());
}

/// Supports as FreeFEM writes them: 1e30 on the diagonal; the row gone (-1); row and
/// column gone (-2).
void put_matrix(double tgv, Assembled& parts) {
  parts.A = parts.stiffness;
  parts.b = parts.load;
  for (Index dof = 0; dof < parts.b.size(); ++dof) {
    for (RowMatrix::InnerIterator entry(parts.A, dof); entry; ++entry) {
      const bool own = parts.prescribed[dof],
                 other = parts.prescribed[entry.col()];
      if (entry.col() == dof && own)
        entry.valueRef() = tgv > 0 ? tgv : 1;
      else if ((own && tgv < 0) || (other && tgv == -2))
        entry.valueRef() = 0;
    }
    if (parts.prescribed[dof])
      parts.b[dof] = (tgv > 0 ? tgv : 1) * parts.value[dof];
  }
  parts.A.prune(
      [](Index i, Index j, double value) { return i == j || value != 0; });
}

/// Values of a field at the nodes of the line, by the coordinates of the case.
VectorXd at_nodes(const Case& problem, const Field& field,
                  const Assembled& parts, bool positive) {
  std::vector<Vector2d> vertices;
  for (const Body& body : problem.bodies)
    for (int v = 0; v < body.mesh.vertex_count(); ++v)
      vertices.push_back(body.mesh.vertices.col(v));
  VectorXd values(parts.line.node_count());
  for (int i = 0; i < values.size(); ++i) {
    values[i] = field.at(problem.place(vertices[parts.line.vertex[i]]));
    if (positive) values[i] = std::max(0.0, values[i]);
  }
  return values;
}

/// The lines with what faces them, and the gaps of the meshes.
void put_lines(const Case& problem, Assembled& parts) {
  const Mesh& mesh = parts.mesh();
  std::vector<ContactLine> lines;
  std::vector<double> gaps;
  for (const Contact& contact : problem.contacts) {
    std::vector<int> labels;
    for (int label : contact.labels)
      labels.push_back(parts.joined.label(contact.body, label));
    ContactLine line = contact_line(mesh, parts.edges, labels);
    if (!contact.opposites.empty()) {
      std::vector<int> opposite;
      for (const auto& [body, label] : contact.opposites)
        opposite.push_back(parts.joined.label(body, label));
      const FacingTraces traces =
          facing_traces(mesh, parts.edges, line, opposite);
      line = facing_line(mesh, parts.edges, line, traces);
      const VectorXd gap = facing_gap(line);
      gaps.insert(gaps.end(), gap.begin(), gap.end());
    } else {
      gaps.resize(gaps.size() + line.node_count(), 0.0);
    }
    lines.push_back(line);
  }
  parts.line = joined_contact<2>(lines);
  parts.law.gap = Map<VectorXd>(gaps.data(), static_cast<Index>(gaps.size()));
}

void put_law(const Case& problem, Assembled& parts) {
  const auto values = [&](const Field& field, bool positive) {
    return at_nodes(problem, field, parts, positive);
  };
  ContactLaw<2>& law = parts.law;
  law.multiplier = problem.multiplier;
  law.friction = VectorXd::Zero(parts.line.node_count());
  if (problem.law == Law::coulomb)
    law.friction = values(problem.friction, true);
  if (problem.law == Law::tresca)
    law.slip_bound = values(problem.slip_bound, true);
  if (problem.has_gap) law.gap = values(problem.gap, false);
  if (problem.has_previous) law.previous = values(problem.previous, false);
}

/// Every triangle cut into four; new vertices come after the old ones, with the two they
/// lie between.
struct Cut {
  Mesh mesh;
  std::map<std::pair<int, int>, int> middle;
};

Cut cut_in_four(const Mesh& mesh) {
  Cut cut;
  std::vector<Vector2d> vertices(mesh.vertices.colwise().begin(),
                                 mesh.vertices.colwise().end());
  const auto between = [&](int a, int b) {
    const auto [place, is_new] = cut.middle.emplace(
        std::minmax(a, b), static_cast<int>(vertices.size()));
    if (is_new)
      vertices.push_back(0.5 * (mesh.vertices.col(a) + mesh.vertices.col(b)));
    return place->second;
  };
  cut.mesh.cells.resize(3, 4 * mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Vector3i v = mesh.cells.col(t);
    const Vector3i m(between(v[1], v[2]), between(v[2], v[0]),
                     between(v[0], v[1]));
    cut.mesh.cells.middleCols<4>(4 * t) << v[0], v[1], v[2], m[0], m[2], m[0],
        m[1], m[1], m[1], m[2], m[0], m[2];
  }
  cut.mesh.boundary.resize(2, 2 * mesh.boundary.cols());
  cut.mesh.boundary_label.resize(2 * mesh.boundary.cols());
  for (Index e = 0; e < mesh.boundary.cols(); ++e) {
    const int a = mesh.boundary(0, e), b = mesh.boundary(1, e),
              m = between(a, b);
    cut.mesh.boundary.middleCols<2>(2 * e) << a, m, m, b;
    cut.mesh.boundary_label.segment<2>(2 * e).setConstant(
        mesh.boundary_label[e]);
  }
  cut.mesh.vertices.resize(2, static_cast<Index>(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v)
    cut.mesh.vertices.col(static_cast<Index>(v)) = vertices[v];
  return cut;
}

/// Values at the nodes of the coarse line, at those of the fine one.
VectorXd on_halves(const Assembled& coarse, const Assembled& fine,
                   const VectorXd& values) {
  if (values.size() == 0) return values;
  VectorXd result(fine.line.node_count());
  for (int i = 0; i < result.size(); ++i)
    result[i] = value_on_line(coarse, values,
                              fine.point_in(coarse, fine.line.vertex[i]),
                              fine.line.normal.col(i));
  return result;
}

}  // namespace

Matrix3d elasticity_of(const Material& m) {
  Matrix3d C;
  C << 1 - m.nu, m.nu, 0, m.nu, 1 - m.nu, 0, 0, 0, 0.5 - m.nu;
  return m.E / ((1 + m.nu) * (1 - 2 * m.nu)) * C;
}

double value_on_line(const Assembled& parts, const VectorXd& values,
                     const Vector2d& point, const Vector2d& normal) {
  const ContactLine& line = parts.line;
  double nearest = std::numeric_limits<double>::infinity(), value = 0;
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    const Vector2d a = parts.mesh().vertices.col(line.vertex[i]);
    const Vector2d d = Vector2d(parts.mesh().vertices.col(line.vertex[j])) - a;
    const double s = std::clamp((point - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    const double distance =
        (point - a - s * d).norm() +
        (1 - line.edge_normal(e).dot(normal)) * line.length.sum();
    if (distance >= nearest) continue;
    nearest = distance;
    value = (1 - s) * values[i] + s * values[j];
  }
  return value;
}

Vector2d Assembled::point_in(const Assembled& other, int vertex) const {
  return mesh().vertices.col(vertex) +
         (other.mesh().vertices.col(0) - mesh().vertices.col(0));
}

namespace {

RigidTool rigid_tool(const Tool& tool, const Vector2d& origin) {
  RigidTool rigid;
  rigid.about = tool.about - origin;
  rigid.push << tool.push, tool.moment;
  rigid.free = Matrix3d::Identity().leftCols(tool.turns ? 3 : 2);
  return rigid;
}

}  // namespace

SolvedBody<2> Assembled::solved(const ContactSolution<2>& solution) const {
  SolvedBody<2> body;
  body.hooke = hooke;
  body.displacement = solution.displacement;
  body.multipliers = solution.pressure;
  body.law = law;
  body.tool = tool;
  body.neumann = neumann;
  body.body_loads.resize(6, mesh().cells.cols());
  for (int t = 0; t < mesh().cell_count(); ++t)
    body.body_loads.col(t) =
        (element_of(mesh().corner(t, 0), mesh().corner(t, 1),
                    mesh().corner(t, 2))
             .area /
         3 * body_force.col(t))
            .replicate<3, 1>();
  return body;
}

Assembled assembled(const Case& problem) {
  std::vector<Mesh> meshes;
  for (const Body& body : problem.bodies) meshes.push_back(body.mesh);
  Assembled parts;
  parts.joined = joined_mesh(meshes);
  parts.edges = edges_of(parts.mesh());
  put_bodies(problem, parts);
  put_stiffness(parts);
  put_matrix(problem.tgv, parts);
  put_lines(problem, parts);
  put_law(problem, parts);
  if (problem.tool) parts.tool = rigid_tool(*problem.tool, parts.mesh().origin);
  return parts;
}

ContactSolution<2> solved_contact(Assembled& parts,
                                  const ElasticSystem& system) {
  if (!parts.tool)
    return solve_contact(parts.mesh(), parts.line, parts.law, system);
  ToolSolution solved = solve_contact_with_tool(parts.mesh(), parts.line,
                                                parts.law, system, *parts.tool);
  parts.before_tool = parts.law.previous;
  parts.law = std::move(solved.law);
  return std::move(solved.solution);
}

Refined refined(const Case& problem, const Assembled& coarse) {
  Refined fine;
  fine.problem = problem;
  for (Body& body : fine.problem.bodies) {
    body.mesh = cut_in_four(body.mesh).mesh;
    std::vector<int> region;
    for (int r : body.region) region.insert(region.end(), 4, r);
    body.region = region;
  }
  fine.parts = assembled(fine.problem);
  ContactLaw<2>& law = fine.parts.law;
  law.friction = on_halves(coarse, fine.parts, coarse.law.friction);
  law.slip_bound = on_halves(coarse, fine.parts, coarse.law.slip_bound);
  law.gap = on_halves(coarse, fine.parts, coarse.law.gap);
  law.previous = on_halves(coarse, fine.parts, coarse.law.previous);
  return fine;
}

}  // namespace ffcontact::fuzz
