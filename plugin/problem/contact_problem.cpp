// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/appended.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/contact/checks/compliance_ratio.hpp"
#include "ffcontact/interface/bonded_line.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/joined_lines.hpp"
#include "ffcontact/interface/pairing/constant_ends.hpp"
#include "ffcontact/interface/pairing/facing_line.hpp"
//
#include <algorithm>
#include <string>
#include <utility>

#include "freefem/freefem.hpp"
#include "freefem/views.hpp"
#include "problem/contact_problem.hpp"
#include "problem/curve_report.hpp"

namespace ffcontact::plugin {

namespace {

/// Says at any verbosity where a line that faces bodies has a vertex in which more than two
/// boundary edges meet, as where FreeFEM's + took two vertices for one: nothing opens there.
void warn_of_touching(const Mesh& mesh, const ContactLine& own) {
  if (mpirank != 0) return;
  VectorXi edges_at = VectorXi::Zero(mesh.vertex_count());
  for (int v : mesh.boundary.reshaped()) ++edges_at[v];
  for (int v : own.vertex)
    if (edges_at[v] > 2) {
      cout
          << "contact: at vertex " << v << " " << in_words(mesh.place(v))
          << " the body touches itself in a single vertex of the contact "
             "line, which neither opens nor slides: where bodies are joined by "
             "FreeFEM's T1 + T2, state contact(T1, T2, ...)"
          << endl;
      return;
    }
}

void append_range(const EdgeRange& more, EdgeRange& range) {
  append(more.least, range.least);
  append(more.most, range.most);
}

}  // namespace

Multiplier multiplier_of(Stack stack, const NamedArguments& named) {
  return named.choice(
      stack, "multiplier", Multiplier::force,
      {{"pressure", Multiplier::pressure}, {"force", Multiplier::force}});
}

ContactProblem::ContactProblem(Stack stack, const NamedArguments& named,
                               const std::vector<pmesh>& meshes)
    : Bodies<2>(meshes) {
  previous_ = stated_previous(stack, named, *this);
  state(stack, named);
}

ContactProblem::ContactProblem(Stack stack, const NamedArguments& named,
                               JoinedMesh whole,
                               const PlacesElsewhere<2>& elsewhere,
                               VectorXd previous)
    : Bodies<2>(std::move(whole)),
      elsewhere_(&elsewhere),
      previous_(std::move(previous)) {
  state(stack, named);
  elsewhere_ = nullptr;
}

void ContactProblem::state(Stack stack, const NamedArguments& named) {
  corner_ = stated_corner(stack, named);
  if (!is_bonded(stack, named)) curves_ = BoundaryCurves(mesh, facets, corner_);
  layer_ = stated_layer(stack, named);
  const std::vector<StatedPair> stated = stated_pairs(stack, named, joined);
  for (const StatedPair& pair : stated) body_of_pair.push_back(pair.body);
  for (const StatedPair& pair : stated) add_pair(stack, named, pair);
  join_carriers();
}

const Topology<2>& ContactProblem::topology() const {
  if (!topology_) topology_ = topology_of(mesh, facets);
  return *topology_;
}

/// A curve has one contact direction where it touches what is flatter.
ContactLine ContactProblem::own_line(Stack stack, const NamedArguments& named,
                                     const StatedPair& pair) const {
  const BodyPart<2> body = part(pair.body, elsewhere_);
  ContactLine line = stated_line(stack, named, body, pair.labels, curves_);
  if (named.given("normal") || is_bonded(stack, named) || !turns(line))
    return line;
  const Expression gap = named.expression("gap");
  const VectorXd distance =
      gap || pair.rigid()
          ? at_nodes(stack, gap, body, line, stated_places(line, false), 0)
          : facing_traces(mesh, facets, line, pair.opposite, curves_).gap;
  return with_one_direction_a_curve(mesh, std::move(line), distance);
}

void ContactProblem::require_one_side(const StatedPair& pair,
                                      const ContactLine& own) const {
  if (!must_not_face_itself(pair)) return;
  const std::optional<TouchingPlace> touching =
      touching_place(mesh, facets, own, pair.labels);
  if (touching)
    refuse_both_sides(
        mesh.boundary_label[facets.boundary_index[touching->edge]],
        in_words(Vector2d(mesh.origin + touching->place)));
}

void ContactProblem::add_pair(Stack stack, const NamedArguments& named,
                              const StatedPair& pair) {
  const ContactLine own = own_line(stack, named, pair);
  require_one_side(pair, own);
  if (!is_bonded(stack, named))
    report_curves(joined, facets, curves_, corner_, pair, own,
                  {named.given("normal"), named.given("gap")});
  if (!pair.rigid()) {
    if (body_count() == 1) warn_of_touching(mesh, own);
    add_facing_pair(stack, named, pair, own);
    return;
  }
  pairs_.push_back({true, 1, carrier(stack, named, pair.body, own, own, false),
                    std::nullopt});
}

void ContactProblem::add_facing_pair(Stack stack, const NamedArguments& named,
                                     const StatedPair& stated,
                                     const ContactLine& own) {
  const int wanted =
      wanted_side(stack, named, count_of(pairs_), count_of(body_of_pair));
  const FacingTraces traces =
      facing_traces(mesh, facets, own, stated.opposite, curves_);
  const bool bonded = is_bonded(stack, named);
  ContactLine facing = facing_line(mesh, facets, own, traces);
  std::optional<ContactLine> exchanged;
  if (wanted != 1)
    exchanged = exchanged_line(mesh, facets, facing, stated.opposite);
  if (!exchanged && wanted == 2)
    refuse(
        "side=2: the other body cannot carry the multipliers, as two parts of "
        "the first one's line face the same part of it; give one contact "
        "direction with normal=[nx, ny], or side=1");
  if (bonded) facing = with_constant_ends(mesh, facets, facing);
  if (bonded && exchanged)
    exchanged = with_constant_ends(mesh, facets, *exchanged);
  Pair pair{false, wanted,
            carrier(stack, named, stated.body, own, facing, false),
            std::nullopt};
  if (exchanged)
    pair.other = carrier(stack, named, stated.body, own, *exchanged, true);
  pairs_.push_back(std::move(pair));
}

ContactProblem::Carrier ContactProblem::carrier(
    Stack stack, const NamedArguments& named, int body,
    const ContactLine& stated, ContactLine line, bool on_opposite) const {
  const StatedPlaces places = stated_places(line, on_opposite);
  StatedAbscissae at = stated_abscissae(facets, stated, line, places);
  Carrier result;
  for (int vertex : at.vertex)
    result.own_vertex.push_back(vertex - joined.first_vertex[body]);
  result.abscissa = std::move(at.node);
  result.edge_abscissa = std::move(at.edge_end);
  result.stated =
      stated_law(stack, named, part(body, elsewhere_), line, places);
  result.line = std::move(line);
  return result;
}

void ContactProblem::choose_sides(const ElasticSystem& system) {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_[k].rigid || pairs_[k].wanted != 0 || !pairs_[k].other) continue;
    const double ratio =
        compliance_ratio(mesh, facets, pairs_[k].own.line, system);
    side[k] = ratio > much_softer ? 2 : 1;
  }
  join_carriers();
}

