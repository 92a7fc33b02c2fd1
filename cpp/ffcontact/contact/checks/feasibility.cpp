// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/feasibility.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/held_apart.hpp"
#include "ffcontact/contact/law/gaps_in_reach.hpp"
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Penetrations are compared with the largest normal displacement and gap, and with what
/// the coordinates resolve.
constexpr double penetration_rounding = 1e-10, coordinate_rounding = 1e-14;
/// The largest penetration over the largest displacement that may remove it.
constexpr double held = 1e-3;

/// A point of the contact line, its jump of displacements as a sum over vertices.
struct Station {
  Vector2d point, normal;
  int node;  ///< of the line, the nearest
  double gap;
  std::vector<std::pair<int, double>> weights;
};

Station station_at_node(const Mesh& mesh, const ContactLine& line,
                        const ContactLaw<2>& law, int node) {
  const int vertex = line.vertex[node];
  Station station{mesh.vertices.col(vertex),
                  line.normal.col(node),
                  node,
                  law.gap.size() > 0 ? law.gap[node] : 0,
                  {{vertex, 1.0}}};
  visit_opposite(line, node, [&](int v, double weight) {
    station.weights.emplace_back(v, -weight);
  });
  return station;
}

/// @param x, y  places on the mesh edge of the contact edge and on the opposite one
Station station_on_piece(const Mesh& mesh, const Edges& edges,
                         const ContactLine& line, const ContactLaw<2>& law,
                         const FacingPiece& piece, double x, double y) {
  const int e = piece.contact_edge, a = line.edge_node(0, e),
            b = line.edge_node(1, e);
  const int first = edges.vertices(0, line.edge[e]),
            second = edges.vertices(1, line.edge[e]);
  const double s = line.share(e, x);
  const auto gap = [&](int i) { return law.gap.size() > 0 ? law.gap[i] : 0; };
  return {(1 - x) * mesh.vertices.col(first) + x * mesh.vertices.col(second),
          ((1 - s) * line.normal.col(a) + s * line.normal.col(b)).normalized(),
          s < 0.5 ? a : b,
          (1 - s) * gap(a) + s * gap(b),
          {{first, 1 - x},
           {second, x},
           {edges.vertices(0, piece.opposite_edge), y - 1},
           {edges.vertices(1, piece.opposite_edge), -y}}};
}

/// Where an admissible displacement is asked to be clear: the nodes, or those of the
/// common refinement.
std::vector<Station> stations(const Mesh& mesh, const ContactLine& line,
                              const ContactLaw<2>& law) {
  std::vector<Station> result;
  if (line.matches()) {
    for (int i = 0; i < line.node_count(); ++i)
      result.push_back(station_at_node(mesh, line, law, i));
    return result;
  }
  const Edges edges = edges_of(mesh);
  for (const FacingPiece& piece : line.pieces) {
    result.push_back(station_on_piece(mesh, edges, line, law, piece,
                                      piece.begin, piece.opposite_begin));
    result.push_back(station_on_piece(mesh, edges, line, law, piece, piece.end,
                                      piece.opposite_end));
  }
  return result;
}

/// G w + c <= 0, one row per station.
struct Clearance {
  WeightsByNode G;  ///< [stations x dofs], free dofs only
  VectorXd c;       ///< [mm]
};

/// [u] . n as a sum over dofs.
std::vector<std::pair<int, double>> components_along_n(const Station& station) {
  std::vector<std::pair<int, double>> components;
  for (const auto& [vertex, weight] : station.weights)
    for (int k = 0; k < 2; ++k)
      components.emplace_back(2 * vertex + k, weight * station.normal[k]);
  return components;
}

Clearance clearance_of(const std::vector<Station>& stations,
                       const ElasticSystem& system) {
  const auto rows = count_of(stations);
  Clearance clearance{WeightsByNode(rows, system.dof_count()), VectorXd(rows)};
  std::vector<Eigen::Triplet<double>> entries;
  for (Index row = 0; row < rows; ++row) {
    const Station& station = stations[row];
    clearance.c[row] = -station.gap;
    for (const auto& [dof, component] : components_along_n(station)) {
      if (system.prescribed[dof])
        clearance.c[row] += component * system.prescribed_value[dof];
      else if (std::abs(component) > held)
        entries.emplace_back(row, dof, component);
    }
  }
  clearance.G.setFromTriplets(entries.begin(), entries.end());
  return clearance;
}

