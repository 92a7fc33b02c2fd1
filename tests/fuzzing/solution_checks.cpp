// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ground.hpp"

namespace ffcontact::fuzz {

namespace {

constexpr double of_the_whole = 1e-10, of_the_row = 1e-9, law_tolerance = 1e-9,
                 geometry_tolerance = 1e-9, unsteered = 1e-6;

/// Of which Case::contacts each boundary edge is, and which it is opposite to, by its
/// vertices in counter-clockwise order.
struct Labelled {
  int contact = -1;
  std::set<int> opposite_of;
};
std::map<std::pair<int, int>, Labelled> labelled_edges(const Case& problem,
                                                       const Assembled& parts) {
  std::map<EdgeKey, int> column;
  const Mesh& mesh = parts.mesh();
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    column[key(mesh.boundary(0, e), mesh.boundary(1, e))] = e;
  std::map<std::pair<int, int>, Labelled> result;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.cells(k, t), b = mesh.cells((k + 1) % 3, t);
      const auto found = column.find(key(a, b));
      if (found == column.end()) continue;
      const int label = mesh.boundary_label[found->second];
      for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const Contact& contact = problem.contacts[c];
        for (int own : contact.labels)
          if (label == parts.joined.label(contact.body, own))
            result[{a, b}].contact = static_cast<int>(c);
        for (const auto& [body, other] : contact.opposites)
          if (label == parts.joined.label(body, other))
            result[{a, b}].opposite_of.insert(static_cast<int>(c));
      }
    }
  return result;
}

struct Segment {
  Vector2d a, b;
  Vector2d along() const { return (b - a).normalized(); }
  Vector2d outward() const { return {along().y(), -along().x()}; }
  double length() const { return (b - a).norm(); }
};

Segment segment(const Mesh& mesh, const std::pair<int, int>& ends) {
  return {mesh.vertices.col(ends.first), mesh.vertices.col(ends.second)};
}

/// The part of a contact edge that faces an opposite edge along n, by places on the
/// former; `from` to `to` is all of the latter.
struct FacingPart {
  std::pair<int, int> ends;  ///< of the opposite edge
  double from, to, distance;
};

/// Those that are nearest: a line that turns back has others behind.
std::vector<FacingPart> facing_parts(
    const Mesh& mesh, const std::map<std::pair<int, int>, Labelled>& labelled,
    const std::pair<int, int>& edge) {
  const Segment own = segment(mesh, edge);
  std::vector<FacingPart> parts;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [ends, what] : labelled) {
    if (what.opposite_of.count(labelled.at(edge).contact) == 0) continue;
    const Segment other = segment(mesh, ends);
    if (own.outward().dot(other.outward()) > -0.99) continue;
    const auto place = [&](const Vector2d& y) {
      return (y - own.a).dot(own.along()) / own.length();
    };
    // the other edge runs backwards
    const double from = place(other.b), to = place(other.a);
    if (std::min(1.0, to) <= std::max(0.0, from)) continue;
    const double distance =
        std::abs((0.5 * (other.a + other.b) - own.a).dot(own.outward()));
    parts.push_back({ends, from, to, distance});
    nearest = std::min(nearest, distance);
  }
  const auto behind = [&](const FacingPart& part) {
    return part.distance > nearest + 1e-3 * own.length();
  };
  parts.erase(std::remove_if(parts.begin(), parts.end(), behind), parts.end());
  return parts;
}

/// int psi_i phi_j over the parts of the line that face edges of the opposite label along
/// n.
Dense coupling(const Case& problem, const Assembled& parts) {
  const ContactLine& line = parts.line;
  const auto labelled = labelled_edges(problem, parts);
  Dense D = Dense::Zero(line.node_count(), parts.mesh().vertices.cols());
  const double gauss = 0.5 / std::sqrt(3.0);
  for (int e = 0; e < line.edge_count(); ++e) {
    const std::pair<int, int> ends(line.vertex[line.edge_node(0, e)],
                                   line.vertex[line.edge_node(1, e)]);
    const double length = segment(parts.mesh(), ends).length();
    for (const auto& [other, from, to, distance] :
         facing_parts(parts.mesh(), labelled, ends)) {
      const double begin = std::max(0.0, from), end = std::min(1.0, to);
      for (double x : {0.5 - gauss, 0.5 + gauss}) {
        const double s = begin + x * (end - begin),
                     r = (s - from) / (to - from);
        const double weight = 0.5 * (end - begin) * length;
        for (int i = 0; i < 2; ++i) {
          const double psi = weight * (i == 0 ? 1 - s : s);
          D(line.edge_node(i, e), other.second) += psi * (1 - r);
          D(line.edge_node(i, e), other.first) += psi * r;
        }
      }
    }
  }
  return D;
}

