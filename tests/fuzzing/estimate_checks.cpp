// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

#include "ffcontact/base/eigen.hpp"
#include "ground.hpp"

namespace ffcontact::fuzz {

namespace {

constexpr double displacement_tolerance = 1e-9, stress_tolerance = 1e-10,
                 cone_tolerance = 1e-12, error_tolerance = 1e-8;

Vector2d traction_of(const Vector3d& s, const Vector2d& n) {
  return {s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y()};
}

/// Outward normal of the side from a to b of a counter-clockwise triangle.
Vector2d outward(const Vector2d& a, const Vector2d& b) {
  return Vector2d(b.y() - a.y(), a.x() - b.x()).normalized();
}

/// Each triangle of the refinement is a part of its parent, and the parts fill it.
void check_refinement(const Assembled& parts, const Ground& ground, bool exact,
                      Finds& finds) {
  VectorXd area = VectorXd::Zero(parts.mesh().cells.cols());
  double outside = 0;
  for (int t = 0; t < ground.mesh.cell_count(); ++t) {
    const Corners own = corners_at(ground.mesh, t),
                  parent = corners_at(parts.mesh(), ground.parent[t]);
    area[ground.parent[t]] += area_of(own) / area_of(parent);
    for (int k = 0; k < 3; ++k)
      outside = std::max(outside, -weights_at(parent, own.col(k)).minCoeff());
  }
  const ContactLine& line = ground.line;
  Largest apart;
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    const auto opposite = [&](int node) {
      return Vector2d(ground.mesh.vertices.col(
          WeightsByNode::InnerIterator(line.opposite, node).col()));
    };
    const Vector2d own = ground.mesh.vertices.col(line.vertex[j]) -
                         ground.mesh.vertices.col(line.vertex[i]);
    apart.note(std::abs((opposite(j) - opposite(i)).norm() / own.norm() - 1),
               e);
  }
  if (!(apart.value <= (exact ? 1e-6 : 1e-3)))
    finds.push_back(finding("refinement", "facing edges at contact edge ",
                            apart.place, " differ by ", apart.value));
  if (!((area.array() - 1).abs().maxCoeff() <= 1e-8) || !(outside <= 1e-8))
    finds.push_back(
        finding("refinement", "triangles are not the parts of their parents"));
}

void check_displacement(const Assembled& parts, const Ground& ground,
                        const Estimate<2>& estimate, Finds& finds) {
  const VectorXd& u = estimate.displacement;
  const Matrix2Xd w = against_foundation(ground.line, ground.gap, {}, u);
  const double scale = displacement_scale(parts, u);
  Largest penetration, support;
  for (int i = 0; i < w.cols(); ++i) penetration.note(w(0, i), i);
  for (int dof = 0; dof < parts.value.size(); ++dof)
    if (parts.prescribed[dof])
      support.note(std::abs(u[dof] - parts.value[dof]), dof);
  if (!(penetration.value <= displacement_tolerance * scale))
    finds.push_back(finding("displacement", how_far(penetration.value / scale),
                            "penetrates at node ", penetration.place, " by ",
                            penetration.value / scale));
  if (!(support.value <= 1e-12 * scale))
    finds.push_back(finding("displacement", how_far(support.value / scale),
                            "leaves the support of dof ", support.place, " by ",
                            support.value / scale));
}

/// Stress at corner c (k+1, k+2, centroid) of subtriangle k.
Vector3d at_corner(const SubcellStress<2>& stress, int k, int c) {
  return stress.col(3 * k + c);
}

double divergence_defect(const Corners& corners, const SubcellStress<2>& stress,
                         const Vector2d& force) {
  double defect = 0;
  for (int k = 0; k < 3; ++k) {
    const Corners sub = subtriangle(corners, k);
    Vector2d divergence = force;
    for (int c = 0; c < 3; ++c) {
      const Vector2d side = sub.col((c + 2) % 3) - sub.col((c + 1) % 3);
      const Vector2d gradient =
          Vector2d(-side.y(), side.x()) / (2 * area_of(sub));
      divergence += traction_of(at_corner(stress, k, c), gradient);
    }
    defect = std::max(defect,
                      divergence.norm() * area_of(corners) /
                          std::max({(corners.col(0) - corners.col(1)).norm(),
                                    (corners.col(1) - corners.col(2)).norm(),
                                    (corners.col(2) - corners.col(0)).norm()}));
  }
  return defect;
}

/// Across the side from vertex j to the centroid, between the subtriangles j + 1 and j +
/// 2.
double inner_jump(const Corners& corners, const SubcellStress<2>& stress) {
  double jump = 0;
  for (int j = 0; j < 3; ++j) {
    const Vector2d n = outward(corners.col(j), corners.rowwise().mean());
    const int a = (j + 1) % 3, b = (j + 2) % 3;
    jump = std::max(
        jump, traction_of(at_corner(stress, a, 1) - at_corner(stress, b, 0), n)
                  .norm());
    jump = std::max(
        jump, traction_of(at_corner(stress, a, 2) - at_corner(stress, b, 2), n)
                  .norm());
  }
  return jump;
}

/// Tractions at the two ends of a boundary edge, from vertex to vertex counter-clockwise;
/// components may be open.
struct Given {
  Matrix2d value;  ///< one column an end
  bool known[2];
};

using GivenTractions = std::map<std::pair<int, int>, Given>;

/// Label and component pairs that are prescribed at all vertices of the label.
std::map<int, std::array<bool, 2>> held_labels(
    const Mesh& mesh, const std::vector<char>& prescribed) {
  std::map<int, std::array<bool, 2>> held;
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    for (int v : mesh.boundary.col(e))
      for (int c = 0; c < 2; ++c) {
        auto place = held.try_emplace(mesh.boundary_label[e],
                                      std::array<bool, 2>{true, true})
                         .first;
        place->second[c] = place->second[c] && prescribed[2 * v + c];
      }
  return held;
}

/// Given tractions by the case's data and contact tractions on both sides. Where facing
/// edges of the refinement are not of the same length (vertices that all but meet) their
/// forces are opposite, not their tractions: check_refinement says by how much.
GivenTractions given_tractions(const Case& problem, const Assembled& parts,
                               const Ground& ground,
                               const Estimate<2>& estimate) {
  GivenTractions given;
  const auto held = held_labels(ground.mesh, ground.prescribed);
  for (int e = 0; e < ground.mesh.boundary.cols(); ++e) {
    const int label = ground.mesh.boundary_label[e];
    Given here{Matrix2d::Zero(), {!held.at(label)[0], !held.at(label)[1]}};
    for (std::size_t k = 0; k < problem.bodies.size(); ++k)
      for (const Traction& traction : problem.bodies[k].tractions)
        if (label == parts.joined.label(static_cast<int>(k), traction.label))
          here.value.colwise() += traction.value;
    given[{ground.mesh.boundary(0, e), ground.mesh.boundary(1, e)}] = here;
    given[{ground.mesh.boundary(1, e), ground.mesh.boundary(0, e)}] = here;
  }
  const auto add = [&](int a, int b, const Matrix2d& value) {
    Given& here = given.at({a, b});
    here = {here.value + value, {true, true}};
  };
  const ContactLine& line = ground.line;
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e),
              a = line.vertex[i], b = line.vertex[j];
    const Vector2d n = line.normal.col(i), t(-n.y(), n.x());
    Matrix2d r;
    for (int end = 0; end < 2; ++end)
      r.col(end) = estimate.tractions.normal(end, e) * n +
                   estimate.tractions.tangential(end, e) * t;
    add(a, b, r);
    if (line.opposite.rows() == 0) continue;
    // where two bodies meet a node has a vertex of each
    for (WeightsByNode::InnerIterator x(line.opposite, j); x; ++x)
      for (WeightsByNode::InnerIterator y(line.opposite, i); y; ++y) {
        const std::pair<int, int> facing(x.col(), y.col());
        if (given.count(facing) == 0) continue;
        const double ratio =
            (ground.mesh.vertices.col(a) - ground.mesh.vertices.col(b)).norm() /
            (ground.mesh.vertices.col(facing.first) -
             ground.mesh.vertices.col(facing.second))
                .norm();
        add(facing.first, facing.second, -ratio * r.rowwise().reverse());
      }
  }
  return given;
}