/// The largest of its gap and the prescribed values of its vertices [mm].
double largest_given(const Station& station, const ElasticSystem& system) {
  double largest = std::abs(station.gap);
  for (const auto& [vertex, weight] : station.weights) {
    const Vector2d u = system.prescribed_value.segment<2>(2 * vertex);
    largest = std::max(largest, max_norm(u));
  }
  return largest;
}

double largest_given(const std::vector<Station>& stations,
                     const ElasticSystem& system) {
  double largest = 0;
  for (const Station& station : stations)
    largest = std::max(largest, largest_given(station, system));
  return largest;
}

/// Penetration that rounding explains [mm].
double accepted_penetration(const Mesh& mesh,
                            const std::vector<Station>& stations,
                            const ElasticSystem& system) {
  const double extent = box_sides(mesh.vertices).maxCoeff();
  return penetration_rounding * largest_given(stations, system) +
         coordinate_rounding * extent;
}

/// Are there vertices on the line that are prescribed, and against another body some on
/// its side, too?
bool prescribed_on_both_sides(const ContactLine& line,
                              const Flags& prescribed) {
  const auto is_held = [&](int v) {
    return prescribed[2 * v] || prescribed[2 * v + 1];
  };
  const std::vector<int> opposite = opposite_vertices(line);
  return std::any_of(line.vertex.begin(), line.vertex.end(), is_held) &&
         (opposite.empty() ||
          std::any_of(opposite.begin(), opposite.end(), is_held));
}

/// How far to go along `moved` for what it clears, at most the farthest.
double step_to_clear(const VectorXd& inside, const VectorXd& moved) {
  return largest_over(moved.size(), [&](int i) {
    const bool clears = inside[i] > 0 && moved[i] < -held;
    return clears ? -inside[i] / moved[i] : 0;
  });
}

/// Is it enough that every free dof retreats, each as the mean of its rows asks for?
bool clear_by_retreat(const Clearance& clearance) {
  const VectorXd ones = VectorXd::Ones(clearance.c.size());
  const VectorXd sum = clearance.G.transpose() * ones,
                 total = clearance.G.cwiseAbs().transpose() * ones;
  const VectorXd retreat =
      -(total.array() > 0).select(sum.array() / total.array(), 0.0);
  const VectorXd moved = clearance.G * retreat;
  const double step = step_to_clear(clearance.c, moved);
  return (clearance.c + step * moved).maxCoeff() <=
         penetration_rounding * clearance.c.maxCoeff();
}

/// The dofs that lower some of the rows and raise others.
Flags opposed_dofs(const WeightsByNode& G, const std::vector<int>& rows) {
  Flags up(G.cols(), 0), down(G.cols(), 0);
  for (int i : rows)
    for (WeightsByNode::InnerIterator entry(G, i); entry; ++entry)
      (entry.value() > 0 ? up : down)[entry.col()] = 1;
  for (std::size_t dof = 0; dof < up.size(); ++dof) up[dof] &= down[dof];
  return up;
}

bool has_free_dof(const WeightsByNode& G, int row, const Flags& opposed) {
  for (WeightsByNode::InnerIterator entry(G, row); entry; ++entry)
    if (!opposed[entry.col()]) return true;
  return false;
}

/// The rows that no dof can lower without raising another of them. A dof that lowers all
/// its rows frees them.
std::vector<int> bound_rows(const WeightsByNode& G) {
  std::vector<int> bound(G.rows());
  std::iota(bound.begin(), bound.end(), 0);
  for (std::size_t before = bound.size() + 1; bound.size() < before;) {
    before = bound.size();
    const Flags opposed = opposed_dofs(G, bound);
    const auto is_free = [&](int i) { return has_free_dof(G, i, opposed); };
    bound.erase(std::remove_if(bound.begin(), bound.end(), is_free),
                bound.end());
  }
  return bound;
}

/// The dofs of some rows, in the order in which they first occur.
std::map<Index, Index> places_of_dofs(const WeightsByNode& G,
                                      const std::vector<int>& selected) {
  std::map<Index, Index> place;
  for (int i : selected)
    for (WeightsByNode::InnerIterator entry(G, i); entry; ++entry)
      place.emplace(entry.col(), count_of(place));
  return place;
}

