// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/contact_statement.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/line_ends.hpp"
//
#include "freefem/views.hpp"

namespace ffcontact::plugin {

namespace {

/// What is stated for each body.
const NamedArguments::Table stated_of_bodies = {
    {"label", &typeid(KN_<long>)},
    {"previous", &typeid(KN<double>*)},
    {"vertexnumbers", &typeid(KN_<long>)},
    {"cellnumbers", &typeid(KN_<long>)}};

VectorXd stated_gap(Stack stack, const NamedArguments& named,
                    const BodyPart<2>& part, const ContactLine& line,
                    const StatedPlaces& places) {
  if (const Expression given = named.expression("gap"))
    return at_nodes(stack, given, part, line, places, 0);
  if (!line.against_a_body()) return {};
  return facing_gap(line);
}

/// Are some of the pairs bonded, and some not?
struct Bonding {
  bool some = false, not_all = true;
};

Bonding bonding(Stack stack, const NamedArguments& named) {
  const std::vector<int> bonded = named.integers(stack, "bonded");
  const auto count = std::count(bonded.begin(), bonded.end(), 0);
  return {count < count_of(bonded), bonded.empty() || count > 0};
}

/// @throws std::invalid_argument  if something is given that bonded bodies do not have
void require_nothing_else(const NamedArguments& named) {
  for (const char* of_law : {"friction", "kineticfriction", "slipbound"})
    if (named.given(of_law))
      refuse(of_law,
             "= is for bodies that may slide, bonded=true for those that are "
             "glued: give one of both");
  for (const char* of_contact : {"gap", "normal", "corner"})
    if (named.given(of_contact))
      refuse(of_contact,
             "= is not for bonded bodies, which are glued as they are drawn: "
             "leave it out");
  if (named.given_of_bodies("previous"))
    refuse(
        "previous= is not for bonded bodies, which do not slide: leave it out");
}

/// @throws std::invalid_argument  if none of friction=, slipbound= and bonded= is given
void require_law(Stack stack, const NamedArguments& named) {
  const Bonding bonded = bonding(stack, named);
  if (bonded.some && named.given("compliance"))
    refuse(
        "compliance= is not for bonded bodies, which are glued as they are "
        "drawn: leave it out");
  if (!bonded.not_all) return require_nothing_else(named);
  if (!named.given("friction") && !named.given("slipbound"))
    refuse(
        "no law is given: friction= (Coulomb's coefficient, 0 for none), "
        "slipbound= (Tresca's bound), both, or bonded=true");
  if (named.given("kineticfriction") && !named.given("friction"))
    refuse(
        "kineticfriction= is Coulomb's coefficient of what has slipped: give "
        "friction=, that of what sticks, too");
}

}  // namespace

NamedArguments::Table statement_table(const basicAC_F0& arguments) {
  NamedArguments::Table table = for_bodies(stated_of_bodies, arguments);
  table.insert(table.end(), {{"opposite", &typeid(KN_<long>)},
                             {"friction", &typeid(double)},
                             {"kineticfriction", &typeid(double)},
                             {"slipbound", &typeid(double)},
                             {"compliance", &typeid(E_Array)},
                             {"bonded", &typeid(KN_<long>)},
                             {"gap", &typeid(double)},
                             {"normal", &typeid(E_Array)},
                             {"corner", &typeid(double)},
                             {"side", &typeid(KN_<long>)},
                             {"pairs", &typeid(KN_<long>)},
                             {"comm", &typeid(pcommworld)}});
  return table;
}

void require_law_of_bodies(Stack stack, const NamedArguments& named,
                           int bodies) {
  require_names_of_bodies(named, stated_of_bodies, bodies);
  require_law(stack, named);
}

VectorXd stated_previous(Stack stack, const NamedArguments& named,
                         const BodyDofs& bodies) {
  if (!named.given_of_bodies("previous")) return {};
  VectorXd previous = VectorXd::Zero(bodies.dof_count());
  bool any = false;
  for (int k = 0; k < bodies.body_count(); ++k) {
    const std::string name = name_of_body("previous", k, bodies.body_count());
    const Expression expression = named.expression(name);
    if (!expression)
      refuse(name,
             "= is missing: give the displacement of the load step "
             "before of every body, or of none");
    KN<double>* u = value_of<KN<double>*>(stack, expression);
    if (u->N() == 0) continue;
    bodies.require_dofs(name.c_str(), k, u->N());
    previous.segment(bodies.first_dof(k), bodies.dof_count(k)) = vector_of(u);
    any = true;
  }
  return any ? previous : VectorXd();
}

CompliantLayer stated_layer(Stack stack, const NamedArguments& named) {
  if (!named.given("compliance")) return {};
  const auto component = [&](int k) {
    return value_of<double>(stack, named.component("compliance", k, 2));
  };
  const CompliantLayer layer{component(0), component(1)};
  if (layer.tangential > 0 && named.given_of_bodies("previous"))
    refuse(
        "previous= does not say how much of u_t springs back with "
        "compliance=[cn, ct]: take loadstep=true on one mesh, or ct = 0");
  return layer;
}

void require_no_corner(const NamedArguments& named) {
  if (named.given("corner"))
    refuse(
        "corner= is for plane bodies so far: give the surface's normal=[nx, "
        "ny, nz]");
}

double stated_corner(Stack stack, const NamedArguments& named) {
  const double corner =
      named.number(stack, "corner", BoundaryCurves::default_corner);
  if (!(corner >= 0 && corner < 90))
    refuse("corner must be an angle from 0 to below 90 degrees, got ", corner);
  return corner;
}

ContactLine stated_line(Stack stack, const NamedArguments& named,
                        const BodyPart<2>& part, const std::vector<int>& labels,
                        const BoundaryCurves& curves) {
  const Mesh& mesh = part.mesh;
  const Edges& edges = part.facets;
  if (!named.given("normal")) return contact_line(mesh, edges, labels, curves);
  const ContactLine line = smooth_contact_line(mesh, edges, labels);
  Matrix2Xd direction(2, line.node_count());
  for (int c = 0; c < 2; ++c)
    direction.row(c) = at_nodes(stack, named.component("normal", c, 2), part,
                                line, stated_places(line, false), 0)
                           .transpose();
  return along_directions(mesh, edges, line, direction);
}

void put_law(Stack stack, const NamedArguments& named, const BodyPart<2>& part,
             const ContactLine& line, const StatedPlaces& places,
             Carrier<2>& carrier) {
  ContactLaw<2>& law = carrier.law;
  KineticFriction& kinetic = carrier.kinetic;
  const auto read = [&](const char* name, VectorXd& nodal,
                        EdgeRange& between_nodes) {
    const Expression given = named.expression(name);
    nodal = at_nodes(stack, given, part, line, places, 0);
    if (given)
      between_nodes = enclosing_range(along_edges(stack, given, part, places));
  };
  const bool both = named.given("friction") && named.given("slipbound");
  read("friction", law.friction, law.between_nodes);
  if (named.given("kineticfriction"))
    read("kineticfriction", kinetic.friction, kinetic.between_nodes);
  if (both)
    read("slipbound", law.shear_limit, law.limit_between_nodes);
  else if (named.given("slipbound"))
    read("slipbound", law.slip_bound, law.between_nodes);
  law.gap = stated_gap(stack, named, part, line, places);
}

}  // namespace ffcontact::plugin
