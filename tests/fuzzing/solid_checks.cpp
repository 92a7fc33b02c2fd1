// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_checks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/interface/weights_by_node.hpp"
#include "ground.hpp"

namespace ffcontact::fuzz {

namespace {

constexpr double of_the_whole = 1e-10, of_the_row = 1e-9, of_the_law = 1e-9,
                 of_the_stress = 1e-9, of_the_error = 1e-8;

/// Forces at the nodes as loads, reactions included; those on rows that no displacement
/// moves are none.
VectorXd contact_load(const SolidCase& problem, const Matrix3Xd& force) {
  VectorXd load = VectorXd::Zero(problem.load.size());
  for (int i = 0; i < problem.surface.node_count(); ++i) {
    const Vector3d F = problem.surface.frame(i) * force.col(i);
    load.segment<3>(3 * problem.surface.vertex[i]) += F;
    visit_opposite(problem.surface, i, [&](int vertex, double weight) {
      load.segment<3>(3 * vertex) -= weight * F;
    });
  }
  return load;
}

/// (u_n - gap, u_t - previous) at the nodes.
Matrix3Xd motion_at_nodes(const SolidCase& problem, const VectorXd& u) {
  Matrix3Xd v(3, problem.surface.node_count());
  for (int i = 0; i < v.cols(); ++i) {
    Vector3d jump = u.segment<3>(3 * problem.surface.vertex[i]);
    visit_opposite(problem.surface, i, [&](int vertex, double weight) {
      jump -= weight * u.segment<3>(3 * vertex);
    });
    v.col(i) = problem.surface.frame(i).transpose() * jump;
    if (problem.law.gap.size() > 0) v(0, i) -= problem.law.gap[i];
    if (problem.law.previous.size() > 0)
      v.col(i).tail<2>() -= problem.law.previous.col(i);
  }
  return v;
}

double largest_motion(const SolidCase& problem, const VectorXd& u) {
  double largest = u.cwiseAbs().maxCoeff();
  if (problem.law.gap.size() > 0)
    largest = std::max(largest, problem.law.gap.cwiseAbs().maxCoeff());
  if (problem.law.previous.size() > 0)
    largest = std::max(largest, problem.law.previous.cwiseAbs().maxCoeff());
  return largest;
}

/// The largest stress of a displacement.
double stress_size(const SolidCase& problem, const VectorXd& u) {
  double largest = 1e-300;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    largest =
        std::max(largest, (problem.hooke[t] * strain_at(problem.mesh, t, u))
                              .cwiseAbs()
                              .maxCoeff());
  return largest;
}

/// Where its own vertex cannot move, a node has no condition of its own: the nodes beside
/// it keep the bodies apart.
bool is_free(const SolidCase& problem, int node) {
  const int dof = 3 * problem.surface.vertex[node];
  return !problem.prescribed[dof] && !problem.prescribed[dof + 1] &&
         !problem.prescribed[dof + 2];
}

double bound_at(const SolidCase& problem, int node, double pressure) {
  const ContactLaw<3>& law = problem.law;
  double bound = law.slip_bound.size() > 0 ? law.slip_bound[node]
                                           : law.friction[node] * pressure;
  if (law.shear_limit.size() > 0)
    bound = std::min(bound, law.shear_limit[node]);
  return bound;
}

void check_balance(const SolidCase& problem, const ContactSolution<3>& solution,
                   Finds& finds) {
  const VectorXd contact = contact_load(problem, solution.force),
                 residual = problem.stiffness * solution.displacement -
                            problem.load - contact;
  const double moved = largest_motion(problem, solution.displacement);
  VectorXd size = problem.load.cwiseAbs() + contact.cwiseAbs();
  for (Index row = 0; row < size.size(); ++row)
    for (RowMatrix::InnerIterator e(problem.stiffness, row); e; ++e)
      size[row] += std::abs(e.value()) * moved;
  const double scale = size.maxCoeff(), last_place = 2.2e-16 * scale;
  Largest whole, row;
  for (int dof = 0; dof < residual.size(); ++dof) {
    if (problem.prescribed[dof]) continue;
    const double terms = std::max(size.segment<3>(dof - dof % 3).maxCoeff(),
                                  last_place / of_the_row);
    whole.note(std::abs(residual[dof]), dof);
    row.note(terms > 0 ? std::abs(residual[dof]) / terms : 0, dof);
  }
  if (!(whole.value <= of_the_whole * scale))
    finds.push_back(finding("balance", how_far(whole.value / scale), "dof ",
                            whole.place, " by ", whole.value / scale,
                            " of the largest force"));
  if (!(row.value <= of_the_row))
    finds.push_back(finding("balance", how_far(row.value), "dof ", row.place,
                            " by ", row.value, " of the forces there"));
}

void check_supports(const SolidCase& problem, const VectorXd& u,
                    const char* what, Finds& finds) {
  for (Index dof = 0; dof < u.size(); ++dof)
    if (problem.prescribed[dof] &&
        !(std::abs(u[dof] - problem.value[dof]) <=
          1e-12 * problem.value.cwiseAbs().maxCoeff())) {
      finds.push_back(finding("support", what, " has ", u[dof], " at dof ", dof,
                              ", not ", problem.value[dof]));
      return;
    }
}

/// The law for forces over areas P at the nodes.
void check_law(const SolidCase& problem, const ContactSolution<3>& solution,
               Finds& finds) {
  const Matrix3Xd v = motion_at_nodes(problem, solution.displacement);
  const double moved = largest_motion(problem, solution.displacement);
  double largest = stress_size(problem, solution.displacement);
  for (int i = 0; i < v.cols(); ++i)
    largest = std::max(largest,
                       solution.force.col(i).norm() / problem.surface.area[i]);
  if (moved == 0) return;
  Largest tension, cone, penetration, apart, slip;
  for (int i = 0; i < v.cols(); ++i) {
    const Vector3d P = solution.force.col(i) / problem.surface.area[i];
    const double bound = bound_at(problem, i, std::max(0.0, -P[0])),
                 Pt = P.tail<2>().norm(), vt = v.col(i).tail<2>().norm();
    tension.note(P[0] / largest, i);
    cone.note((Pt - bound) / largest, i);
    if (!is_free(problem, i)) continue;
    penetration.note(v(0, i) / moved, i);
    apart.note(std::min(-P[0] / largest, -v(0, i) / moved), i);
    if (vt <= of_the_law * moved) continue;
    const Eigen::Vector2d against = -bound * v.col(i).tail<2>() / vt;
    slip.note((P.tail<2>() - against).norm() / largest, i);
  }
  const auto check = [&](const char* name, const Largest& found, double most) {
    if (!(found.value <= most))
      finds.push_back(finding("law", how_far(found.value), name, " at node ",
                              found.place, " by ", found.value));
  };
  check("tension", tension, of_the_law);
  check("friction beyond its bound", cone, of_the_law);
  check("penetration", penetration, of_the_law);
  check("pressure across a gap", apart, of_the_law);
  check("slip not against friction", slip, 1e-6);  // of small motions
}

/// The stress of one tetrahedron as sigma_hat has it.
class Subdivided {
 public:
  using Corners = Eigen::Matrix<double, 3, 4>;