struct StressDefects {
  Largest divergence, jump, traction;
};

/// Both ends of the side k of triangle t, from its counter-clockwise first vertex.
Matrix2d side_tractions(const Ground& ground, const Estimate<2>& estimate,
                        int t, int k) {
  const Corners corners = corners_at(ground.mesh, t);
  const Vector2d n =
      outward(corners.col((k + 1) % 3), corners.col((k + 2) % 3));
  Matrix2d result;
  for (int end = 0; end < 2; ++end)
    result.col(end) = traction_of(at_corner(estimate.stress[t], k, end), n);
  return result;
}

StressDefects stress_defects(const Case& problem, const Assembled& parts,
                             const Ground& ground,
                             const Estimate<2>& estimate) {
  StressDefects defects;
  std::map<std::pair<int, int>, Matrix2d> sides;
  for (int t = 0; t < ground.mesh.cell_count(); ++t) {
    const Corners corners = corners_at(ground.mesh, t);
    defects.divergence.note(
        divergence_defect(corners, estimate.stress[t],
                          parts.body_force.col(ground.parent[t])),
        t);
    defects.jump.note(inner_jump(corners, estimate.stress[t]), t);
    for (int k = 0; k < 3; ++k)
      sides[{ground.mesh.cells((k + 1) % 3, t),
             ground.mesh.cells((k + 2) % 3, t)}] =
          side_tractions(ground, estimate, t, k);
  }
  const GivenTractions given =
      given_tractions(problem, parts, ground, estimate);
  for (const auto& [ends, tractions] : sides) {
    const auto other = sides.find({ends.second, ends.first});
    if (other != sides.end()) {
      defects.jump.note(
          (tractions + other->second.rowwise().reverse()).cwiseAbs().maxCoeff(),
          ends.first);
      continue;
    }
    const Given& wanted = given.at(ends);
    for (int c = 0; c < 2; ++c)
      if (wanted.known[c])
        defects.traction.note(
            (tractions - wanted.value).row(c).cwiseAbs().maxCoeff(),
            ends.first);
  }
  return defects;
}

