// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/compliance_ratio.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/facing_line.hpp"
#include "ffcontact/interface/joined_lines.hpp"
#include "ffcontact/interface/line_ends.hpp"
//
#include <algorithm>
#include <map>
#include <utility>

#include "contact_problem.hpp"

namespace ffcontact::plugin {

namespace {

/// The line by its own normals, or along the directions of normal=.
ContactLine line_of(Stack stack, const NamedArguments& named,
                    const BodyPart& part, const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& labels) {
  if (!named.given("normal")) return curved_contact_line(mesh, edges, labels);
  const ContactLine line = smooth_contact_line(mesh, edges, labels);
  Matrix2Xd direction(2, line.node_count());
  for (int c = 0; c < 2; ++c)
    direction.row(c) = at_nodes(stack, named.component("normal", c, 2), part,
                                edges, line, stated_places(line, false), 0)
                           .transpose();
  return along_directions(mesh, edges, line, direction);
}

JoinedMesh joined_meshes(const std::vector<pmesh>& fem_meshes) {
  std::vector<Mesh> meshes;
  for (pmesh fem_mesh : fem_meshes) meshes.push_back(mesh_of(fem_mesh));
  return joined_mesh(meshes);
}

/// What is stated for each body.
const NamedArguments::Table of_bodies = {{"label", &typeid(KN_<long>)},
                                         {"previous", &typeid(KN<double>*)}};

/// The labels of one body in the joined mesh's numbering.
std::vector<int> joined_labels(Stack stack, const NamedArguments& named,
                               const std::string& name,
                               const JoinedMesh& joined, int body) {
  std::vector<int> labels = named.integers(stack, name);
  if (joined.body_count() > 1 && labels.empty()) refuse(name, "= is not given");
  const int first = joined.first_boundary[body],
            end = joined.first_boundary[body + 1];
  for (int& label : labels) {
    const int own = std::exchange(label, joined.label(body, label));
    const auto* all = joined.mesh.boundary_label.data();
    if (joined.body_count() > 1 &&
        std::find(all + first, all + end, label) == all + end)
      refuse(name, " is ", own, ", which is on no boundary edge of mesh ",
             body + 1);
  }
  return labels;
}

/// Bodies may overlap a little, as polygons of curves do and interference fits, but not
/// by more than their contact edges.
void require_apart(const Mesh& mesh, const ContactLine& line,
                   const VectorXd& gap) {
  for (int i = 0; i < gap.size(); ++i) {
    const Vector2d x = mesh.place(line.vertex[i]);
    if (gap[i] < -line.length.maxCoeff())
      refuse("the bodies overlap by ", -gap[i], " at (", x.x(), ", ", x.y(),
             "), more than a contact edge: is the facing edge behind the "
             "contact line? "
             "Give gap= if it is meant");
  }
}

void append(const VectorXd& values, VectorXd& all) {
  const Index before = all.size();
  all.conservativeResize(before + values.size());
  all.tail(values.size()) = values;
}

void append(const Matrix2Xd& values, Matrix2Xd& all) {
  const Index before = all.cols();
  all.conservativeResize(Eigen::NoChange, before + values.cols());
  all.rightCols(values.cols()) = values;
}

void require_law(const NamedArguments& named) {
  if (!named.given("friction") && !named.given("slipbound"))
    refuse(
        "no law is given: friction= (Coulomb's coefficient, 0 for none), "
        "slipbound= "
        "(Tresca's bound), or both");
}

/// Which side of pair number `pair` the script wants, 1 or 2, or 0.
int wanted_side(Stack stack, const NamedArguments& named, int pair, int pairs) {
  if (!named.given("side")) return 0;
  const std::vector<int> sides = named.integers(stack, "side");
  if (sides.size() != 1 && static_cast<int>(sides.size()) != pairs)
    refuse("side has ", sides.size(),
           " values: give one, or one for each of the ", pairs,
           " pairs of bodies");
  const int side = sides.size() == 1 ? sides[0] : sides[pair];
  if (side != 1 && side != 2)
    refuse(
        "side must be 1 (the body that comes first carries the multipliers) or "
        "2 (the "
        "other one), got ",
        side);
  return side;
}

}  // namespace

NamedArguments::Table ContactProblem::table(const basicAC_F0& arguments) {
  NamedArguments::Table table = for_bodies(of_bodies, arguments);
  table.insert(table.end(), {{"opposite", &typeid(KN_<long>)},
                             {"friction", &typeid(double)},
                             {"slipbound", &typeid(double)},
                             {"gap", &typeid(double)},
                             {"normal", &typeid(E_Array)},
                             {"side", &typeid(KN_<long>)}});
  return table;
}

Multiplier multiplier_of(Stack stack, const NamedArguments& named) {
  const std::string name = named.text(stack, "multiplier", "force");
  if (name == "pressure") return Multiplier::pressure;
  if (name != "force")
    refuse("multiplier must be \"pressure\" or \"force\", got \"", name, "\"");
  return Multiplier::force;
}

ContactProblem::ContactProblem(Stack stack, const NamedArguments& named,
                               const std::vector<pmesh>& meshes)
    : joined(joined_meshes(meshes)),
      fem_meshes(meshes.begin(), meshes.end()),
      topology_{joined.mesh, edges_of(joined.mesh), {}} {
  const int bodies = body_count();
  require_names_of_bodies(named, of_bodies, bodies);
  require_law(named);
  if (bodies > 1 && named.given("opposite"))
    refuse("opposite= is given, but the contact has ", bodies, " meshes");
  std::vector<std::vector<int>> labels;
  for (int k = 0; k < bodies; ++k) {
    labels.push_back(joined_labels(
        stack, named, name_of_body("label", k, bodies), joined, k));
    if (k > 0 && k + 1 < bodies && labels[k].size() != 2)
      refuse("label", k + 1, " must be two labels: the first faces body ", k,
             ", the second body ", k + 2);
  }
  if (bodies == 1) {
    const std::vector<int> opposite =
        joined_labels(stack, named, "opposite", joined, 0);
    add_pair(stack, named, 0, labels[0], 0, opposite);
  }
  for (int k = 0; k + 1 < bodies; ++k)
    add_pair(
        stack, named, k, k == 0 ? labels[k] : std::vector<int>{labels[k][1]},
        k + 1,
        k + 2 == bodies ? labels[k + 1] : std::vector<int>{labels[k + 1][0]});
  read_previous(stack, named);
  join_carriers();
}

const Topology& ContactProblem::topology() const {
  if (topology_.stars.triangle_start.empty())
    topology_.stars = stars_of(topology_.mesh, topology_.edges);
  return topology_;
}

void ContactProblem::read_previous(Stack stack, const NamedArguments& named) {
  VectorXd previous = VectorXd::Zero(2 * mesh.vertices.cols());
  bool incremental = false;
  for (int k = 0; k < body_count(); ++k) {
    const std::string name = name_of_body("previous", k, body_count());
    const Expression expression = named.expression(name);
    KN<double>* u =
        expression ? GetAny<KN<double>*>((*expression)(stack)) : nullptr;
    if (!u || u->N() == 0) continue;
    require_dofs(name.c_str(), k, u->N());
    previous.segment(first_dof(k), dof_count(k)) = vector_of(u);
    incremental = true;
  }
  if (incremental) previous_ = previous;
}

void ContactProblem::add_pair(Stack stack, const NamedArguments& named,
                              int body, const std::vector<int>& labels,
                              int opposite_body,
                              const std::vector<int>& opposite_labels) {
  const BodyPart part{*fem_meshes[body], joined.first_vertex[body],
                      joined.first_boundary[body]};
  ContactLine own = line_of(stack, named, part, mesh, edges, labels);
  const bool rigid = opposite_labels.empty() && opposite_body == body;
  if (!named.given("normal") && turns(own)) {
    const Expression gap = named.expression("gap");
    const VectorXd distance =
        gap || rigid ? at_nodes(stack, gap, part, edges, own,
                                stated_places(own, false), 0)
                     : facing_traces(mesh, edges, own, opposite_labels).gap;
    own = with_one_direction_a_curve(mesh, edges, std::move(own), distance);
  }
  if (rigid) {
    if (named.given("side"))
      refuse(
          "side= is for bodies that face each other, not for a rigid "
          "foundation");
    pairs_.push_back(
        {true, 1, carrier(stack, named, body, own, own, false), std::nullopt});
    return;
  }
  const int wanted = wanted_side(stack, named, static_cast<int>(pairs_.size()),
                                 std::max(1, body_count() - 1));
  const ContactLine facing = facing_line(
      mesh, edges, own, facing_traces(mesh, edges, own, opposite_labels));
  std::optional<ContactLine> exchanged;
  if (wanted != 1)
    exchanged = exchanged_line(mesh, edges, facing, opposite_labels);
  if (!exchanged && wanted == 2)
    refuse(
        "side=2: the other body cannot carry the multipliers, as two parts of "
        "the first "
        "one's line face the same part "
        "of it; give one contact direction with normal=[nx, ny], or side=1");
  Pair pair{false, wanted, carrier(stack, named, body, own, facing, false),
            std::nullopt};
  if (exchanged)
    pair.other = carrier(stack, named, body, own, *exchanged, true);
  pairs_.push_back(std::move(pair));
}

ContactProblem::Carrier ContactProblem::carrier(
    Stack stack, const NamedArguments& named, int body,
    const ContactLine& stated, ContactLine line, bool on_opposite) const {
  const BodyPart part{*fem_meshes[body], joined.first_vertex[body],
                      joined.first_boundary[body]};
  const StatedPlaces places = stated_places(line, on_opposite);
  std::map<int, int> number;  // contact edge of each mesh edge
  for (int e = 0; e < stated.edge_count(); ++e) number[stated.edge[e]] = e;
  Carrier result;
  result.own_vertex.resize(line.node_count());
  result.abscissa.resize(line.node_count());
  result.edge_abscissa.resize(2, line.edge_count());
  for (int e = line.edge_count() - 1; e >= 0; --e)
    for (int end = 1; end >= 0; --end) {
      const auto [edge, place] =
          end == 0 ? places[e].front() : places[e].back();
      result.edge_abscissa(end, e) =
          abscissa_at(stated, number.at(edge), place);
      if (!ends_at_its_node(line, end, e)) continue;
      const int node = line.edge_node(end, e);
      result.own_vertex[node] =
          edges.vertices(place < 0.5 ? 0 : 1, edge) - part.first_vertex;
      result.abscissa[node] = result.edge_abscissa(end, e);
    }
  result.law = coefficients(stack, named, part, line, places);
  result.line = std::move(line);
  return result;
}

ContactLaw ContactProblem::coefficients(Stack stack,
                                        const NamedArguments& named,
                                        const BodyPart& part,
                                        const ContactLine& line,
                                        const StatedPlaces& places) const {
  ContactLaw law;
  const Expression friction = named.expression("friction"),
                   slip_bound = named.expression("slipbound");
  const auto add = [&](Expression coefficient, VectorXd& nodal,
                       EdgeRange& between_nodes) {
    nodal = at_nodes(stack, coefficient, part, edges, line, places, 0);
    if (coefficient)
      between_nodes =
          enclosing_range(along_edges(stack, coefficient, part, edges, places));
  };
  add(friction, law.friction, law.between_nodes);
  if (slip_bound && friction)
    add(slip_bound, law.shear_limit, law.limit_between_nodes);
  else if (slip_bound)
    add(slip_bound, law.slip_bound, law.between_nodes);
  if (const Expression gap = named.expression("gap")) {
    law.gap = at_nodes(stack, gap, part, edges, line, places, 0);
  } else if (line.against_a_body()) {
    law.gap = facing_gap(line);
    require_apart(mesh, line, law.gap);
  }
  return law;
}

void ContactProblem::choose_sides(const ElasticSystem& system) {
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    if (!pairs_[k].rigid && pairs_[k].wanted == 0 && pairs_[k].other)
      side[k] = compliance_ratio(mesh, edges, pairs_[k].own.line, system) >
                        much_softer
                    ? 2
                    : 1;
  join_carriers();
}

void ContactProblem::join_carriers() {
  if (side.empty())
    for (const Pair& pair : pairs_)
      if (!pair.rigid) side.push_back(std::max(1, pair.wanted));
  std::vector<ContactLine> lines;
  law = {};
  own_vertex.clear();
  abscissa.resize(0);
  edge_abscissa.resize(2, 0);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Carrier& carrier =
        !pairs_[k].rigid && side[k] == 2 ? *pairs_[k].other : pairs_[k].own;
    lines.push_back(carrier.line);
    own_vertex.insert(own_vertex.end(), carrier.own_vertex.begin(),
                      carrier.own_vertex.end());
    append(carrier.abscissa, abscissa);
    append(carrier.edge_abscissa, edge_abscissa);
    append(carrier.law.friction, law.friction);
    append(carrier.law.slip_bound, law.slip_bound);
    append(carrier.law.shear_limit, law.shear_limit);
    append(carrier.law.gap, law.gap);
    for (EdgeRange ContactLaw::*range :
         {&ContactLaw::between_nodes, &ContactLaw::limit_between_nodes}) {
      append((carrier.law.*range).least, (law.*range).least);
      append((carrier.law.*range).most, (law.*range).most);
    }
  }
  line = lines.size() == 1 ? std::move(lines.front()) : joined_lines(lines);
  if (previous_.size() > 0)
    law.previous = contact_components(line, previous_).row(1);
  require_valid(law, line);
}

void ContactProblem::require_dofs(const char* name, int body,
                                  Index count) const {
  if (count != dof_count(body))
    refuse(name, " has size ", count, " but [P1, P1] has ", dof_count(body),
           " dofs on this mesh");
}

void ContactProblem::require_bodies(const char* names,
                                    std::size_t count) const {
  if (static_cast<int>(count) != body_count())
    refuse(names, " are given for ", count, " bodies, but the contact has ",
           body_count());
}

Matrix2Xd ContactProblem::pressures(KN<double>* normal,
                                    KN<double>* tangential) const {
  if (!side.empty() && normal->N() != line.node_count())
    refuse("pn has size ", normal->N(),
           " but the line that carries the multipliers has ", line.node_count(),
           " nodes: state the side= that pn belongs to");
  require_size("pn", normal->N(), line.node_count());
  require_size("pt", tangential->N(), line.node_count());
  Matrix2Xd pressure(2, line.node_count());
  pressure.row(0) = vector_of(normal).transpose();
  pressure.row(1) = vector_of(tangential).transpose();
  return pressure;
}

}  // namespace ffcontact::plugin