  Subdivided(const SolidMesh& mesh, int cell, SubcellStress<3> stress)
      : vertices_(mesh.cells.col(cell)),
        x_(corners_at(mesh, cell)),
        centre_(x_.rowwise().mean()),
        stress_(std::move(stress)) {}

  /// Corners k + 1, k + 2, k + 3 and G.
  Corners corners(int k) const {
    Corners part;
    for (int j = 0; j < 3; ++j) part.col(j) = x_.col((k + 1 + j) % 4);
    part.col(3) = centre_;
    return part;
  }
  Matrix3d at(int k, int corner) const {
    return tensor_of(stress_.col(4 * k + corner));
  }
  Vector3d divergence(int k) const {
    const Hats hats = hats_of(corners(k));
    Vector3d sum = Vector3d::Zero();
    for (int j = 0; j < 4; ++j) sum += at(k, j) * hats.gradient.col(j);
    return sum;
  }
  /// The normal of the face opposite to vertex k, outward.
  Vector3d normal(int k) const {
    return -hats_of(x_).gradient.col(k).normalized();
  }
  int vertex_of_face(int k, int j) const { return vertices_[(k + 1 + j) % 4]; }

  /// The largest difference of tractions across the six inner faces.
  double inner_jump() const {
    double largest = 0;
    for (int k = 0; k < 4; ++k)
      for (int l = k + 1; l < 4; ++l) {
        std::array<int, 2> shared{};
        for (int v = 0, found = 0; v < 4; ++v)
          if (v != k && v != l) shared[found++] = v;
        const Vector3d n = (x_.col(shared[1]) - x_.col(shared[0]))
                               .cross(centre_ - x_.col(shared[0]))
                               .normalized();
        const auto jump = [&](int corner_k, int corner_l) {
          return ((at(k, corner_k) - at(l, corner_l)) * n).norm();
        };
        for (const int v : shared)
          largest = std::max(largest, jump((v + 3 - k) % 4, (v + 3 - l) % 4));
        largest = std::max(largest, jump(3, 3));
      }
    return largest;
  }