void check_stress(const Case& problem, const Assembled& parts,
                  const Ground& ground, const Estimate<2>& estimate,
                  double scale, Finds& finds) {
  const StressDefects defects =
      stress_defects(problem, parts, ground, estimate);
  // known to its own last place, however far from that of u
  for (const SubcellStress<2>& stress : estimate.stress)
    scale = std::max(scale, stress.cwiseAbs().maxCoeff());
  const auto judge = [&](const char* check, const Largest& defect) {
    if (!(defect.value <= stress_tolerance * scale))
      finds.push_back(finding(check, how_far(defect.value / scale), "at ",
                              defect.place, " by ", defect.value / scale,
                              " of the largest stress"));
  };
  judge("divergence", defects.divergence);
  judge("jump", defects.jump);
  judge("traction", defects.traction);
}

/// What stands in the integrals along one contact edge, at s in [0, 1].
struct AlongEdge {
  double rn[2], rt[2], wn[2], wt[2], mu[2], k[2];
  bool tresca;
  static double at(const double* ends, double s) {
    return (1 - s) * ends[0] + s * ends[1];
  }
  double bound(double s) const {
    return tresca ? at(k, s) : at(mu, s) * std::abs(at(rn, s));
  }
  double integrand(double s) const {
    return bound(s) * std::abs(at(wt, s)) + at(rt, s) * at(wt, s) +
           at(rn, s) * at(wn, s);
  }
  double force(double s) const {
    return bound(s) + std::abs(at(rt, s)) + std::abs(at(rn, s));
  }
  double size(double s) const {
    return bound(s) * std::abs(at(wt, s)) + std::abs(at(rt, s) * at(wt, s)) +
           std::abs(at(rn, s) * at(wn, s));
  }
};

AlongEdge along_edge(const Case& problem, const Ground& ground,
                     const Estimate<2>& estimate, const Matrix2Xd& w, int e) {
  AlongEdge edge{};
  edge.tresca = problem.law == Law::tresca;
  for (int end = 0; end < 2; ++end) {
    const int node = ground.line.edge_node(end, e);
    edge.rn[end] = estimate.tractions.normal(end, e);
    edge.rt[end] = estimate.tractions.tangential(end, e);
    edge.wn[end] = w(0, node);
    edge.wt[end] = w(1, node);
    edge.mu[end] = ground.friction[node];
    edge.k[end] = edge.tresca ? ground.slip_bound[node] : 0;
  }
  return edge;
}