double largest_coordinate(const Case& problem) {
  double largest = 0;
  for (const Body& body : problem.bodies)
    largest = std::max(largest, body.mesh.vertices.cwiseAbs().maxCoeff());
  return largest;
}

/// Has an edge a vertex that its line shares with what it faces? Nothing opens there.
bool is_at_an_end(const std::map<std::pair<int, int>, Labelled>& labelled,
                  const std::pair<int, int>& edge) {
  const int contact = labelled.at(edge).contact;
  const auto shares = [&](int v) {
    return std::any_of(labelled.begin(), labelled.end(), [&](const auto& e) {
      return e.second.opposite_of.count(contact) > 0 &&
             (e.first.first == v || e.first.second == v);
    });
  };
  return shares(edge.first) || shares(edge.second);
}

void check_edges(const Case& problem, const Assembled& parts, Finds& finds) {
  const auto labelled = labelled_edges(problem, parts);
  auto expected = labelled;
  // A straight line may be so to within the precision of its coordinates, and has one
  // normal.
  const double straight =
      std::max(1e-9 * problem.size, 4e-16 * largest_coordinate(problem));
  const ContactLine& line = parts.line;
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    const auto found = expected.find({line.vertex[i], line.vertex[j]});
    if (found == expected.end() || found->second.contact < 0) {
      finds.push_back(
          finding("line", "contact edge ", e,
                  " is no edge of the contact labels, or is there twice"));
      return;
    }
    const Segment edge = segment(parts.mesh(), found->first);
    if (std::abs(line.length[e] - edge.length()) >
        geometry_tolerance * edge.length())
      finds.push_back(finding("line", "length of edge ", e));
    for (int node : {i, j})
      if ((line.normal.col(node) - edge.outward()).norm() >
          1e-6 + 4 * straight / edge.length())
        finds.push_back(finding("line", "normal of node ", node,
                                " is not that of its edge"));
    expected.erase(found);
  }
  for (const auto& [ends, what] : expected)
    if (what.contact >= 0 && !is_at_an_end(labelled, ends))
      finds.push_back(finding("line", "the edge from ", ends.first, " to ",
                              ends.second, " is missing"));
}

/// Two edges in a row share their node where they are straight to well above rounding,
/// and only there.
void check_corners(const Case& problem, const Assembled& parts, Finds& finds) {
  const ContactLine& line = parts.line;
  const double far = largest_coordinate(problem);
  for (int e = 0; e < line.edge_count(); ++e)
    for (int f = 0; f < line.edge_count(); ++f) {
      const int end = line.edge_node(1, e), start = line.edge_node(0, f);
      if (line.vertex[end] != line.vertex[start]) continue;
      const Segment first = segment(
          parts.mesh(), {line.vertex[line.edge_node(0, e)], line.vertex[end]});
      const Segment second =
          segment(parts.mesh(),
                  {line.vertex[start], line.vertex[line.edge_node(1, f)]});
      const double sine = std::abs(first.along().dot(second.outward()));
      const double rounding =
          4e-16 * far / std::min(first.length(), second.length());
      if (end != start && sine < 2 * rounding + 1e-12)
        finds.push_back(finding("line", "two nodes at vertex ",
                                line.vertex[end],
                                " where the line is straight to ", sine));
      if (end == start && sine > 1e-3)
        finds.push_back(finding("line", "one node at vertex ", line.vertex[end],
                                " where the line turns by ", sine));
    }
}

void check_coupling(const Case& problem, const Assembled& parts, Finds& finds) {
  if (!problem.has_opposites()) return;
  const Dense M = mass_of(parts.mesh(), parts.line),
              difference =
                  M * Dense(parts.line.opposite) - coupling(problem, parts);
  const double defect =
      difference.cwiseAbs().maxCoeff() / M.cwiseAbs().maxCoeff();
  if (!(defect <= 1e-8))
    finds.push_back(finding("coupling", "int psi phi is off by ", defect));
}