/// Some rows of G as columns, dofs without an entry left out [dofs x selected].
MatrixXd transposed_rows(const WeightsByNode& G,
                         const std::vector<int>& selected) {
  const std::map<Index, Index> place = places_of_dofs(G, selected);
  MatrixXd rows = MatrixXd::Zero(count_of(place), count_of(selected));
  for (std::size_t k = 0; k < selected.size(); ++k)
    for (WeightsByNode::InnerIterator entry(G, selected[k]); entry; ++entry)
      rows(entry_of(place, entry.col(), "place of a dof"),
           static_cast<Index>(k)) = entry.value();
  return rows;
}

/// y . c, row by row, for the weights y of the header with sum y . c = max |c|; zeros
/// where w exists.
VectorXd shares_in_contradiction(const Clearance& clearance,
                                 const std::vector<int>& selected) {
  const MatrixXd G = transposed_rows(clearance.G, selected);
  const Index dofs = G.rows(), count = G.cols();
  Eigen::RowVectorXd c(count);
  for (Index k = 0; k < count; ++k) c[k] = clearance.c[selected[k]];
  MatrixXd rows(dofs + 1, count);
  rows << G, c / max_norm(clearance.c);
  const VectorXd wanted = VectorXd::Unit(dofs + 1, dofs);
  const VectorXd y = nonnegative_least_squares(rows, wanted);
  if ((rows * y - wanted).norm() > held) return VectorXd::Zero(count);
  return y.cwiseProduct(c.transpose());
}

[[noreturn]] void refuse_held(const ContactLine& line, const Station& station,
                              double inside) {
  const bool bodies = line.against_a_body();
  refuse("prescribed displacements hold ", bodies ? "contact node " : "vertex ",
         bodies ? station.node : line.vertex[station.node], " at ",
         in_words(station.point), " ", inside, " inside ",
         bodies ? "the opposite body" : "the foundation",
         ": change them or gap= there, or free a dof that moves it along n");
}

/// What prescribed dofs alone make of [u] along each axis, 0 where a free dof takes part.
Vector2d prescribed_jump(const Station& station, const ElasticSystem& system) {
  Vector2d jump = Vector2d::Zero();
  Vector2d held = Vector2d::Ones();
  for (const auto& [vertex, weight] : station.weights) {
    if (weight == 0) continue;
    for (int k = 0; k < 2; ++k) {
      jump[k] += weight * system.prescribed_value[2 * vertex + k];
      held[k] *= system.prescribed[2 * vertex + k];
    }
  }
  return jump.cwiseProduct(held);
}

/// Takes the stations out that are bonded.
std::vector<Station> taken_bonded(const ContactLaw<2>& law,
                                  std::vector<Station>& all) {
  const auto slides = [&](const Station& station) {
    return !law.is_bonded(station.node);
  };
  const auto bonded = std::stable_partition(all.begin(), all.end(), slides);
  std::vector<Station> taken(bonded, all.end());
  all.erase(bonded, all.end());
  return taken;
}

void require_bonded(const Mesh& mesh, const std::vector<Station>& bonded,
                    const ElasticSystem& system) {
  const double rounding = penetration_rounding * largest_given(bonded, system);
  for (const Station& station : bonded) {
    const double apart = prescribed_jump(station, system).norm();
    if (apart > rounding)
      refuse_held_apart(apart, in_words(Vector2d(mesh.origin + station.point)));
  }
}

}  // namespace

void require_feasible(const Mesh& mesh, const ContactLine& line,
                      const ContactLaw<2>& law, const ElasticSystem& system) {
  const bool on_both_sides = prescribed_on_both_sides(line, system.prescribed);
  if (!on_both_sides && !law.has_bonded()) return;
  std::vector<Station> all = stations(
      mesh, line, with_gaps_in_reach(law, mesh, system.prescribed_value));
  require_bonded(mesh, taken_bonded(law, all), system);
  if (all.empty() || !on_both_sides) return;
  Clearance clearance = clearance_of(all, system);
  const VectorXd inside = clearance.c;
  clearance.c.array() -= accepted_penetration(mesh, all, system);
  if (clearance.c.maxCoeff() <= 0 || clear_by_retreat(clearance)) return;
  const std::vector<int> bound = bound_rows(clearance.G);
  if (bound.empty()) return;
  const VectorXd shares = shares_in_contradiction(clearance, bound);
  Index worst;
  if (shares.maxCoeff(&worst) <= 0) return;
  refuse_held(line, all[bound[worst]], inside[bound[worst]]);
}

}  // namespace ffcontact
