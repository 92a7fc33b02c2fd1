// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/contact_subset.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/interface/joined_contact.hpp"
#include "support/bonded.hpp"
#include "support/bonded_solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Material steel = material(70e3, 0.3);

/// Numbers that differ, of the nodes of a law.
template <int d>
ContactLaw<d> numbered_law(int nodes, double first, bool bonded) {
  ContactLaw<d> law;
  law.friction = VectorXd::LinSpaced(nodes, first, first + nodes - 1);
  law.gap = 10 * law.friction;
  law.shear_limit = 100 * law.friction;
  law.previous = (-law.friction.transpose()).replicate(d - 1, 1);
  law.bonded.assign(nodes, bonded);
  return law;
}

template <int d>
ContactLaw<d> joined(const ContactLaw<d>& first, const ContactLaw<d>& second) {
  ContactLaw<d> all = first;
  for (VectorXd ContactLaw<d>::*values :
       {&ContactLaw<d>::friction, &ContactLaw<d>::gap,
        &ContactLaw<d>::shear_limit})
    append(second.*values, all.*values);
  append(second.previous, all.previous);
  all.bonded.insert(all.bonded.end(), second.bonded.begin(),
                    second.bonded.end());
  return all;
}

template <int d>
void expect_same_law(const ContactLaw<d>& part, const ContactLaw<d>& whole) {
  EXPECT_EQ(part.friction, whole.friction);
  EXPECT_EQ(part.gap, whole.gap);
  EXPECT_EQ(part.shear_limit, whole.shear_limit);
  EXPECT_EQ(part.previous, whole.previous);
  EXPECT_EQ(part.bonded, whole.bonded);
}

MatrixXd dense(const WeightsByNode& weights) { return MatrixXd(weights); }

/// The two lines of three blocks, none of which match.
struct TwoLines {
  Bodies bodies = bonded_bodies(
      {shifted(rectangle(7, 2, 6, 2), {0, 5}),
       shifted(rectangle(5, 3, 6, 3), {0, 2}), rectangle(9, 2, 8, 2)},
      {steel, steel, steel}, {{0, bottom, 1, top}, {1, bottom, 2, top}});
  ContactLine first, second;

  TwoLines() {
    const Problem& problem = bodies.problem;
    const auto line = [&](int body, int own, int other) {
      const ContactLine whole =
          contact_line(problem.mesh, problem.edges, {bodies.label(body, own)});
      return facing_line(problem.mesh, problem.edges, whole,
                         facing_traces(problem.mesh, problem.edges, whole,
                                       {bodies.label(body + 1, other)}));
    };
    first = line(0, bottom, top);
    second = line(1, bottom, top);
  }
};

void expect_same(const ContactLine& part, const ContactLine& whole) {
  EXPECT_EQ(part.vertex, whole.vertex);
  EXPECT_EQ(part.normal, whole.normal);
  EXPECT_EQ(part.abscissa, whole.abscissa);
  EXPECT_EQ(part.edge_node, whole.edge_node);
  EXPECT_EQ(part.edge, whole.edge);
  EXPECT_EQ(part.length, whole.length);
  EXPECT_EQ(part.opposite_edge, whole.opposite_edge);
  EXPECT_EQ(dense(part.opposite), dense(whole.opposite));
  ASSERT_EQ(part.pieces.size(), whole.pieces.size());
  for (std::size_t k = 0; k < part.pieces.size(); ++k) {
    EXPECT_EQ(part.pieces[k].contact_edge, whole.pieces[k].contact_edge);
    EXPECT_EQ(part.pieces[k].begin, whole.pieces[k].begin);
  }
}

TEST(ContactSubset, of_joined_lines_are_these_lines) {
  const TwoLines two;
  const int n = two.first.node_count();
  const ContactLine all = joined_contact<2>({two.first, two.second});
  for (const bool bonded_first : {true, false}) {
    const ContactLaw<2> first = numbered_law<2>(n, 1, bonded_first),
                        second = numbered_law<2>(two.second.node_count(), 50,
                                                 !bonded_first);
    const ContactLaw<2> law = joined(first, second);
    const auto bonded = bonded_subset<2>(all, law),
               sliding = sliding_subset<2>(all, law);
    expect_same(bonded.contact, bonded_first ? two.first : two.second);
    expect_same(sliding.contact, bonded_first ? two.second : two.first);
    expect_same_law(bonded.law, bonded_first ? first : second);
    expect_same_law(sliding.law, bonded_first ? second : first);
    EXPECT_EQ(bonded.node.front(), bonded_first ? 0 : n);
    EXPECT_EQ(sliding.node.front(), bonded_first ? n : 0);
  }
}

TEST(ContactSubset, is_all_where_nothing_is_bonded) {
  const TwoLines two;
  const ContactLaw<2> law = numbered_law<2>(two.first.node_count(), 1, false);
  const auto sliding = sliding_subset<2>(two.first, law);
  expect_same(sliding.contact, two.first);
  EXPECT_EQ(bonded_subset<2>(two.first, law).contact.node_count(), 0);
}

TEST(ContactSubset, of_joined_surfaces_are_these_surfaces) {
  const SolidStack one = bonded_bricks({3, 2, 1}, {2, 3, 1}),
                   other = bonded_bricks({2, 2, 1}, {3, 3, 1});
  const ContactSurface &first = one.problem.surface,
                       &second = other.problem.surface;
  const ContactSurface all = joined_contact<3>({first, second});
  const ContactLaw<3> law =
      joined(numbered_law<3>(first.node_count(), 1, true),
             numbered_law<3>(second.node_count(), 50, false));
  for (const bool bonded : {true, false}) {
    const auto part =
        bonded ? bonded_subset<3>(all, law) : sliding_subset<3>(all, law);
    const ContactSurface& whole = bonded ? first : second;
    EXPECT_EQ(part.contact.vertex, whole.vertex);
    EXPECT_EQ(part.contact.normal, whole.normal);
    EXPECT_EQ(part.contact.area, whole.area);
    EXPECT_EQ(part.contact.face, whole.face);
    EXPECT_EQ(part.contact.face_node, whole.face_node);
    EXPECT_LT((MatrixXd(part.contact.mass) - MatrixXd(whole.mass)).norm(),
              1e-15);
    EXPECT_EQ(part.contact.polygons.size(), whole.polygons.size());
    const Index columns = dense(whole.opposite).cols();
    EXPECT_EQ(dense(part.contact.opposite).leftCols(columns),
              dense(whole.opposite));
  }
}

TEST(ContactSubset, holds_the_vertices_of_both_sides_of_what_is_bonded) {
  const TwoLines two;
  const ContactLaw<2> law = numbered_law<2>(two.first.node_count(), 1, true);
  const Index dofs = 2 * two.bodies.problem.mesh.vertex_count();
  const Flags held = held_with_bonded<2>(two.first, law, Flags(dofs, 0));
  for (const int v : contact_vertices(two.first)) {
    EXPECT_EQ(held[2 * v], 1);
    EXPECT_EQ(held[2 * v + 1], 1);
  }
  EXPECT_EQ(std::count(held.begin(), held.end(), 1), 2 * (8 + 6));
  const ContactLaw<2> sliding =
      numbered_law<2>(two.first.node_count(), 1, false);
  EXPECT_EQ(held_with_bonded<2>(two.first, sliding, Flags(dofs, 0)),
            Flags(dofs, 0));
}

}  // namespace
}  // namespace ffcontact