/// Free dofs in a component of the jump at a node: of the vertices that weigh 1e-3 or
/// more, and of those that weigh less, as where prescribed vertices all but meet.
struct FreeParts {
  double faced = 0, beside = 0;
};
FreeParts free_parts(const Assembled& parts, int node,
                     const Vector2d& direction) {
  FreeParts part;
  const auto visit = [&](int vertex, double weight) {
    for (int c = 0; c < 2; ++c)
      if (!parts.prescribed[2 * vertex + c])
        (std::abs(weight) < 1e-3 ? part.beside : part.faced) +=
            std::abs(weight * direction[c]);
  };
  visit(parts.line.vertex[node], 1);
  if (parts.line.opposite.rows() > 0)
    for (WeightsByNode::InnerIterator w(parts.line.opposite, node); w; ++w)
      visit(w.col(), w.value());
  return part;
}

/// A force that acted through vertices of little weight alone would be larger than all
/// others by as much: it loads none.
bool is_held(const FreeParts& part) { return part.faced < unsteered; }

VectorXd contact_load(const Assembled& parts, const Matrix2Xd& force) {
  VectorXd load = VectorXd::Zero(parts.load.size());
  for (int i = 0; i < parts.line.node_count(); ++i) {
    const Vector2d n = parts.line.normal.col(i),
                   direction[2] = {n, {-n.y(), n.x()}};
    Vector2d F(0, 0);
    for (int c = 0; c < 2; ++c)
      if (!is_held(free_parts(parts, i, direction[c])))
        F += force(c, i) * direction[c];
    load.segment<2>(2 * parts.line.vertex[i]) += F;
    if (parts.line.opposite.rows() > 0)
      for (WeightsByNode::InnerIterator part(parts.line.opposite, i); part;
           ++part)
        load.segment<2>(2 * part.col()) -= part.value() * F;
  }
  return load;
}

void check_balance(const Assembled& parts, const ContactSolution<2>& solution,
                   Finds& finds) {
  const VectorXd contact = contact_load(parts, solution.force),
                 &u = solution.displacement;
  const VectorXd residual = parts.stiffness * u - parts.load - contact;
  const VectorXd largest =
      VectorXd::Constant(u.size(), displacement_scale(parts, u));
  const VectorXd size = parts.stiffness.cwiseAbs() * largest +
                        parts.load.cwiseAbs() + contact.cwiseAbs();
  const double scale = size.size() > 0 ? size.maxCoeff() : 0;
  // The factorisation is backward stable for the whole, not row by row: |K u - b| is a
  // last place, 2^-52 = 2.2e-16, of its largest force also at a vertex without any.
  const double last_place = 2.2e-16 * scale;
  Largest whole, row;
  for (int dof = 0; dof < residual.size(); ++dof) {
    if (parts.prescribed[dof]) continue;
    const double of_vertex =
        std::max({size[dof], size[dof ^ 1], last_place / of_the_row});
    whole.note(std::abs(residual[dof]), dof);
    row.note(of_vertex > 0 ? std::abs(residual[dof]) / of_vertex
                           : std::abs(residual[dof]),
             dof);
  }
  if (!(whole.value <= of_the_whole * scale))
    finds.push_back(finding("balance", "dof ", whole.place, " by ",
                            whole.value / scale, " of the largest force"));
  if (!(row.value <= of_the_row))
    finds.push_back(finding("balance", "dof ", row.place, " by ", row.value,
                            " of the forces there"));
}

void check_supports(const Assembled& parts, const ContactSolution<2>& solution,
                    Finds& finds) {
  for (int dof = 0; dof < parts.value.size(); ++dof)
    if (parts.prescribed[dof] &&
        !(std::abs(solution.displacement[dof] - parts.value[dof]) <=
          1e-12 * parts.value.cwiseAbs().maxCoeff()))
      finds.push_back(finding("support", "dof ", dof, " is ",
                              solution.displacement[dof], ", not ",
                              parts.value[dof]));
}

/// The jump at the nodes, in held components that of the prescribed values, or 0 when the
/// vertices of little weight could make it so.
Matrix2Xd steered_jumps(const Assembled& parts, const VectorXd& u) {
  const auto against = [&](const VectorXd& field) {
    return against_foundation(parts.line, parts.law.gap, parts.law.previous,
                              field);
  };
  Matrix2Xd w = against(u);
  const Matrix2Xd given = against(parts.value);
  const double scale = std::max({max_norm(parts.value), max_norm(parts.law.gap),
                                 max_norm(parts.law.previous)});
  for (int i = 0; i < parts.line.node_count(); ++i) {
    const Vector2d n = parts.line.normal.col(i),
                   direction[2] = {n, {-n.y(), n.x()}};
    for (int c = 0; c < 2; ++c) {
      const FreeParts part = free_parts(parts, i, direction[c]);
      if (!is_held(part)) continue;
      const double none = (unsteered + 2 * part.beside) * scale;
      w(c, i) = std::abs(given(c, i)) <= none ? 0 : given(c, i);
    }
  }
  return w;
}

