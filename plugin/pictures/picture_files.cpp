// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures/picture_files.hpp"

#include <array>
#include <string>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/linear/norms.hpp"
//
#include "estimate/estimate_outputs.hpp"
#include "freefem/text_file.hpp"
#include "pictures/name_of_law.hpp"
#include "pictures/picture_folder.hpp"
#include "pictures/vtu.hpp"

namespace ffcontact::plugin {

namespace {

namespace fs = std::filesystem;

/// Vectors of the plane in space [3 x n].
Matrix3Xd in_space(const Ref<const Matrix2Xd>& of_plane) {
  Matrix3Xd vectors = Matrix3Xd::Zero(3, of_plane.cols());
  vectors.topRows<2>() = of_plane;
  return vectors;
}

VtuCells body_triangles(const JoinedMesh& joined, int body) {
  const int v = joined.first_vertex[body], t = joined.first_cell[body];
  VtuCells triangles;
  const Matrix2Xd points =
      joined.mesh.vertices.middleCols(v, joined.first_vertex[body + 1] - v)
          .colwise() +
      joined.mesh.origin;
  triangles.points = in_space(points);
  triangles.corners =
      joined.mesh.cells.middleCols(t, joined.first_cell[body + 1] - t).array() -
      v;
  return triangles;
}

void write_body(const fs::path& folder, long step,
                const ContactProblem<2>& problem,
                const SolvedContact<2>& solved, int body) {
  VtuCells triangles = body_triangles(problem.joined, body);
  triangles.on_points = {
      {"displacement",
       in_space(solved.solution.displacement
                    .segment(problem.first_dof(body), problem.dof_count(body))
                    .reshaped(2, triangles.points.cols()))}};
  if (solved.estimate)
    triangles.on_cells = {
        {"eps_E",
         solved.estimate->local
             .segment(problem.joined.first_cell[body], triangles.corners.cols())
             .transpose()}};
  write_vtu(folder / picture_file("step", step, body), triangles);
}

/// Those of the three subtriangles, one after the other.
Matrix<double, 2, 9> corners_of_parts(const Mesh& mesh, int triangle) {
  const CellCorners<2> corners =
      corners_of(mesh, triangle).colwise() + mesh.origin;
  Matrix<double, 2, 9> points;
  for (int k = 0; k < 3; ++k)
    points.middleCols<3>(3 * k) = subcell<2>(corners, k);
  return points;
}

/// The subtriangles have corners of their own: the stress jumps between them.
void write_stress(const fs::path& folder, long step,
                  const ContactProblem<2>& problem,
                  const std::vector<SubcellStress<2>>& stress, int body) {
  const std::vector<int>& first_triangle = problem.joined.first_cell;
  const int first = first_triangle[body],
            triangles = first_triangle[body + 1] - first;
  const Index count = 9 * triangles;
  MatrixXd at_corners(3, count);
  VtuCells parts;
  Matrix2Xd points(2, count);
  parts.corners =
      Eigen::VectorXi::LinSpaced(count, 0, static_cast<int>(count) - 1)
          .reshaped(3, count / 3);
  for (int t = 0; t < triangles; ++t) {
    at_corners.middleCols<9>(9 * t) = stress[first + t];
    points.middleCols<9>(9 * t) = corners_of_parts(problem.mesh, first + t);
  }
  parts.points = in_space(points);
  const std::array names = {"sxx", "syy", "sxy"};
  for (int c = 0; c < 3; ++c)
    parts.on_points.push_back({names[c], at_corners.row(c)});
  write_vtu(folder / picture_file("stress", step, body), parts);
}

/// The line of each node, from 1 on: contact edges and corners join nodes.
std::vector<int> lines_of_nodes(const ContactProblem<2>& problem) {
  const ContactLine& line = problem.contact;
  Unions lines(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    lines.join(line.edge_node(0, e), line.edge_node(1, e));
  for (int i = 0; i + 1 < line.node_count(); ++i)
    if (line.vertex[i] == line.vertex[i + 1] &&
        problem.abscissa[i] == problem.abscissa[i + 1])
      lines.join(i, i + 1);
  std::vector<int> numbers = lines.numbers();
  for (int& number : numbers) ++number;
  return numbers;
}

/// x, u and the place that faces x along n.
void write_places(const ContactProblem<2>& problem,
                  const SolvedContact<2>& solved, int i, TextFile& text) {
  const int v = problem.contact.vertex[i];
  const Vector2d x = problem.mesh.place(v),
                 u = solved.solution.displacement.segment<2>(2 * v);
  const double gap = value_or(solved.law.gap, i, 0);
  const Vector2d facing = x + gap * problem.contact.normal.col(i);
  for (const Vector2d& of_node : {x, u, facing})
    text << " " << of_node.x() << " " << of_node.y();
}

void write_results(const NodalResults& nodes, int i, TextFile& text) {
  text << " " << nodes.state[i];
  for (const char* name : {"pn", "pt", "fn", "ft", "gap", "slip"})
    text << " " << nodes.values(i, nodal_column(2, name));
}

void write_law(const ContactLaw<2>& law, int i, TextFile& text) {
  const VectorXd& limit = law.tresca() ? law.slip_bound : law.shear_limit;
  text << " " << value_or(law.friction, i, 0) << " "
       << value_or(limit, i, infinity);
}

void write_nodes(const fs::path& file, long step,
                 const ContactProblem<2>& problem,
                 const SolvedContact<2>& solved) {
  const ContactLaw<2>& law = solved.law;
  TextFile text(file);
  text << "# step " << step << " law " << name_of_law(law);
  if (solved.estimate)
    text << " eps " << solved.estimate->relative << " e " << solved.estimate->e;
  text << "\n# abscissa x y ux uy facingx facingy state pn pt fn ft gap slip "
          "friction limit line\n";
  const std::vector<int> lines = lines_of_nodes(problem);
  for (int i = 0; i < problem.contact.node_count(); ++i) {
    text << problem.abscissa[i];
    write_places(problem, solved, i, text);
    write_results(solved.nodes, i, text);
    write_law(law, i, text);
    text << " " << lines[i] << "\n";
  }
  text.close();
}

void write_tractions(const fs::path& file, const ContactProblem<2>& problem,
                     const Estimate<2>& estimate) {
  const ContactDensities& r = estimate.tractions;
  const VectorXd abscissa = abscissae(problem, estimate);
  const std::vector<int> lines = lines_of_nodes(problem);
  TextFile text(file);
  text << "# abscissa rn rt at the first end, abscissa rn rt at the other, "
          "line\n";
  for (int k = 0; k < r.normal.cols(); ++k) {
    for (int end = 0; end < 2; ++end)
      text << abscissa[2 * k + end] << " " << r.normal(end, k) << " "
           << r.tangential(end, k) << " ";
    const int edge =
        estimate.refinement ? estimate.refinement->parent_contact_edge[k] : k;
    text << lines[problem.contact.edge_node(0, edge)] << "\n";
  }
  text.close();
}

}  // namespace

void write_pictures(const fs::path& folder, long step,
                    const ContactProblem<2>& problem,
                    const SolvedContact<2>& solved) {
  make_picture_folder(folder, step);
  const std::string number = std::to_string(step) + ".txt";
  write_nodes(folder / ("contact" + number), step, problem, solved);
  for (int body = 0; body < problem.body_count(); ++body)
    write_body(folder, step, problem, solved, body);
  if (!solved.estimate) return;
  write_tractions(folder / ("tractions" + number), problem, *solved.estimate);
  const std::vector<SubcellStress<2>> stress =
      stress_on_triangles(problem.mesh, *solved.estimate);
  for (int body = 0; body < problem.body_count(); ++body)
    write_stress(folder, step, problem, stress, body);
}

}  // namespace ffcontact::plugin