  double shortest() const { return 3 * hats_of(x_).volume / largest_face(); }

 private:
  double largest_face() const {
    double largest = 0;
    for (int k = 0; k < 4; ++k)
      largest = std::max(
          largest, 3 * hats_of(x_).volume * hats_of(x_).gradient.col(k).norm());
    return largest;
  }

  Eigen::Vector4i vertices_;
  Corners x_;
  Vector3d centre_;
  SubcellStress<3> stress_;
};

/// What both sides of a face say of it, at its vertices in ascending order.
struct Side {
  int cell;
  Vector3d normal;
  std::array<Vector3d, 3> traction;
};
using FaceKey = std::array<int, 3>;

FaceKey sorted(FaceKey key) {
  std::sort(key.begin(), key.end());
  return key;
}

Side side_of(const Subdivided& stress, int cell, int k, const FaceKey& key) {
  Side side{cell, stress.normal(k), {}};
  for (int j = 0; j < 3; ++j) {
    const auto place =
        std::find(key.begin(), key.end(), stress.vertex_of_face(k, j)) -
        key.begin();
    side.traction[place] = stress.at(k, j) * side.normal;
  }
  return side;
}

class StressChecks {
 public:
  StressChecks(const SolidCase& problem, const ContactSolution<3>& solution,
               const Estimate<3>& estimate)
      : problem_(problem), estimate_(estimate) {
    const Topology<3> topology = topology_of(problem.mesh);
    const SolvedBody<3> body{problem.hooke,     solution.displacement,
                             solution.force,    problem.law,
                             problem.neumann(), problem.body_loads(),
                             solution.stiffness};
    for (int t = 0; t < problem.mesh.cell_count(); ++t) {
      stress_.emplace_back(problem.mesh, t,
                           stress_of(topology, estimate, body, t));
      const SolidMesh& mesh = problem.mesh;
      const VoigtVector<3> of_u =
          problem.hooke[t] * strain_at(mesh, t, estimate.displacement);
      displacement_stress_.push_back(of_u);
      scale_ = std::max(scale_, of_u.cwiseAbs().maxCoeff());
      // what rounding of the displacement makes of it
      const Hats hats = hats_of(corners_at(mesh, t));
      scale_ =
          std::max(scale_, 1e-4 * problem.hooke[t].cwiseAbs().maxCoeff() *
                               hats.gradient.cwiseAbs().maxCoeff() *
                               largest_motion(problem, estimate.displacement));
      for (int k = 0; k < 4; ++k) {
        FaceKey key;
        for (int j = 0; j < 3; ++j)
          key[j] = stress_.back().vertex_of_face(k, j);
        key = sorted(key);
        for (int corner = 0; corner < 4; ++corner)
          scale_ = std::max(scale_,
                            stress_.back().at(k, corner).cwiseAbs().maxCoeff());
        sides_[key].push_back(side_of(stress_.back(), t, k, key));
      }
    }
    for (const OnFace& face : problem.on_face)
      scale_ = std::max(scale_, face.traction.norm());
    for (Index m = 0; m < estimate.face_tractions.cols(); ++m)
      scale_ = std::max(scale_,
                        estimate.face_tractions.col(m).cwiseAbs().maxCoeff());
  }