/// Simpson's rule between the places where the integrand has kinks: exact for cubics.
template <class Function>
double integral(const AlongEdge& edge, Function&& f) {
  std::set<double> places{0, 1};
  for (const double* ends : {edge.rn, edge.wt})
    if (ends[0] * ends[1] < 0) places.insert(ends[0] / (ends[0] - ends[1]));
  double sum = 0, before = 0;
  for (double place : places) {
    sum += (place - before) / 6 *
           (f(before) + 4 * f((before + place) / 2) + f(place));
    before = place;
  }
  return sum;
}

void check_cone(const Case& problem, const Ground& ground,
                const Estimate<2>& estimate, double scale, Finds& finds) {
  const Matrix2Xd w = Matrix2Xd::Zero(2, ground.line.node_count());
  Largest outside;
  for (int e = 0; e < ground.line.edge_count(); ++e) {
    const AlongEdge edge = along_edge(problem, ground, estimate, w, e);
    for (int step = 0; step <= 20; ++step) {
      const double s = step / 20.0;
      outside.note(AlongEdge::at(edge.rn, s), e);
      outside.note(std::abs(AlongEdge::at(edge.rt, s)) - edge.bound(s), e);
    }
  }
  if (!(outside.value <= cone_tolerance * scale))
    finds.push_back(finding("cone", how_far(outside.value / scale),
                            "left on contact edge ", outside.place, " by ",
                            outside.value / scale));
}

/// int a : C^-1 a over a triangle of a stress that is linear on its subtriangles: the
/// middles of sides are exact.
double energy_of(const Corners& corners, const Matrix3d& compliance,
                 const SubcellStress<2>& stress) {
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) {
      const Vector3d middle =
          0.5 * (at_corner(stress, k, c) + at_corner(stress, k, (c + 1) % 3));
      sum += area_of(subtriangle(corners, k)) / 3 *
             middle.dot(compliance * middle);
    }
  return sum;
}

struct OwnError {
  double elastic = 0, contact = 0, sum = 0, contact_size = 0;  ///< squares
  /// int of the largest entry of C^-1: a stress squared times this is a square, too
  double compliance = 0;
  /// 2 int (bound + |r_t| + |r_n|): a displacement times this is a square, too
  double force = 0;
};

OwnError own_error(const Case& problem, const Assembled& parts,
                   const Ground& ground, const Estimate<2>& estimate) {
  OwnError own;
  for (int t = 0; t < ground.mesh.cell_count(); ++t) {
    const Matrix3d& C = parts.elasticity[ground.region[t]];
    const SubcellStress<2> of_u =
        stress_of(ground.mesh, t, C, estimate.displacement).replicate<1, 9>();
    const Corners corners = corners_at(ground.mesh, t);
    own.compliance += area_of(corners) * C.inverse().cwiseAbs().maxCoeff();
    own.elastic += energy_of(corners, C.inverse(), estimate.stress[t] - of_u);
    own.sum += energy_of(corners, C.inverse(), estimate.stress[t] + of_u);
  }
  const Matrix2Xd w = against_foundation(
      ground.line, ground.gap, ground.previous, estimate.displacement);
  for (int e = 0; e < ground.line.edge_count(); ++e) {
    const AlongEdge edge = along_edge(problem, ground, estimate, w, e);
    const double length =
        (ground.mesh.vertices.col(
             ground.line.vertex[ground.line.edge_node(0, e)]) -
         ground.mesh.vertices.col(
             ground.line.vertex[ground.line.edge_node(1, e)]))
            .norm();
    own.contact += 2 * length *
                   integral(edge, [&](double s) { return edge.integrand(s); });
    own.contact_size +=
        2 * length * integral(edge, [&](double s) { return edge.size(s); });
    own.force +=
        2 * length * integral(edge, [&](double s) { return edge.force(s); });
  }
  return own;
}