void ContactProblem::clear_line() {
  law = {};
  kinetic = {};
  first_node = {0};
  own_vertex.clear();
  abscissa.resize(0);
  edge_abscissa.resize(2, 0);
  own_normal.resize(2, 0);
}

/// But for the line itself, whose n points out of the body that carries the multipliers.
void ContactProblem::append_carrier(const Carrier& carrier, bool on_opposite) {
  own_vertex.insert(own_vertex.end(), carrier.own_vertex.begin(),
                    carrier.own_vertex.end());
  first_node.push_back(count_of(own_vertex));
  append(carrier.abscissa, abscissa);
  append(carrier.edge_abscissa, edge_abscissa);
  const Matrix2Xd& normal = carrier.line.normal;
  append(on_opposite ? Matrix2Xd(-normal) : normal, own_normal);
  const auto& [law_there, kinetic_there] = carrier.stated;
  law.bonded = law_there.bonded;
  for (VectorXd ContactLaw::*nodal :
       {&ContactLaw::friction, &ContactLaw::slip_bound,
        &ContactLaw::shear_limit, &ContactLaw::gap})
    append(law_there.*nodal, law.*nodal);
  append(kinetic_there.friction, kinetic.friction);
  append_range(law_there.between_nodes, law.between_nodes);
  append_range(law_there.limit_between_nodes, law.limit_between_nodes);
  append_range(kinetic_there.between_nodes, kinetic.between_nodes);
}

void ContactProblem::join_carriers() {
  if (side.empty())
    for (const Pair& pair : pairs_)
      if (!pair.rigid) side.push_back(std::max(1, pair.wanted));
  clear_line();
  std::vector<ContactLine> lines;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const bool on_other = !pairs_[k].rigid && side[k] == 2;
    const Carrier& carrier = on_other ? *pairs_[k].other : pairs_[k].own;
    lines.push_back(carrier.line);
    append_carrier(carrier, on_other);
  }
  line = lines.size() == 1 ? std::move(lines.front()) : joined_lines(lines);
  if (previous_.size() > 0)
    law.previous = contact_components(line, previous_).row(1);
  law.layer = layer_;
  require_valid(law, line);
  if (kinetic.given()) require_kinetic(kinetic.friction, law.friction);
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
