// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/stated_pairs.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "problem/contact_statement.hpp"

namespace ffcontact::plugin {

namespace {

/// @param label  in the joined mesh
template <int dim>
bool has_label(const JoinedBodies<dim>& joined, int body, int label) {
  const int first = joined.first_boundary[body],
            count = joined.first_boundary[body + 1] - first;
  const auto labels = joined.mesh.boundary_label.segment(first, count);
  return (labels.array() == label).any();
}

/// The labels of one body in the joined mesh's numbering.
template <int dim>
std::vector<int> joined_labels(Stack stack, const NamedArguments& named,
                               const std::string& name,
                               const JoinedBodies<dim>& joined, int body) {
  std::vector<int> labels = named.integers(stack, name);
  if (joined.body_count() > 1 && labels.empty()) refuse(name, "= is not given");
  for (int& label : labels) {
    const int own = std::exchange(label, joined.label(body, label));
    if (joined.body_count() > 1 && !has_label(joined, body, label))
      refuse(name, " is ", own, ", which is on no boundary ",
             MeshWords<dim>::facet, " of mesh ", body + 1);
  }
  return labels;
}

/// Numbers of two bodies.
struct BodyPair {
  int first, second;
};

/// What a parameter says of a pair: its only value, or that of the pair.
int value_of_pair(Stack stack, const NamedArguments& named, const char* name,
                  int pair, int pairs) {
  const std::vector<int> values = named.integers(stack, name);
  if (values.size() != 1 && count_of(values) != pairs)
    refuse(name, " has ", values.size(),
           " values: give one, or one for each of the ", pairs,
           " pairs of bodies");
  return values.size() == 1 ? values[0] : values[pair];
}

/// By bonded=.
bool is_bonded(Stack stack, const NamedArguments& named, int pair, int pairs) {
  return named.given("bonded") &&
         value_of_pair(stack, named, "bonded", pair, pairs) != 0;
}

/// By pairs=, or each body and the one after it.
std::vector<BodyPair> pairs_of_bodies(Stack stack, const NamedArguments& named,
                                      int bodies) {
  std::vector<BodyPair> pairs;
  if (!named.given("pairs"))
    for (int k = 0; k + 1 < bodies; ++k) pairs.push_back({k, k + 1});
  for (const std::vector<int>& pair : named.lists_of_integers(stack, "pairs")) {
    const auto is_body = [&](int k) { return k >= 1 && k <= bodies; };
    if (pair.size() != 2 || pair[0] == pair[1] || !is_body(pair[0]) ||
        !is_body(pair[1]))
      refuse("pairs must be pairs of different meshes, numbers from 1 to ",
             bodies, ", as [[1, 2], [1, 3]]");
    pairs.push_back({pair[0] - 1, pair[1] - 1});
  }
  return pairs;
}

/// Those of one body towards each of those that it faces.
std::vector<std::vector<int>> parted_labels(const std::vector<int>& labels,
                                            int body, int partners,
                                            bool is_chain) {
  if (partners == 0)
    refuse("mesh ", body + 1,
           " is in none of pairs=: take it out of the contact, or add a pair");
  if (partners == 1) return {labels};
  if (is_chain && labels.size() != 2)
    refuse("label", body + 1, " must be two labels: the first faces body ",
           body, ", the second body ", body + 2);
  if (labels.size() == 1)
    return std::vector<std::vector<int>>(partners, labels);
  if (count_of(labels) != partners)
    refuse("label", body + 1, " must be ", partners,
           " labels, one for each of the pairs that mesh ", body + 1,
           " is in, in their order, or one for all of them");
  std::vector<std::vector<int>> parted;
  for (int label : labels) parted.push_back({label});
  return parted;
}

/// Those that share the line of the first body are one.
void add_merged(StatedPair pair, std::vector<StatedPair>& pairs) {
  for (StatedPair& known : pairs)
    if (known.labels == pair.labels && known.bonded == pair.bonded) {
      known.opposite.insert(known.opposite.end(), pair.opposite.begin(),
                            pair.opposite.end());
      return;
    }
  pairs.push_back(std::move(pair));
}

/// Of several bodies.
template <int dim>
std::vector<StatedPair> paired_labels(Stack stack, const NamedArguments& named,
                                      const JoinedBodies<dim>& joined) {
  const int bodies = joined.body_count();
  const std::vector<BodyPair> of_bodies = pairs_of_bodies(stack, named, bodies);
  std::vector<std::vector<std::vector<int>>> labels;
  for (int k = 0; k < bodies; ++k) {
    const auto has_body = [&](const BodyPair& pair) {
      return pair.first == k || pair.second == k;
    };
    const auto partners =
        std::count_if(of_bodies.begin(), of_bodies.end(), has_body);
    labels.push_back(parted_labels(
        joined_labels(stack, named, name_of_body("label", k, bodies), joined,
                      k),
        k, static_cast<int>(partners), !named.given("pairs")));
  }
  std::vector<std::size_t> next(bodies, 0);
  std::vector<StatedPair> pairs;
  for (int k = 0; k < count_of(of_bodies); ++k) {
    const auto& [first, second] = of_bodies[k];
    add_merged(
        {first, labels[first][next[first]++], labels[second][next[second]++],
         is_bonded(stack, named, k, count_of(of_bodies))},
        pairs);
  }
  return pairs;
}

/// Of a single body.
template <int dim>
StatedPair stated_pair(Stack stack, const NamedArguments& named,
                       const JoinedBodies<dim>& joined) {
  StatedPair pair{0, joined_labels(stack, named, "label", joined, 0),
                  joined_labels(stack, named, "opposite", joined, 0),
                  is_bonded(stack, named, 0, 1)};
  if (pair.rigid() && named.given("side"))
    refuse(
        "side= is for bodies that face each other, not for a rigid foundation");
  return pair;
}

}  // namespace

template <int dim>
std::vector<StatedPair> stated_pairs(Stack stack, const NamedArguments& named,
                                     const JoinedBodies<dim>& joined) {
  const int bodies = joined.body_count();
  require_law_of_bodies(stack, named, bodies);
  if (bodies > 1 && named.given("opposite"))
    refuse("opposite= is given, but the contact has ", bodies, " meshes");
  if (bodies == 1 && named.given("pairs"))
    refuse("pairs= is for several meshes, which the contact has not");
  if (bodies == 1) return {stated_pair(stack, named, joined)};
  return paired_labels(stack, named, joined);
}

template std::vector<StatedPair> stated_pairs(Stack, const NamedArguments&,
                                              const JoinedMesh&);
template std::vector<StatedPair> stated_pairs(Stack, const NamedArguments&,
                                              const JoinedSolids&);

template <int dim>
int body_of_label(const JoinedBodies<dim>& joined, int label) {
  int body = 0;
  while (!has_label(joined, body, label)) ++body;
  return body;
}

template int body_of_label(const JoinedMesh&, int);
template int body_of_label(const JoinedSolids&, int);

bool must_not_face_itself(const StatedPair& pair) {
  const auto is_label = [&](int opposite) {
    return std::find(pair.labels.begin(), pair.labels.end(), opposite) !=
           pair.labels.end();
  };
  return pair.rigid() ||
         std::any_of(pair.opposite.begin(), pair.opposite.end(), is_label);
}

void refuse_both_sides(int label, const std::string& place) {
  refuse("label ", label, " is on two sides that lie on each other, as at ",
         place,
         ": give them two labels, label= for one and opposite= for the other");
}

int wanted_side(Stack stack, const NamedArguments& named, int pair, int pairs) {
  if (!named.given("side")) return 0;
  const int side = value_of_pair(stack, named, "side", pair, pairs);
  if (side != 1 && side != 2)
    refuse(
        "side must be 1 (the body that comes first carries the multipliers) or "
        "2 (the other one), got ",
        side);
  return side;
}

}  // namespace ffcontact::plugin
