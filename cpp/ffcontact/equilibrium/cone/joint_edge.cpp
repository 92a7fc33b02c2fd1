// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/joint_edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Places nearer to each other than this part of the body's size are the same.
constexpr double same_place = 1e-9;

/// The edges that each edge of a contact face lies on.
using EdgeLinks = std::map<int, std::vector<int>>;

EdgeLinks linked_edges(const Topology<3>& topology,
                       const std::vector<ContactFace>& contact) {
  const auto& of_facet = topology.ridges.of_facet;
  EdgeLinks links;
  for (const ContactFace& face : contact)
    for (int k = 0; k < 3; ++k) {
      const int own = of_facet(k, face.face);
      std::vector<int>& of_own = links[own];
      if (face.opposite < 0) continue;
      const int other = of_facet(face.opposite_corner[k], face.opposite);
      of_own.push_back(other);
      links[other].push_back(own);
    }
  return links;
}

/// All edges that hang together with one, ascending; they are taken from `links`.
std::vector<int> taken_with(int edge, EdgeLinks& links) {
  std::set<int> found{edge};
  std::vector<int> next{edge};
  while (!next.empty()) {
    const auto of_edge = links.extract(next.back());
    next.pop_back();
    for (int other : of_edge.mapped())
      if (found.insert(other).second) next.push_back(other);
  }
  return {found.begin(), found.end()};
}

using RoundedPlace = std::array<double, 3>;

/// The lowest of the edges' middles, in steps of a length.
RoundedPlace lowest_middle(const Topology<3>& topology,
                           const std::vector<int>& edges, double step) {
  std::vector<RoundedPlace> places;
  for (int edge : edges) {
    const Vector3d place =
        edge_middle(topology.mesh, topology.ridges, edge) / step;
    places.push_back(
        {std::round(place[0]), std::round(place[1]), std::round(place[2])});
  }
  return *std::min_element(places.begin(), places.end());
}

/// Numbers the unknowns around edges that lie on each other.
class JointNumbering {
 public:
  JointNumbering(const Topology<3>& topology,
                 const std::vector<ContactFace>& contact)
      : topology_(topology) {
    for (const ContactFace& face : contact)
      if (face.opposite >= 0) facing_.emplace(face.opposite, &face);
  }

  JointEdge joint(const std::vector<int>& edges) const {
    JointEdge joint;
    joint.size = 6;
    std::map<int, int> modes;  // the first of each face
    for (int edge : edges)
      for (int face : facets_around<3>(topology_.ridges, edge))
        if (facing_.count(face) == 0) {
          modes[face] = joint.size;
          joint.size += 3;
        }
    for (int edge : edges)
      joint.parts.push_back(part(edge, turn(edge, edges[0]), modes));
    return joint;
  }

 private:
  Vector3d direction(int edge) const {
    return edge_vector(topology_.mesh, topology_.ridges, edge);
  }

  /// -1 where one edge runs against the other, and faces turn about it the other way.
  double turn(int edge, int other) const {
    return direction(edge).dot(direction(other)) < 0 ? -1 : 1;
  }

  JointEdge::Part part(int edge, double turn,
                       const std::map<int, int>& modes) const {
    const auto first_mode = [&](int face) {
      return entry_of(modes, face, "mode of a face");
    };
    const std::vector<int> faces = facets_around<3>(topology_.ridges, edge);
    const int size = unknowns_around<3>(topology_.ridges, edge);
    JointEdge::Part part{edge, VectorXi::LinSpaced(size, 0, size - 1),
                         VectorXd::Ones(size)};
    part.sign.head<6>().setConstant(turn);
    for (int i = 0; i < count_of(faces); ++i) {
      auto place = part.place.segment<3>(6 + 3 * i);
      const auto facing = facing_.find(faces[i]);
      if (facing == facing_.end()) {
        place = Vector3i(0, 1, 2).array() + first_mode(faces[i]);
        continue;
      }
      const ContactFace& own = *facing->second;
      for (int k = 0; k < 3; ++k)
        place[own.opposite_corner[k]] = first_mode(own.face) + k;
      part.sign.segment<3>(6 + 3 * i).setConstant(-1);
    }
    return part;
  }

  const Topology<3>& topology_;
  /// the contact face that each opposite face faces
  std::map<int, const ContactFace*> facing_;
};

}  // namespace

std::vector<JointEdge> joint_edges(const Topology<3>& topology,
                                   const std::vector<ContactFace>& contact) {
  if (contact.empty()) return {};
  const double size = box_sides(topology.mesh.vertices).maxCoeff();
  std::multimap<RoundedPlace, std::vector<int>> in_order;
  EdgeLinks links = linked_edges(topology, contact);
  while (!links.empty()) {
    const std::vector<int> edges = taken_with(links.begin()->first, links);
    in_order.emplace(lowest_middle(topology, edges, same_place * size), edges);
  }
  const JointNumbering numbering(topology, contact);
  std::vector<JointEdge> joints;
  for (const auto& [place, edges] : in_order)
    joints.push_back(numbering.joint(edges));
  return joints;
}

MatrixXd joint_form(const Topology<3>& topology, const JointEdge& joint,
                    const FacetForms<3>& forms) {
  MatrixXd A = MatrixXd::Zero(joint.size, joint.size);
  for (const JointEdge::Part& part : joint.parts) {
    const MatrixXd of_part =
        ridge_form<3>(topology, part.edge,
                      shifts_around<3>(topology, part.edge).data(), forms);
    A(part.place, part.place) +=
        part.sign.asDiagonal() * of_part * part.sign.asDiagonal();
  }
  return A;
}

MatrixXd joint_conditions(const Topology<3>& topology, const JointEdge& joint,
                          const KnownComponents& known) {
  MatrixXd rows(0, joint.size);
  for (const JointEdge::Part& part : joint.parts) {
    const MatrixXd of_part = ridge_conditions<3>(
        topology, part.edge, shifts_around<3>(topology, part.edge).data(),
        known);
    const Index first = rows.rows();
    rows.conservativeResize(first + of_part.rows(), Eigen::NoChange);
    rows.bottomRows(of_part.rows()).setZero();
    rows(Eigen::seqN(first, of_part.rows()), part.place) =
        of_part * part.sign.asDiagonal();
  }
  return rows;
}

VectorXd joint_restricted(const Topology<3>& topology, const JointEdge& joint,
                          const Matrix9Xd& g) {
  VectorXd x = VectorXd::Zero(joint.size);
  for (const JointEdge::Part& part : joint.parts)
    x(part.place) +=
        part.sign.cwiseProduct(restricted<3>(topology, part.edge, g));
  return x;
}

}  // namespace ffcontact
