// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures/solid_picture_files.hpp"

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
//
#include "freefem/text_file.hpp"
#include "pictures/gmsh_fields.hpp"
#include "pictures/name_of_law.hpp"
#include "pictures/picture_folder.hpp"
#include "pictures/vtu.hpp"

namespace ffcontact::plugin {

namespace {

namespace fs = std::filesystem;

VtuCells body_cells(const ContactProblem<3>& problem,
                    const SolvedContact<3>& solved, int body) {
  const JoinedSolids& joined = problem.joined;
  const int v = joined.first_vertex[body], t = joined.first_cell[body],
            vertices = joined.first_vertex[body + 1] - v,
            tetrahedra = joined.first_cell[body + 1] - t;
  VtuCells cells;
  cells.points = joined.mesh.vertices.middleCols(v, vertices).colwise() +
                 joined.mesh.origin;
  cells.corners = joined.mesh.cells.middleCols(t, tetrahedra).array() - v;
  cells.on_points = {
      {"displacement", solved.solution.displacement.segment(3 * v, 3 * vertices)
                           .reshaped(3, vertices)}};
  if (solved.estimate)
    cells.on_cells = {
        {"eps_E", solved.estimate->local.segment(t, tetrahedra).transpose()}};
  return cells;
}

/// The four subtetrahedra k+1, k+2, k+3, centroid of each tetrahedron, with corners of
/// their own: the stress jumps between them.
void write_stress(const fs::path& file, const ContactProblem<3>& problem,
                  const Topology<3>& topology, const SolvedContact<3>& solved,
                  int body) {
  const std::vector<int>& first_cell = problem.joined.first_cell;
  const int first = first_cell[body], count = first_cell[body + 1] - first;
  MatrixXd at_corners(6, 16 * count);
  VtuCells parts;
  parts.points.resize(3, 16 * count);
  parts.corners = Eigen::VectorXi::LinSpaced(16 * count, 0, 16 * count - 1)
                      .reshaped(4, 4 * count);
  for (int t = 0; t < count; ++t) {
    const CellCorners<3> x =
        corners_of(problem.mesh, first + t).colwise() + problem.mesh.origin;
    at_corners.middleCols<16>(16 * t) =
        stress_of(topology, *solved.estimate, *solved.judged, first + t);
    for (int k = 0; k < 4; ++k)
      parts.points.middleCols<4>(16 * t + 4 * k) << x.col((k + 1) % 4),
          x.col((k + 2) % 4), x.col((k + 3) % 4), x.rowwise().mean();
  }
  const std::array names = {"sxx", "syy", "szz", "syz", "sxz", "sxy"};
  for (int c = 0; c < 6; ++c)
    parts.on_points.push_back({names[c], at_corners.row(c)});
  write_vtu(file, parts);
}

/// What the nodes have, by name.
std::vector<VtuField> nodal_fields(const ContactProblem<3>& problem,
                                   const SolvedContact<3>& solved) {
  const NodalResults& nodes = solved.nodes;
  const ContactLaw<3>& law = solved.law;
  const int count = problem.contact.node_count();
  MatrixXd bounds(2, count), state(1, count);
  for (int i = 0; i < count; ++i) {
    bounds(0, i) = value_or(law.friction, i, 0);
    bounds(1, i) =
        value_or(law.slip_bound.size() > 0 ? law.slip_bound : law.shear_limit,
                 i, std::numeric_limits<double>::infinity());
    state(0, i) = static_cast<double>(nodes.state[i]);
  }
  std::vector<VtuField> fields = {{"state", state}};
  for (const char* name :
       {"pn", "pt1", "pt2", "fx", "fy", "fz", "fn", "gap", "slip1", "slip2"})
    fields.push_back(
        {name, nodes.values.col(nodal_column(3, name)).transpose()});
  fields.push_back({"friction", bounds.row(0)});
  fields.push_back({"limit", bounds.row(1)});
  if (!solved.estimate) return fields;
  const std::array names = {"rn", "rt1", "rt2"};
  for (int c = 0; c < 3; ++c)
    fields.push_back({names[c], solved.estimate->tractions.row(c)});
  return fields;
}

void write_nodes(const fs::path& file, long step,
                 const ContactProblem<3>& problem,
                 const SolvedContact<3>& solved,
                 const std::vector<VtuField>& fields) {
  TextFile text(file);
  text << "# step " << step << " law " << name_of_law(solved.law);
  if (solved.estimate)
    text << " eps " << solved.estimate->relative << " e " << solved.estimate->e;
  text << "\n# x y z ux uy uz nx ny nz";
  for (const VtuField& field : fields) text << " " << field.name;
  text << "\n";
  const Matrix3Xd places = problem.places();
  for (int i = 0; i < problem.contact.node_count(); ++i) {
    const Vector3d u =
        solved.solution.displacement.segment<3>(3 * problem.contact.vertex[i]);
    text << places(0, i) << " " << places(1, i) << " " << places(2, i);
    for (const Vector3d& of_node : {u, Vector3d(problem.contact.normal.col(i))})
      for (const double component : of_node) text << " " << component;
    for (const VtuField& field : fields) text << " " << field.values(0, i);
    text << "\n";
  }
  text.close();
}

/// Faces whose vertices are all nodes.
void write_surface(const fs::path& file, const ContactProblem<3>& problem,
                   const SolvedContact<3>& solved,
                   std::vector<VtuField> fields) {
  std::vector<Vector3i> faces;
  for (int m = 0; m < problem.contact.face_count(); ++m)
    if (problem.contact.face_node.col(m).minCoeff() >= 0)
      faces.emplace_back(problem.contact.face_node.col(m));
  VtuCells cells;
  cells.points = problem.places();
  cells.corners = packed(faces);
  MatrixXd displacement(3, cells.points.cols());
  for (Index i = 0; i < displacement.cols(); ++i)
    displacement.col(i) =
        solved.solution.displacement.segment<3>(3 * problem.contact.vertex[i]);
  fields.push_back({"displacement", displacement});
  cells.on_points = std::move(fields);
  write_vtu(file, cells);
}

}  // namespace

void write_pictures(const fs::path& folder, long step,
                    const ContactProblem<3>& problem,
                    const SolvedContact<3>& solved) {
  make_picture_folder(folder, step);
  const std::vector<VtuField> fields = nodal_fields(problem, solved);
  write_nodes(folder / ("contact" + std::to_string(step) + ".txt"), step,
              problem, solved, fields);
  write_surface(folder / picture_file("surface", step, 0), problem, solved,
                fields);
  for (int body = 0; body < problem.body_count(); ++body) {
    const VtuCells cells = body_cells(problem, solved, body);
    write_vtu(folder / picture_file("step", step, body), cells);
    write_gmsh_fields(folder / picture_file("step", step, body, ".msh"),
                      *problem.fem_meshes[body], cells);
  }
  if (!solved.estimate) return;
  const Topology<3> topology = problem.topology();
  for (int body = 0; body < problem.body_count(); ++body)
    write_stress(folder / picture_file("stress", step, body), problem, topology,
                 solved, body);
}

}  // namespace ffcontact::plugin
