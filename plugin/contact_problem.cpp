// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/curve_directions.hpp"
#include "ffcontact/mesh/facing_traces.hpp"
//
#include <algorithm>
#include <utility>

#include "contact_problem.hpp"

namespace ffcontact::plugin {

namespace {

/// The line by its own normals, or along the directions of normal=.
ContactLine line_of(Stack stack, const NamedArguments& named, const BodyPart& part, const Mesh& mesh,
                    const Edges& edges, const std::vector<int>& labels) {
  if (!named.given("normal")) return curved_contact_line(mesh, edges, labels);
  const ContactLine line = smooth_contact_line(mesh, edges, labels);
  Eigen::Matrix2Xd direction(2, line.node_count());
  for (int c = 0; c < 2; ++c)
    direction.row(c) = at_nodes(stack, named.component("normal", c, 2), part, edges, line, 0).transpose();
  return along_directions(mesh, edges, line, direction);
}

JoinedMesh joined_meshes(const std::vector<pmesh>& fem_meshes) {
  std::vector<Mesh> meshes;
  for (pmesh fem_mesh : fem_meshes) meshes.push_back(mesh_of(fem_mesh));
  return joined_mesh(meshes);
}

/// What is stated for each body.
const NamedArguments::Table of_bodies = {{"label", &typeid(KN_<long>)}, {"previous", &typeid(KN<double>*)}};

/// The labels of one body in the joined mesh's numbering.
std::vector<int> joined_labels(Stack stack, const NamedArguments& named, const std::string& name,
                               const JoinedMesh& joined, int body) {
  std::vector<int> labels = named.integers(stack, name);
  if (joined.body_count() > 1 && labels.empty()) refuse(name, "= is not given");
  const int first = joined.first_boundary[body], end = joined.first_boundary[body + 1];
  for (int& label : labels) {
    const int own = std::exchange(label, joined.label(body, label));
    const auto* all = joined.mesh.boundary_label.data();
    if (joined.body_count() > 1 && std::find(all + first, all + end, label) == all + end)
      refuse(name, " is ", own, ", which is on no boundary edge of mesh ", body + 1);
  }
  return labels;
}

/// Bodies may overlap a little, as polygons of curves do and interference fits, but not by more than their contact edges.
void require_apart(const Mesh& mesh, const ContactLine& line, const Eigen::VectorXd& gap) {
  for (int i = 0; i < gap.size(); ++i) {
    const Eigen::Vector2d x = mesh.place(line.vertex[i]);
    if (gap[i] < -line.length.maxCoeff())
      refuse("the bodies overlap by ", -gap[i], " at (", x.x(), ", ", x.y(),
             "), more than a contact edge: is the facing edge behind the contact line? Give gap= if it is meant");
  }
}

void append(const Eigen::VectorXd& values, Eigen::VectorXd& all) {
  const Eigen::Index before = all.size();
  all.conservativeResize(before + values.size());
  all.tail(values.size()) = values;
}

void append(const Eigen::Matrix2Xd& values, Eigen::Matrix2Xd& all) {
  const Eigen::Index before = all.cols();
  all.conservativeResize(Eigen::NoChange, before + values.cols());
  all.rightCols(values.cols()) = values;
}

void require_law(const NamedArguments& named) {
  if (!named.given("friction") && !named.given("slipbound"))
    refuse("no law is given: friction= (Coulomb's coefficient, 0 for none), slipbound= (Tresca's bound), or both");
}

/// Points of an edge at which a coefficient is evaluated.
constexpr int samples_of_an_edge = 9;

}  // namespace

NamedArguments::Table ContactProblem::table(const basicAC_F0& arguments) {
  NamedArguments::Table table = for_bodies(of_bodies, arguments);
  table.insert(table.end(), {{"opposite", &typeid(KN_<long>)},
                             {"friction", &typeid(double)},
                             {"slipbound", &typeid(double)},
                             {"gap", &typeid(double)},
                             {"normal", &typeid(E_Array)}});
  return table;
}

Multiplier multiplier_of(Stack stack, const NamedArguments& named) {
  const std::string name = named.text(stack, "multiplier", "force");
  if (name == "pressure") return Multiplier::pressure;
  if (name != "force") refuse("multiplier must be \"pressure\" or \"force\", got \"", name, "\"");
  return Multiplier::force;
}

ContactProblem::ContactProblem(Stack stack, const NamedArguments& named, const std::vector<pmesh>& meshes)
    : joined(joined_meshes(meshes)), fem_meshes(meshes.begin(), meshes.end()), edges(edges_of(joined.mesh)) {
  const int bodies = body_count();
  require_names_of_bodies(named, of_bodies, bodies);
  require_law(named);
  if (bodies > 1 && named.given("opposite")) refuse("opposite= is given, but the contact has ", bodies, " meshes");
  std::vector<std::vector<int>> labels;
  for (int k = 0; k < bodies; ++k) {
    labels.push_back(joined_labels(stack, named, name_of_body("label", k, bodies), joined, k));
    if (k > 0 && k + 1 < bodies && labels[k].size() != 2)
      refuse("label", k + 1, " must be two labels: the first faces body ", k, ", the second body ", k + 2);
  }
  std::vector<ContactLine> lines;
  if (bodies == 1) {
    const std::vector<int> opposite = joined_labels(stack, named, "opposite", joined, 0);
    add_pair(stack, named, 0, labels[0], 0, opposite, lines);
  }
  for (int k = 0; k + 1 < bodies; ++k)
    add_pair(stack, named, k, k == 0 ? labels[k] : std::vector<int>{labels[k][1]}, k + 1,
             k + 2 == bodies ? labels[k + 1] : std::vector<int>{labels[k + 1][0]}, lines);
  line = lines.size() == 1 ? std::move(lines.front()) : joined_lines(lines);

  add_previous(stack, named);
  require_valid(law, line);
}

void ContactProblem::add_previous(Stack stack, const NamedArguments& named) {
  Eigen::VectorXd previous = Eigen::VectorXd::Zero(2 * mesh.vertices.cols());
  bool incremental = false;
  for (int k = 0; k < body_count(); ++k) {
    const std::string name = name_of_body("previous", k, body_count());
    const Expression expression = named.expression(name);
    KN<double>* u = expression ? GetAny<KN<double>*>((*expression)(stack)) : nullptr;
    if (!u || u->N() == 0) continue;
    require_dofs(name.c_str(), k, u->N());
    previous.segment(first_dof(k), dof_count(k)) = vector_of(u);
    incremental = true;
  }
  if (incremental) law.previous = contact_components(line, previous).row(1);
}

void ContactProblem::add_pair(Stack stack, const NamedArguments& named, int body, const std::vector<int>& labels,
                              int opposite_body, const std::vector<int>& opposite_labels,
                              std::vector<ContactLine>& lines) {
  const BodyPart part{*fem_meshes[body], joined.first_vertex[body], joined.first_boundary[body]};
  ContactLine own = line_of(stack, named, part, mesh, edges, labels);
  const bool rigid = opposite_labels.empty() && opposite_body == body;
  if (!named.given("normal") && turns(own)) {
    const Expression gap = named.expression("gap");
    const Eigen::VectorXd distance =
        gap || rigid ? at_nodes(stack, gap, part, edges, own, 0) : facing_traces(mesh, edges, own, opposite_labels).gap;
    own = with_one_direction_a_curve(mesh, edges, std::move(own), distance);
  }
  for (int v : own.vertex) own_vertex.push_back(v - joined.first_vertex[body]);
  if (rigid) {
    add_coefficients(stack, named, body, own, {});
    lines.push_back(std::move(own));
    return;
  }
  const FacingTraces traces = facing_traces(mesh, edges, own, opposite_labels);
  add_coefficients(stack, named, body, own, traces.gap);
  lines.push_back(facing_line(mesh, edges, std::move(own), traces));
}

void ContactProblem::add_coefficients(Stack stack, const NamedArguments& named, int body, const ContactLine& own,
                                      const Eigen::VectorXd& mesh_gap) {
  const BodyPart part{*fem_meshes[body], joined.first_vertex[body], joined.first_boundary[body]};
  const Expression friction = named.expression("friction"), slip_bound = named.expression("slipbound");
  const auto add = [&](Expression coefficient, Eigen::VectorXd& nodal, EdgeRange& between_nodes) {
    append(at_nodes(stack, coefficient, part, edges, own, 0), nodal);
    if (!coefficient) return;
    const EdgeRange range = enclosing_range(along_edges(stack, coefficient, part, edges, own, samples_of_an_edge));
    append(range.least, between_nodes.least);
    append(range.most, between_nodes.most);
  };
  add(friction, law.friction, law.between_nodes);
  if (slip_bound && friction)
    add(slip_bound, law.shear_limit, law.limit_between_nodes);
  else if (slip_bound)
    add(slip_bound, law.slip_bound, law.between_nodes);
  if (const Expression gap = named.expression("gap")) {
    append(at_nodes(stack, gap, part, edges, own, 0), law.gap);
  } else {
    require_apart(mesh, own, mesh_gap);
    append(mesh_gap, law.gap);
  }
}

void ContactProblem::require_dofs(const char* name, int body, Eigen::Index count) const {
  if (count != dof_count(body))
    refuse(name, " has size ", count, " but [P1, P1] has ", dof_count(body), " dofs on this mesh");
}

void ContactProblem::require_bodies(const char* names, std::size_t count) const {
  if (static_cast<int>(count) != body_count())
    refuse(names, " are given for ", count, " bodies, but the contact has ", body_count());
}

Eigen::Matrix2Xd ContactProblem::pressures(KN<double>* normal, KN<double>* tangential) const {
  require_size("pn", normal->N(), line.node_count());
  require_size("pt", tangential->N(), line.node_count());
  Eigen::Matrix2Xd pressure(2, line.node_count());
  pressure.row(0) = vector_of(normal).transpose();
  pressure.row(1) = vector_of(tangential).transpose();
  return pressure;
}

}  // namespace ffcontact::plugin
