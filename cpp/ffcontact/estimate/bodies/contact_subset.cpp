// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/contact_subset.hpp"

#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/selected_rows.hpp"

namespace ffcontact {

namespace {

VectorXd some(const VectorXd& values, const std::vector<int>& places) {
  return values.size() > 0 ? VectorXd(values(places)) : values;
}

template <class Columns>
Columns some_columns(const Columns& values, const std::vector<int>& places) {
  return values.size() > 0 ? Columns(values(Eigen::all, places)) : values;
}

/// The numbers of those that `is` says, and the new number of each, -1 of the others.
struct Chosen {
  std::vector<int> old;
  VectorXi number;

  template <class Is>
  Chosen(int count, const Is& is) : number(VectorXi::Constant(count, -1)) {
    for (int i = 0; i < count; ++i)
      if (is(i)) {
        number[i] = count_of(old);
        old.push_back(i);
      }
  }
};

/// Of the pieces or polygons of facets.
template <class Piece>
std::vector<Piece> some_pieces(const std::vector<Piece>& pieces,
                               int Piece::*facet, const VectorXi& number) {
  std::vector<Piece> some;
  for (Piece piece : pieces) {
    piece.*facet = number[piece.*facet];
    if (piece.*facet >= 0) some.push_back(std::move(piece));
  }
  return some;
}

/// The numbers of nodes, -1 of what is none.
template <class Nodes>
Nodes renumbered(Nodes nodes, const VectorXi& number) {
  for (int& node : nodes.reshaped())
    if (node >= 0) node = number[node];
  return nodes;
}

/// What only a line has, or only a surface.
template <int d>
void put_facets(const LineOrSurface<d>& all, const Chosen& node,
                const Chosen& facet, LineOrSurface<d>& some) {
  if constexpr (d == 2) {
    some.abscissa = all.abscissa(node.old);
    some.edge_node = renumbered<Matrix2Xi>(all.edge_node(Eigen::all, facet.old),
                                           node.number);
    some.edge = all.edge(facet.old);
    some.length = all.length(facet.old);
    some.part = some_columns(all.part, facet.old);
    some.precision = all.precision;
    if (all.opposite_edge.size() > 0)
      some.opposite_edge = all.opposite_edge(facet.old);
    some.pieces =
        some_pieces(all.pieces, &FacingPiece::contact_edge, facet.number);
  } else {
    some.area = all.area(node.old);
    some.face_node = renumbered<Matrix3Xi>(all.face_node(Eigen::all, facet.old),
                                           node.number);
    some.face = all.face(facet.old);
    some.mass =
        selected_rows(selected_rows(all.mass, node.old).transpose(), node.old);
    some.polygons =
        some_pieces(all.polygons, &FacingPolygon::contact_face, facet.number);
  }
}

template <int d>
ContactSubset<d> subset(const LineOrSurface<d>& all, const ContactLaw<d>& law,
                        bool bonded) {
  const Chosen node(all.node_count(),
                    [&](int i) { return law.is_bonded(i) == bonded; }),
      facet(static_cast<int>(facets_of(all).size()),
            [&](int f) { return is_bonded<d>(all, law, f) == bonded; });
  ContactSubset<d> result;
  result.contact.vertex = all.vertex(node.old);
  result.contact.normal = all.normal(Eigen::all, node.old);
  result.contact.opposite = rows_of(all.opposite, node.old);
  put_facets<d>(all, node, facet, result.contact);
  result.law = law_of<d>(law, node.old);
  if constexpr (d == 2)
    for (EdgeRange ContactLaw<d>::*range :
         {&ContactLaw<d>::between_nodes, &ContactLaw<d>::limit_between_nodes})
      result.law.*range = {some_columns((law.*range).least, facet.old),
                           some_columns((law.*range).most, facet.old)};
  result.node = node.old;
  return result;
}

}  // namespace

template <int d>
ContactLaw<d> law_of(const ContactLaw<d>& law, const std::vector<int>& node) {
  ContactLaw<d> result = law;
  for (VectorXd ContactLaw<d>::*values :
       {&ContactLaw<d>::friction, &ContactLaw<d>::slip_bound,
        &ContactLaw<d>::gap, &ContactLaw<d>::shear_limit})
    result.*values = some(law.*values, node);
  result.previous = some_columns(law.previous, node);
  result.carried = some_columns(law.carried, node);
  result.bonded.clear();
  for (const int i : node) result.bonded.push_back(law.is_bonded(i));
  return result;
}

template <int d>
ContactSubset<d> bonded_subset(const LineOrSurface<d>& contact,
                               const ContactLaw<d>& law) {
  return subset<d>(contact, law, true);
}

template <int d>
ContactSubset<d> sliding_subset(const LineOrSurface<d>& contact,
                                const ContactLaw<d>& law) {
  return subset<d>(contact, law, false);
}

template <int d>
Flags held_with_bonded(const LineOrSurface<d>& contact,
                       const ContactLaw<d>& law, Flags prescribed) {
  const auto hold = [&prescribed](int vertex, double) {
    for (int c = 0; c < d; ++c) prescribed[dof_of<d>(vertex, c)] = 1;
  };
  for (int i = 0; i < contact.node_count(); ++i) {
    if (!law.is_bonded(i)) continue;
    hold(contact.vertex[i], 1);
    visit_opposite(contact, i, hold);
  }
  return prescribed;
}

template ContactSubset<FFCONTACT_DIMENSION> bonded_subset<FFCONTACT_DIMENSION>(
    const LineOrSurface<FFCONTACT_DIMENSION>&,
    const ContactLaw<FFCONTACT_DIMENSION>&);
template ContactSubset<FFCONTACT_DIMENSION> sliding_subset<FFCONTACT_DIMENSION>(
    const LineOrSurface<FFCONTACT_DIMENSION>&,
    const ContactLaw<FFCONTACT_DIMENSION>&);
template Flags held_with_bonded<FFCONTACT_DIMENSION>(
    const LineOrSurface<FFCONTACT_DIMENSION>&,
    const ContactLaw<FFCONTACT_DIMENSION>&, Flags);
template ContactLaw<FFCONTACT_DIMENSION> law_of(
    const ContactLaw<FFCONTACT_DIMENSION>&, const std::vector<int>&);

}  // namespace ffcontact