  Finds finds() {
    check_inside();
    check_faces();
    check_error();
    return std::move(finds_);
  }

 private:
  void note(const char* check, const Largest& found, double scale) {
    if (!(found.value <= of_the_stress * scale))
      finds_.push_back(finding(check, how_far(found.value / scale), "at ",
                               found.place, " by ", found.value / scale,
                               " of the largest stress"));
  }

  void check_inside() {
    Largest divergence, jump;
    for (int t = 0; t < problem_.mesh.cell_count(); ++t) {
      const Subdivided& stress = stress_[t];
      for (int k = 0; k < 4; ++k)
        divergence.note(stress.shortest() *
                            (stress.divergence(k) + problem_.body_force).norm(),
                        t);
      jump.note(stress.inner_jump(), t);
    }
    note("divergence", divergence, scale_);
    note("jump", jump, scale_);
  }

  /// Tractions at the vertices of a contact face.
  std::map<FaceKey, std::array<Vector3d, 3>> contact_tractions() const {
    std::map<FaceKey, std::array<Vector3d, 3>> result;
    const ContactSurface& surface = problem_.surface;
    for (int m = 0; m < surface.face_count(); ++m) {
      const Vector3i v = problem_.faces.vertices.col(surface.face[m]);
      const FaceKey key = sorted({v[0], v[1], v[2]});
      int node = -1;
      for (const int i : surface.face_node.col(m)) node = std::max(node, i);
      if (surface.face_node.col(m).minCoeff() < 0 || !is_covered(m)) continue;
      for (int j = 0; j < 3; ++j) {
        const auto place =
            std::find(key.begin(), key.end(), v[j]) - key.begin();
        result[key][place] = surface.frame(node) *
                             estimate_.face_tractions.col(m).segment<3>(3 * j);
      }
    }
    return result;
  }

  void check_faces() {
    const auto contact = contact_tractions();
    std::map<FaceKey, int> column;
    for (Index f = 0; f < problem_.mesh.boundary.cols(); ++f)
      column[sorted({problem_.mesh.boundary(0, f), problem_.mesh.boundary(1, f),
                     problem_.mesh.boundary(2, f)})] = static_cast<int>(f);
    Largest across, given, on_contact;
    for (const auto& [key, sides] : sides_) {
      if (sides.size() == 2) {
        for (int j = 0; j < 3; ++j)
          across.note((sides[0].traction[j] + sides[1].traction[j]).norm(),
                      sides[0].cell);
        continue;
      }
      const Side& side = sides[0];
      const int f = column.at(key);
      if (const auto found = contact.find(key); found != contact.end()) {
        for (int j = 0; j < 3; ++j)
          on_contact.note((side.traction[j] - found->second[j]).norm(), f);
        continue;
      }
      if (is_faced(f) || is_in_contact(f)) continue;
      for (int c = 0; c < 3; ++c) {
        bool is_held = true;
        for (const int v : key)
          is_held = is_held && problem_.prescribed[3 * v + c];
        if (is_held) continue;
        for (int j = 0; j < 3; ++j)
          given.note(
              std::abs(side.traction[j][c] - problem_.on_face[f].traction[c]),
              f);
      }
    }
    note("across", across, scale_);
    note("traction", given, scale_);
    note("contact", on_contact, scale_);
  }