/// Squares that differ by rounding of what they are made of are the same: of stresses, (a
/// + d)^2 = a^2 + 2 a d + d^2 with d = 1e-12 `stress` (stress_scale), of the terms
/// of the sums, and of displacements, which are known to the last place of the largest
/// one. Where e is exactly 0 stresses and slips are called so that are below 1e-12 of
/// what they are summed from.
void check_error(const Case& problem, const Assembled& parts,
                 const Ground& ground, const Estimate<2>& estimate,
                 double stress, Finds& finds) {
  const OwnError own = own_error(problem, parts, ground, estimate);
  const double displacement = (estimate.e == 0 ? 1e-12 : 1e-15) *
                              displacement_scale(parts, estimate.displacement);
  const auto rounding_of_square = [&](double square) {
    const double d = std::sqrt(own.compliance) * 1e-12 * stress;
    return d * d + 2 * std::sqrt(square) * d;
  };
  const double rounding =
      1e-12 * (own.sum + own.contact_size) + rounding_of_square(own.elastic) +
      own.force * displacement + square_called_zero(parts, ground, estimate);
  const auto compare = [&](const char* what, double theirs, double ours,
                           double more = 0) {
    if (!(std::abs(theirs - ours) <=
          error_tolerance * std::abs(ours) + rounding + more))
      finds.push_back(
          finding("error", what, " is ", theirs, ", by our integrals ", ours));
  };
  compare("elastic part", estimate.elastic * estimate.elastic, own.elastic);
  compare("contact part", estimate.contact, own.contact);
  compare("e^2", estimate.e * estimate.e,
          std::max(0.0, own.elastic + own.contact));
  const double relative_square = estimate.relative * estimate.relative;
  if (own.sum > 0)  // all of it is rounding where a body slides without stress
    compare("eps^2 times the sum", relative_square * own.sum,
            std::max(0.0, own.elastic + own.contact),
            relative_square * rounding_of_square(own.sum));
  if (!(std::abs(estimate.local.squaredNorm() - relative_square) <=
        error_tolerance * relative_square + 1e-12 +
            (own.sum > 0 ? rounding / own.sum : 0)))
    finds.push_back(finding("error", "the sum of eps_E^2 is ",
                            estimate.local.squaredNorm(), ", eps^2 ",
                            relative_square));
}

/// Contact tractions push the tool as it is pushed.
void check_push(const Assembled& parts, const Estimate<2>& estimate,
                Finds& finds) {
  if (!parts.tool) return;
  const ContactLine& line = parts.line;
  Matrix2Xd x(2, 2 * line.edge_count()), f(2, 2 * line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    Matrix2d r;
    for (int end = 0; end < 2; ++end) {
      const Vector2d n = line.normal.col(line.edge_node(end, e));
      r.col(end) =
          estimate.tractions.normal(end, e) * n +
          estimate.tractions.tangential(end, e) * Vector2d(-n.y(), n.x());
    }
    for (int end = 0; end < 2; ++end) {
      x.col(2 * e + end) =
          parts.mesh().vertices.col(line.vertex[line.edge_node(end, e)]);
      f.col(2 * e + end) =
          line.length[e] / 6 * (2 * r.col(end) + r.col(1 - end));
    }
  }
  const double missed = missed_push(*parts.tool, x, f, line.length.sum());
  if (!(missed <= 1e-9))
    finds.push_back(
        finding("tool", how_far(missed), "r_hat misses its push by ", missed));
}

}  // namespace

Finds estimate_finds(const Case& problem, const Assembled& parts,
                     const Estimate<2>& estimate) {
  Finds finds;
  const Ground ground = ground_of(parts, estimate);
  if (estimate.refinement)
    check_refinement(parts, ground, estimate.refinement->exact, finds);
  check_displacement(parts, ground, estimate, finds);
  check_push(parts, estimate, finds);
  const double scale = stress_scale(parts, ground, estimate.displacement);
  const double contact =
      std::max(estimate.tractions.normal.cwiseAbs().maxCoeff(),
               estimate.tractions.tangential.cwiseAbs().maxCoeff());
  check_stress(problem, parts, ground, estimate, scale, finds);
  check_cone(problem, ground, estimate, std::max(scale, contact), finds);
  check_error(problem, parts, ground, estimate, scale, finds);
  if (!estimate.admissible)
    finds.push_back(finding(
        "admissible",
        how_far(std::max(estimate.equilibrium.largest(), estimate.cone)),
        estimate.reason));
  return finds;
}

}  // namespace ffcontact::fuzz