/// Nodes at which complementarity is not asked: some prescribed value stands in W u.
struct Held {
  bool some, all;
};
Held held(const Assembled& parts, const Dense& W, int node) {
  Held result{false, true};
  for (int j = 0; j < W.cols(); ++j)
    for (int c = 0; c < 2 && W(node, j) != 0; ++c) {
      const bool fixed = parts.prescribed[2 * parts.line.vertex[j] + c];
      result.some = result.some || (fixed && j == node);
      result.all = result.all && fixed;
    }
  return result;
}

void check_law(const Case& problem, const Assembled& parts,
               const ContactSolution<2>& solution, Finds& finds) {
  const ContactLine& line = parts.line;
  const int p = line.node_count();
  const bool pressures = problem.multiplier == Multiplier::pressure;
  const Dense M = mass_of(parts.mesh(), line),
              W = pressures ? M : Dense::Identity(p, p);
  const double u_scale = displacement_scale(parts, solution.displacement);
  const Matrix2Xd w = steered_jumps(parts, solution.displacement);
  const Matrix2Xd v = w * W.transpose(),
                  &P = pressures ? solution.pressure : solution.force;
  const double v_scale = u_scale * W.rowwise().sum().maxCoeff();
  VectorXd bound =
      parts.law.friction.cwiseProduct((-P.row(0)).cwiseMax(0.0).transpose());
  if (problem.law == Law::tresca)
    bound =
        pressures ? parts.law.slip_bound : VectorXd(M * parts.law.slip_bound);
  const double P_scale =
      std::max(P.cwiseAbs().maxCoeff(),
               problem.law == Law::tresca ? bound.maxCoeff() : 0.0);
  const double P_zero = law_tolerance * P_scale,
               v_zero = law_tolerance * v_scale;
  const auto complain = [&](int node, const char* what, double by,
                            double scale) {
    finds.push_back(
        finding("law", what, " at node ", node, " by ", by / scale));
  };
  for (int i = 0; i < p; ++i) {
    if (!(P(0, i) <= P_zero)) complain(i, "tension", P(0, i), P_scale);
    if (!(v(0, i) <= v_zero)) complain(i, "penetration", v(0, i), v_scale);
    if (!(std::abs(P(1, i)) <= bound[i] + P_zero))
      complain(i, "friction beyond the bound", std::abs(P(1, i)) - bound[i],
               P_scale);
    const Held fixed = held(parts, W, i);
    if (pressures ? fixed.all : fixed.some) continue;
    if (P(0, i) < -P_zero && v(0, i) < -v_zero)
      complain(i, "a force across the gap", v(0, i), v_scale);
    if (std::abs(P(1, i)) < bound[i] - P_zero && std::abs(v(1, i)) > v_zero)
      complain(i, "slip below the bound", v(1, i), v_scale);
    if (std::abs(P(1, i)) > P_zero && std::abs(v(1, i)) > v_zero &&
        P(1, i) * v(1, i) > 0)
      complain(i, "friction along the slip", P(1, i), P_scale);
  }
  const double defect =
      pressures ? (solution.force - solution.pressure * M).cwiseAbs().maxCoeff()
                : 0;
  if (!(defect <= 1e-9 * solution.force.cwiseAbs().maxCoeff()))
    finds.push_back(finding("law", "forces are not M times pressures"));
}

/// A vertex that may move along d alone, at an angle to the line so small that friction
/// along the line outweighs the normal force along d, |n . d| <= mu |t . d|: no force of
/// the cone need hold it, and the problem no solution have.
bool locks_itself(const Assembled& parts, int node) {
  const int x = 2 * parts.line.vertex[node];
  if (parts.prescribed[x] == parts.prescribed[x + 1]) return false;
  const int free = parts.prescribed[x] ? 1 : 0;
  const double across = std::abs(parts.line.normal(free, node)),
               along = std::abs(parts.line.normal(1 - free, node));
  return across > 1e-9 && across <= parts.law.friction[node] * along;
}

/// Two nodes of one vertex that face each other so nearly that friction wedges it between
/// them: forces of any size balance each other, and none need fulfil the law.
bool jams(const Assembled& parts, int i, int j) {
  if (parts.line.vertex[i] != parts.line.vertex[j]) return false;
  const double opposed =
      -parts.line.normal.col(i).dot(parts.line.normal.col(j));
  const VectorXd& mu = parts.law.friction;
  return opposed >= std::cos(std::atan(mu[i]) + std::atan(mu[j]));
}