  /// Does all of a contact face face something?
  bool is_covered(int m) const {
    double faced = 0;
    bool against_a_body = false;
    for (const FacingPolygon& polygon : problem_.surface.polygons)
      if (polygon.contact_face == m) {
        faced += polygon.area;
        against_a_body = true;
      }
    const Vector3i v = problem_.faces.vertices.col(problem_.surface.face[m]);
    const auto at = [&](int j) -> Vector3d {
      return problem_.mesh.vertices.col(v[j]);
    };
    const double whole = (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
    return !against_a_body || faced >= (1 - 1e-13) * whole;
  }

  bool is_in_contact(int f) const {
    for (const int face : problem_.surface.face)
      if (problem_.faces.boundary_index[face] == f) return true;
    return false;
  }

  /// Does another body's surface face this boundary face, or a face of a contact label
  /// that faces nothing?
  bool is_faced(int f) const {
    for (const FacingPolygon& polygon : problem_.surface.polygons)
      if (problem_.faces.boundary_index[polygon.opposite_face] == f)
        return true;
    return false;
  }

  /// |sigma_hat - C eps(u_hat)|^2 by the mass of hats: the integrand is quadratic.
  void check_error() {
    double square = 0, size = 0;
    for (int t = 0; t < problem_.mesh.cell_count(); ++t) {
      const VoigtMatrix<3> compliance = problem_.hooke[t].inverse();
      for (int k = 0; k < 4; ++k) {
        const double volume = hats_of(stress_[t].corners(k)).volume;
        VoigtVector<3> sum = VoigtVector<3>::Zero();
        for (int j = 0; j < 4; ++j) {
          const VoigtVector<3> off =
              voigt(stress_[t].at(k, j)) - displacement_stress_[t];
          square += std::abs(volume) / 20 * off.dot(compliance * off);
          size += std::abs(volume) / 20 *
                  voigt(stress_[t].at(k, j))
                      .dot(compliance * voigt(stress_[t].at(k, j)));
          sum += off;
        }
        square += std::abs(volume) / 20 * sum.dot(compliance * sum);
      }
    }
    const double e = estimate_.elastic;
    if (!(std::abs(e * e - square) <= of_the_error * (e * e + 1e-6 * size)))
      finds_.push_back(finding("error", how_far(std::abs(e * e / square - 1)),
                               "elastic part ", e, ", not ",
                               std::sqrt(square)));
    const double whole = estimate_.e * estimate_.e;
    if (!(std::abs(whole - e * e - estimate_.contact) <= 1e-12 * whole))
      finds_.push_back(finding("error", "parts do not fit"));
    if (!(estimate_.contact >= -1e-12 * whole))
      finds_.push_back(finding("error", "contact part ", estimate_.contact));
  }

  static VoigtVector<3> voigt(const Matrix3d& s) {
    VoigtVector<3> v;
    v << s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1);
    return v;
  }