/// Do supports hold a node along its line? Friction there cannot be told from what these
/// do: it pushes no tool, and a tool's slip is none there.
bool is_held_along(const Assembled& parts, int node) {
  const Vector2d n = parts.line.normal.col(node);
  return is_held(free_parts(parts, node, {-n.y(), n.x()}));
}

/// The push of pressures is of all of them, that of forces of those that load the body.
void check_tool(const Case& problem, const Assembled& parts,
                const ContactSolution<2>& solution, Finds& finds) {
  if (!parts.tool) return;
  const ContactLine& line = parts.line;
  const bool of_all = problem.multiplier == Multiplier::pressure;
  Matrix2Xd x(2, line.node_count()), F = Matrix2Xd::Zero(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i) {
    const Vector2d n = line.normal.col(i);
    x.col(i) = parts.mesh().vertices.col(line.vertex[i]);
    if (of_all || !is_held(free_parts(parts, i, n)))
      F.col(i) += solution.force(0, i) * n;
    if (!is_held_along(parts, i))
      F.col(i) += solution.force(1, i) * Vector2d(-n.y(), n.x());
  }
  const double missed = missed_push(*parts.tool, x, F, line.length.sum());
  if (!(missed <= of_the_row))
    finds.push_back(finding("tool", how_far(missed),
                            "contact forces miss its push by ", missed));
}

}  // namespace

Finds line_finds(const Case& problem, const Assembled& parts) {
  Finds finds;
  check_edges(problem, parts, finds);
  check_corners(problem, parts, finds);
  if (finds.empty()) check_coupling(problem, parts, finds);
  return finds;
}

Feasible feasible(const Case& problem, const Assembled& parts) {
  const ContactLine& line = parts.line;
  const VectorXd& gap = parts.law.gap;
  const double scale =
      std::max(parts.value.cwiseAbs().maxCoeff(), gap.cwiseAbs().maxCoeff());
  bool any_free = false;
  for (int v : line.vertex)
    any_free =
        any_free || !parts.prescribed[2 * v] || !parts.prescribed[2 * v + 1];
  Feasible result = any_free ? Feasible::yes : Feasible::unknown;
  const auto worsen = [&](Feasible to) {
    if (result != Feasible::no) result = to;
  };
  const Matrix2Xd w = against_foundation(line, gap, {}, parts.value);
  for (int i = 0; i < line.node_count(); ++i)
    if (problem.law == Law::coulomb && locks_itself(parts, i))
      worsen(Feasible::unknown);
  for (int i = 0; i < line.node_count() && problem.law == Law::coulomb; ++i)
    for (int j = 0; j < i; ++j)
      if (jams(parts, i, j)) worsen(Feasible::unknown);
  for (int i = 0; i < line.node_count(); ++i) {
    const int x = 2 * line.vertex[i];
    double along = 0;
    for (int c = 0; c < 2; ++c)
      if (!parts.prescribed[x + c])
        along = std::max(along, std::abs(line.normal(c, i)));
    const bool movable = along > 1e-6;
    // a motion out of the foundation a thousand times as long as its depth is none
    if (movable && along < 2e-3 && w(0, i) > 0) worsen(Feasible::unknown);
    if (!movable && w(0, i) > 0)
      worsen(w(0, i) > 1e-6 * scale && !problem.has_opposites()
                 ? Feasible::no
                 : Feasible::unknown);
    for (
        int j = 0; j < i && movable;
        // two nodes of one vertex with one free component may ask for opposite motions
        ++j)
      if (line.vertex[j] == line.vertex[i] &&
          (parts.prescribed[x] || parts.prescribed[x + 1]))
        worsen(Feasible::unknown);
  }
  return result;
}

Finds solution_finds(const Case& problem, const Assembled& parts,
                     const ContactSolution<2>& solution) {
  Finds finds;
  check_tool(problem, parts, solution, finds);
  check_balance(parts, solution, finds);
  check_supports(parts, solution, finds);
  Assembled felt = parts;
  for (int i = 0; parts.tool && i < parts.line.node_count(); ++i)
    if (is_held_along(parts, i))
      felt.law.previous[i] =
          parts.before_tool.size() > 0 ? parts.before_tool[i] : 0;
  check_law(problem, felt, solution, finds);
  return finds;
}

}  // namespace ffcontact::fuzz