  const SolidCase& problem_;
  const Estimate<3>& estimate_;
  std::vector<Subdivided> stress_;
  std::vector<VoigtVector<3>> displacement_stress_;
  std::map<FaceKey, std::vector<Side>> sides_;
  double scale_ = 0;
  Finds finds_;
};

/// Tractions at places of each contact face between the nodes' values.
void check_cone(const SolidCase& problem, const Estimate<3>& estimate,
                Finds& finds) {
  const ContactSurface& surface = problem.surface;
  const double largest =
      std::max(stress_size(problem, estimate.displacement),
               estimate.face_tractions.cwiseAbs().maxCoeff());
  Largest outside;
  for (int m = 0; m < surface.face_count(); ++m) {
    const Vector3i nodes = surface.face_node.col(m);
    if (nodes.minCoeff() < 0) continue;
    for (int a = 0; a <= 4; ++a)
      for (int b = 0; a + b <= 4; ++b) {
        const Vector3d hat(a / 4.0, b / 4.0, 1 - (a + b) / 4.0);
        Vector3d r = Vector3d::Zero();
        double bound = 0;  // linear between the nodes
        for (int j = 0; j < 3; ++j) {
          const Vector3d at = estimate.face_tractions.col(m).segment<3>(3 * j);
          r += hat[j] * at;
          bound += hat[j] * bound_at(problem, nodes[j], std::max(0.0, -at[0]));
        }
        outside.note(std::max(r[0], r.tail<2>().norm() - bound) / largest, m);
      }
  }
  if (!(outside.value <= 1e-10))
    finds.push_back(finding("cone", how_far(outside.value), "face ",
                            outside.place, " by ", outside.value));
}

/// Is u_hat clear of what it faces? On a rigid foundation at the nodes, of another body at
/// the corners of what faces what, whose places must lie on each other along n.
void check_clear(const SolidCase& problem, const Estimate<3>& estimate,
                 Finds& finds) {
  const SolidMesh& mesh = problem.mesh;
  const ContactSurface& surface = problem.surface;
  const VectorXd& u = estimate.displacement;
  const double moved = largest_motion(problem, u),
               length = mesh.vertices.cwiseAbs().maxCoeff();
  if (moved == 0) return;
  Largest inside, apart;
  const Matrix3Xd v = motion_at_nodes(problem, u);
  std::vector<char> faces_a_body(surface.face_count(), 0);
  for (const FacingPolygon& polygon : surface.polygons) {
    faces_a_body[polygon.contact_face] = 1;
    const Vector3i own = problem.faces.vertices.col(
                       surface.face[polygon.contact_face]),
                   opposite = problem.faces.vertices.col(polygon.opposite_face);
    const int node = surface.face_node.col(polygon.contact_face).maxCoeff();
    if (node < 0) continue;
    const Vector3d n = surface.normal.col(node);
    for (Index k = 0; k < polygon.own.cols(); ++k) {
      Vector3d jump = Vector3d::Zero(), between = -polygon.distance[k] * n;
      for (int j = 0; j < 3; ++j) {
        const double a = polygon.own(j, k), b = polygon.opposite(j, k);
        jump +=
            a * u.segment<3>(3 * own[j]) - b * u.segment<3>(3 * opposite[j]);
        between +=
            b * mesh.vertices.col(opposite[j]) - a * mesh.vertices.col(own[j]);
      }
      apart.note(between.norm() / length, polygon.contact_face);
      inside.note((jump.dot(n) - polygon.distance[k]) / moved,
                  polygon.contact_face);
    }
  }
  for (int m = 0; m < surface.face_count(); ++m)
    for (const int i : surface.face_node.col(m))
      if (!faces_a_body[m] && i >= 0) inside.note(v(0, i) / moved, m);
  if (!(inside.value * moved <= 1e-10 * moved + 1e-14 * length))
    finds.push_back(finding("clear", how_far(inside.value), "u_hat at face ",
                            inside.place, " is inside by ", inside.value));
  if (!(apart.value <= 1e-10))
    finds.push_back(finding("pairing", "places at face ", apart.place,
                            " are apart by ", apart.value));
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

Finds solid_solution_finds(const SolidCase& problem,
                           const ContactSolution<3>& solution) {
  Finds finds;
  check_balance(problem, solution, finds);
  check_supports(problem, solution.displacement, "u_h", finds);
  check_law(problem, solution, finds);
  return finds;
}

Finds solid_estimate_finds(const SolidCase& problem,
                           const ContactSolution<3>& solution,
                           const Estimate<3>& estimate) {
  Finds finds;
  if (!estimate.admissible) {
    // what no estimate can do is said
    if (estimate.reason.rfind("e pays friction=", 0) != 0)
      finds.push_back(finding("admissible", estimate.reason));
    return finds;
  }
  check_supports(problem, estimate.displacement, "u_hat", finds);
  check_clear(problem, estimate, finds);
  check_cone(problem, estimate, finds);
  const Finds of_stress = StressChecks(problem, solution, estimate).finds();
  finds.insert(finds.end(), of_stress.begin(), of_stress.end());
  return finds;
}

Finds solid_bound_finds(const SolidCase& problem, const Estimate<3>& estimate) {
  const SolidCase fine = refined_once(problem, contact_labels(problem));
  const ContactSolution<3> solution = solve_contact(
      fine.mesh, fine.surface, fine.law, elastic_system(fine.A(), fine.b(), 3));
  if (!solution.accepted({})) return {};
  double square = 0;
  for (int t = 0; t < fine.mesh.cell_count(); ++t) {
    const VoigtVector<3> off =
        strain_at(fine.mesh, t, solution.displacement) -
        strain_at(problem.mesh, t / 8, estimate.displacement);
    square +=
        hats_of(corners_at(fine.mesh, t)).volume * off.dot(fine.hooke[t] * off);
  }
  const double error = std::sqrt(square);
  if (!(error <= estimate.e * (1 + 1e-8)))
    return {finding("bound", how_far(error / estimate.e - 1), "error ", error,
                    ", e ", estimate.e)};
  return {};
}

Outcome outcome_of(const SolidCase& problem) {
  Outcome outcome;
  std::string step = "matrix";
  try {
    const ElasticSystem system = elastic_system(problem.A(), problem.b(), 3);
    step = "contact";
    const ContactSolution<3> solution =
        solve_contact(problem.mesh, problem.surface, problem.law, system);
    if (!solution.accepted({})) {
      outcome.answer = std::string("not solved: ") + in_words(solution.status);
      if (problem.promised) outcome.finds.push_back(unsolved(solution));
      return outcome;
    }
    outcome.finds = solid_solution_finds(problem, solution);
    step = "estimate";
    RelaxationSettings settings;
    settings.steps = problem.steps;
    const Estimate<3> estimate = estimate_error(
        topology_of(problem.mesh), problem.surface, system,
        {problem.hooke, solution.displacement, solution.force, problem.law,
         problem.neumann(), problem.body_loads(), solution.stiffness},
        {settings});
    const Finds of_pair = solid_estimate_finds(problem, solution, estimate);
    outcome.finds.insert(outcome.finds.end(), of_pair.begin(), of_pair.end());
    const bool is_rigid_plane =
        !problem.surface.against_a_body() && problem.law.gap.size() == 0 &&
        problem.law.slip_bound.size() == 0 && problem.law.friction.isZero(0);
    if (is_rigid_plane && estimate.admissible &&
        problem.mesh.cell_count() < 60) {
      step = "bound";
      const Finds of_bound = solid_bound_finds(problem, estimate);
      outcome.finds.insert(outcome.finds.end(), of_bound.begin(),
                           of_bound.end());
    }
    outcome.answer = "judged";
  } catch (const std::exception& thrown) {
    const std::string message = thrown.what();
    outcome.answer = "refused by " + step + ": " + without_numbers(message);
    const bool is_refusal =
        dynamic_cast<const std::invalid_argument*>(&thrown) != nullptr ||
        dynamic_cast<const std::runtime_error*>(&thrown) != nullptr;
    if (!is_refusal)
      outcome.finds.push_back(finding("exception", step, ": ", message));
    else if (contains(message, "every dof of the contact"))
      return outcome;
    else if (problem.promised ||
             (step == "estimate" && !contains(message, "no tractions")))
      outcome.finds.push_back(finding("refused", step, ": ", message));
  }
  return outcome;
}

}  // namespace ffcontact::fuzz
