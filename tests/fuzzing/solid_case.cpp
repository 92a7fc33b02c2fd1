// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_case.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "dice.hpp"
#include "support/solid_bodies.hpp"

namespace ffcontact::fuzz {

namespace {

using namespace test;
using Tetrahedron = Eigen::Matrix<double, 3, 4>;

constexpr int below_crack = 21, above_crack = 22;

Vector3d drawn_vector(Dice& dice, double size) {
  return {dice.real(-size, size), dice.real(-size, size),
          dice.real(-size, size)};
}

/// A box and its cells.
struct Box {
  Vector3i cells;
  Vector3d low, size;
};

SolidMesh mesh_of(const Box& box, bool is_regular, Dice& dice) {
  SolidMesh mesh = brick(box.cells, box.size);
  std::mt19937 random(static_cast<unsigned>(dice.bits()));
  if (!is_regular) {
    const double cell =
        box.size.cwiseQuotient(box.cells.cast<double>()).minCoeff();
    mesh = shuffled(moved(mesh, cell, 0.15, random), random);
  }
  mesh.vertices.colwise() += box.low;
  return mesh;
}

/// A brick with a crack in its middle plane from low_x on; its faces share their front.
SolidMesh cracked_brick(Dice& dice) {
  const Vector3i cells(dice.integer(2, 4), dice.integer(1, 3), 2);
  SolidMesh mesh = brick(cells, {3, 2, 2});
  const double front = 3.0 * dice.integer(1, cells.x() - 1) / cells.x();
  std::map<int, int> twin;
  const int vertices = mesh.vertex_count();
  mesh.vertices.conservativeResize(3, 2 * vertices);
  int next = vertices;
  for (int v = 0; v < vertices; ++v)
    if (mesh.vertices(2, v) == 1 && mesh.vertices(0, v) < front - 1e-9) {
      mesh.vertices.col(next) = mesh.vertices.col(v);
      twin[v] = next++;
    }
  mesh.vertices.conservativeResize(3, next);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    double height = 0;
    for (int k = 0; k < 4; ++k) height += mesh.vertices(2, mesh.cells(k, t));
    if (height < 4) continue;
    for (int k = 0; k < 4; ++k)
      if (const auto found = twin.find(mesh.cells(k, t)); found != twin.end())
        mesh.cells(k, t) = found->second;
  }
  add_boundary(mesh);
  std::set<int> upper;
  for (const auto& [v, other] : twin) upper.insert(other);
  for (Index f = 0; f < mesh.boundary.cols(); ++f) {
    bool in_plane = true, is_upper = false;
    for (const int v : mesh.boundary.col(f)) {
      in_plane = in_plane && mesh.vertices(2, v) == 1;
      is_upper = is_upper || upper.count(v) > 0;
    }
    if (in_plane) mesh.boundary_label[f] = is_upper ? above_crack : below_crack;
  }
  return mesh;
}

enum class Layout { one, stack, on_two, crack };

/// Shapes, and who faces whom.
class Shapes {
 public:
  Shapes(Layout layout, Dice& dice) : layout_(layout), dice_(dice) {
    if (layout == Layout::crack)
      meshes_.push_back(cracked_brick(dice));
    else if (layout == Layout::on_two)
      put_on_two();
    else
      put_stack(layout == Layout::one ? 1 : dice.integer(2, 3));
  }

  const std::vector<SolidMesh>& meshes() const { return meshes_; }
  double overlap() const { return overlap_; }

 private:
  Vector3i cells() {
    return {dice_.integer(1, 3), dice_.integer(1, 3), dice_.integer(1, 2)};
  }

  double drawn_gap() {
    const int kind = dice_.integer(0, 5);
    if (kind > 1) return 0;
    const double size = dice_.decades(1e-5, 1e-2);
    if (kind == 0) return size;
    overlap_ = std::max(overlap_, size);
    return -size;
  }

  void put_stack(int bodies) {
    const bool match = dice_.chance(0.3);
    Box box{cells(), {0, 0, 0}, {3, 2, 1}};
    for (int k = 0; k < bodies; ++k) {
      box.size.z() = dice_.chance(0.2) ? dice_.real(0.03, 0.2) : 1;
      box.low.z() -= box.size.z() + (k > 0 ? drawn_gap() : 0);
      if (k > 0 && !match) {
        box.cells = cells();
        box.low.head<2>() << dice_.real(-1, 1), dice_.real(-0.5, 0.5);
        if (dice_.chance(0.4)) box.low.head<2>().setZero();
      }
      meshes_.push_back(mesh_of(box, match || dice_.chance(0.2), dice_));
    }
  }

  /// A body on two that touch, or all but touch.
  void put_on_two() {
    const double joint = dice_.real(1, 2),
                 apart = dice_.chance(0.7) ? 0 : dice_.decades(1e-9, 1e-2);
    meshes_.push_back(mesh_of({cells(), {0, 0, 0}, {3, 2, 1}}, false, dice_));
    meshes_.push_back(
        mesh_of({cells(), {0, 0, -1}, {joint, 2, 1}}, false, dice_));
    meshes_.push_back(mesh_of(
        {cells(), {joint + apart, 0, -1}, {3 - joint, 2, 1}}, false, dice_));
  }

  Layout layout_;
  Dice& dice_;
  std::vector<SolidMesh> meshes_;
  double overlap_ = 0;
};

struct Surfaces {
  std::vector<ContactSurface> all;
  std::vector<double> gap;

  void add(const FacingSurface& pair) {
    all.push_back(pair.surface);
    gap.insert(gap.end(), pair.gap.begin(), pair.gap.end());
  }
  void add_rigid(const SolidCase& problem, int label, double apart) {
    all.push_back(contact_surface(problem.mesh, problem.faces, {label}));
    gap.insert(gap.end(), all.back().node_count(), apart);
  }
};

FacingSurface facing_all(const SolidCase& problem, int label,
                         const std::vector<int>& opposite) {
  const ContactSurface whole =
      contact_surface(problem.mesh, problem.faces, {label});
  return facing_surface(
      problem.mesh, problem.faces, whole,
      facing_polygons(problem.mesh, problem.faces, whole, opposite));
}

class Builder {
 public:
  Builder(std::uint64_t seed, std::uint64_t index) : dice_(seed, index) {}

  SolidCase built() {
    layout_ = dice_.pick<Layout>({Layout::one, Layout::one, Layout::stack,
                                  Layout::stack, Layout::stack, Layout::on_two,
                                  Layout::crack});
    const Shapes shapes(layout_, dice_);
    overlap_ = shapes.overlap();
    joined_ = joined_mesh(shapes.meshes());
    problem_.mesh = joined_.mesh;
    size_ = dice_.chance(0.2) ? dice_.decades(1e-6, 1e6) : 1;
    turned_ = dice_.chance(0.4);
    if (turned_)
      turn_ = (Eigen::AngleAxisd(dice_.real(-3, 3), Vector3d::UnitZ()) *
               Eigen::AngleAxisd(dice_.real(-3, 3), Vector3d::UnitX()))
                  .toRotationMatrix();
    problem_.mesh.vertices = size_ * turn_ * problem_.mesh.vertices;
    problem_.faces = facets_of(problem_.mesh);
    put_materials();
    assemble();
    put_surfaces();
    put_supports();
    put_loads();
    put_law();
    name();
    problem_.steps = dice_.pick<int>({0, 3, 8, 8});
    return std::move(problem_);
  }

 private:
  int body_count() const { return joined_.body_count(); }
  int label(int body, int side) const { return joined_.label(body, side); }
  bool is_lowest(int body) const {
    return layout_ == Layout::on_two ? body > 0 : body + 1 == body_count();
  }

  void put_materials() {
    const bool differ = dice_.chance(0.3);
    for (int body = 0; body < body_count(); ++body)
      E_.push_back(differ ? dice_.decades(1e-1, 1e7) : 1e4);
    // the body on two others carries the multipliers: it is not the stiffest
    if (layout_ == Layout::on_two)
      std::iter_swap(E_.begin(), std::min_element(E_.begin(), E_.end()));
    for (int body = 0; body < body_count(); ++body) {
      const double nu = dice_.pick<double>({0, 0.2, 0.3, 0.45, 0.49});
      const int cells = joined_.first_cell[body + 1] - joined_.first_cell[body];
      problem_.hooke.insert(
          problem_.hooke.end(), cells,
          isotropic<3>(E_[body] * nu / ((1 + nu) * (1 - 2 * nu)),
                       E_[body] / (2 + 2 * nu)));
    }
    softest_ = *std::min_element(E_.begin(), E_.end());
  }

  /// Multipliers are on the softer side, as the plugin has them.
  FacingSurface pair(int k) const {
    const int upper = label(k, low_z), lower = label(k + 1, high_z);
    return E_[k] <= 3 * E_[k + 1] ? facing_all(problem_, upper, {lower})
                                  : facing_all(problem_, lower, {upper});
  }

  void assemble();

  void put_surfaces() {
    Surfaces surfaces;
    if (layout_ == Layout::crack)
      surfaces.add(facing_all(problem_, above_crack, {below_crack}));
    else if (layout_ == Layout::on_two)
      surfaces.add(facing_all(problem_, label(0, low_z),
                              {label(1, high_z), label(2, high_z)}));
    else if (layout_ == Layout::one)
      surfaces.add_rigid(
          problem_, label(0, low_z),
          dice_.chance(0.2) ? dice_.decades(1e-5, 1e-2) * size_ : 0);
    else
      for (int k = 0; k + 1 < body_count(); ++k) surfaces.add(pair(k));
    problem_.surface = joined_contact<3>(surfaces.all);
    problem_.law.gap = Eigen::Map<const VectorXd>(
        surfaces.gap.data(), static_cast<Index>(surfaces.gap.size()));
    if (problem_.law.gap.isZero(0)) problem_.law.gap.resize(0);
  }

  /// @param value  on the body before it was turned and scaled, for sizes of 1
  void prescribe(int side, int component, double value) {
    for (const int v : vertices_on(problem_.mesh, side)) {
      problem_.prescribed[3 * v + component] = 1;
      problem_.value[3 * v + component] = value;
    }
  }
  void move(int side, const Vector3d& shift) {
    const Vector3d turned = size_ * turn_ * shift;
    for (int c = 0; c < 3; ++c) prescribe(side, c, turned[c]);
  }
  void clamp(int side) { move(side, Vector3d::Zero()); }

  void put_supports() {
    problem_.prescribed = Flags(problem_.load.size(), 0);
    problem_.value = VectorXd::Zero(problem_.load.size());
    problem_.promised = overlap_ == 0;
    for (int k = 0; k < body_count(); ++k) {
      const bool has_ground =
          is_lowest(k) && layout_ != Layout::one && layout_ != Layout::crack;
      const double kind = dice_.real(0, 1);
      if (has_ground && kind < 0.6) {
        clamp(label(k, low_z));
      } else if (kind < 0.75 || (k == 0 && kind < 0.9)) {
        if (kind < 0.4 && !turned_) {
          prescribe(label(k, low_x), 0, 0);
          prescribe(label(k, low_y), 1, 0);
          problem_.promised = problem_.promised && k == 0;
          walls_.insert(k);
        } else {
          clamp(label(k, dice_.chance(0.5) ? low_x : high_y));
        }
      } else {
        problem_.promised = false;
        free_.insert(k);
      }
    }
  }

  void load(int side, const Vector3d& traction) {
    const Vector3d turned = turn_ * traction;
    for (Index f = 0; f < problem_.mesh.boundary.cols(); ++f)
      if (problem_.mesh.boundary_label[f] == side)
        problem_.on_face[f].traction += turned;
  }

  void put_loads() {
    const double stress = softest_ * dice_.decades(1e-5, 1e-2);
    if (dice_.chance(0.4) && free_.count(0) == 0) {
      const double motion = dice_.decades(1e-5, 1e-2);
      const Vector3d shift(dice_.real(-motion, motion),
                           dice_.real(-motion, motion),
                           dice_.real(-2 * motion, motion));
      move(label(0, high_z), shift);
      // what is held at a side as well may be pressed into what it faces
      if (walls_.count(0) == 0) problem_.promised = false;
    } else {
      load(label(0, high_z), Vector3d(0, 0, -dice_.real(0, stress)) +
                                 drawn_vector(dice_, 0.3 * stress));
      if (walls_.count(0) > 0) problem_.promised = false;
    }
    for (int k = 0; k < body_count(); ++k)
      if (dice_.chance(0.5))
        load(label(k, high_x), drawn_vector(dice_, stress));
    if (dice_.chance(0.2))
      problem_.body_force = turn_ * drawn_vector(dice_, stress / size_);
    stress_ = stress;
    sum_loads();
  }

  void sum_loads();

  VectorXd coefficient(double mean) {
    const int nodes = problem_.surface.node_count();
    if (!dice_.chance(0.2)) return VectorXd::Constant(nodes, mean);
    return VectorXd::NullaryExpr(nodes,
                                 [&] { return mean * dice_.real(0, 1); });
  }

  void put_law() {
    ContactLaw<3>& law = problem_.law;
    const int nodes = problem_.surface.node_count();
    const int kind = dice_.integer(0, 9);
    double mu = 0;
    if (kind > 2) mu = dice_.real(0, 1);
    if (kind == 7) mu = dice_.real(1, 30);
    if (kind == 8) mu = dice_.pick<double>({1e3, 1e8, 1e30});
    law.friction = coefficient(mu);
    if (kind == 9) law.slip_bound = coefficient(stress_ * dice_.real(0, 1));
    if (kind == 6) law.shear_limit = coefficient(stress_ * dice_.real(0, 1));
    dice_.chance(0.1);  // asks nothing: a seed keeps its problems
    if (dice_.chance(0.1)) {
      const double slip = 1e-4 * size_;
      law.previous = Matrix2Xd::NullaryExpr(
          2, nodes, [&] { return dice_.real(-slip, slip); });
    }
    problem_.promised = problem_.promised && (kind == 9 || mu <= 1);
    law_name_ = kind == 9 ? "tresca"
                : mu == 0 ? "frictionless"
                : mu <= 1 ? "coulomb"
                          : "large friction";
    if (kind == 6) law_name_ = "limited";
  }

  void name() {
    const char* layouts[] = {"one", "stack", "on two", "crack"};
    problem_.kind = std::string("solid ") + layouts[static_cast<int>(layout_)] +
                    " " + law_name_ +
                    (problem_.promised ? "" : " (soundness only)");
  }

  Dice dice_;
  Layout layout_ = Layout::one;
  JoinedSolids joined_;
  SolidCase problem_;
  double size_ = 1, overlap_ = 0, softest_ = 0, stress_ = 0;
  std::vector<double> E_;
  bool turned_ = false;
  Matrix3d turn_ = Matrix3d::Identity();
  std::set<int> free_, walls_;
  std::string law_name_;
};

/// K of all cells.
RowMatrix assembled_stiffness(const SolidMesh& mesh,
                              const HookeTensors<3>& hooke) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Hats hats = hats_of(corners_at(mesh, t));
    Eigen::Matrix<double, 6, 12> B = Eigen::Matrix<double, 6, 12>::Zero();
    for (int k = 0; k < 4; ++k) {
      const Vector3d g = hats.gradient.col(k);
      B.block<6, 3>(0, 3 * k) << g.x(), 0, 0, 0, g.y(), 0, 0, 0, g.z(), 0,
          g.z(), g.y(), g.z(), 0, g.x(), g.y(), g.x(), 0;
    }
    const Eigen::Matrix<double, 12, 12> K =
        hats.volume * B.transpose() * hooke[t] * B;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        entries.emplace_back(3 * mesh.cells(i / 3, t) + i % 3,
                             3 * mesh.cells(j / 3, t) + j % 3,
                             (K(i, j) + K(j, i)) / 2);
  }
  RowMatrix K(3 * mesh.vertex_count(), 3 * mesh.vertex_count());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

double area_of_face(const SolidMesh& mesh, Index f) {
  const Vector3d a = mesh.vertices.col(mesh.boundary(0, f)),
                 b = mesh.vertices.col(mesh.boundary(1, f)),
                 c = mesh.vertices.col(mesh.boundary(2, f));
  return (b - a).cross(c - a).norm() / 2;
}

VectorXd assembled_loads(const SolidCase& problem) {
  const SolidMesh& mesh = problem.mesh;
  VectorXd load = VectorXd::Zero(3 * mesh.vertex_count());
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    for (const int v : mesh.boundary.col(f))
      load.segment<3>(3 * v) +=
          area_of_face(mesh, f) / 3 * problem.on_face[f].traction;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (const int v : mesh.cells.col(t))
      load.segment<3>(3 * v) +=
          hats_of(corners_at(mesh, t)).volume / 4 * problem.body_force;
  return load;
}

void Builder::assemble() {
  problem_.stiffness = assembled_stiffness(problem_.mesh, problem_.hooke);
  problem_.on_face.resize(problem_.mesh.boundary.cols());
  problem_.load = VectorXd::Zero(problem_.stiffness.rows());
}

void Builder::sum_loads() { problem_.load = assembled_loads(problem_); }

}  // namespace

Tetrahedron corners_at(const SolidMesh& mesh, int cell) {
  Tetrahedron x;
  for (int k = 0; k < 4; ++k) x.col(k) = mesh.vertices.col(mesh.cells(k, cell));
  return x;
}

Hats hats_of(const Tetrahedron& x) {
  Matrix3d sides;
  for (int k = 0; k < 3; ++k) sides.col(k) = x.col(k + 1) - x.col(0);
  Hats hats;
  hats.volume = sides.determinant() / 6;
  hats.gradient.rightCols<3>() = sides.inverse().transpose();
  hats.gradient.col(0) = -hats.gradient.rightCols<3>().rowwise().sum();
  return hats;
}

VoigtVector<3> strain_at(const SolidMesh& mesh, int cell, const VectorXd& u) {
  const Hats hats = hats_of(corners_at(mesh, cell));
  const Vector3d first = u.segment<3>(3 * mesh.cells(0, cell));
  Matrix3d gradient = Matrix3d::Zero();
  for (int k = 1; k < 4; ++k)  // differences: rigid motions cancel
    gradient += (u.segment<3>(3 * mesh.cells(k, cell)) - first) *
                hats.gradient.col(k).transpose();
  VoigtVector<3> strain;
  strain << gradient(0, 0), gradient(1, 1), gradient(2, 2),
      gradient(1, 2) + gradient(2, 1), gradient(0, 2) + gradient(2, 0),
      gradient(0, 1) + gradient(1, 0);
  return strain;
}

Matrix3d tensor_of(const VoigtVector<3>& s) {
  Matrix3d tensor;
  tensor << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
  return tensor;
}

RowMatrix SolidCase::A() const {
  RowMatrix A = stiffness;
  for (Index dof = 0; dof < A.rows(); ++dof)
    if (prescribed[dof]) A.coeffRef(dof, dof) = 1e30;
  return A;
}

VectorXd SolidCase::b() const {
  VectorXd b = load;
  for (Index dof = 0; dof < b.size(); ++dof)
    if (prescribed[dof]) b[dof] = 1e30 * value[dof];
  return b;
}

FaceMoments SolidCase::neumann() const {
  FaceMoments moments = FaceMoments::Zero(9, mesh.boundary.cols());
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    for (int k = 0; k < 3; ++k)
      moments.col(f).segment<3>(3 * k) =
          area_of_face(mesh, f) / 3 * on_face[f].traction;
  return moments;
}

BodyLoadsOfCells<3> SolidCase::body_loads() const {
  BodyLoadsOfCells<3> loads = BodyLoadsOfCells<3>::Zero(12, mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 4; ++k)
      loads.col(t).segment<3>(3 * k) =
          hats_of(corners_at(mesh, t)).volume / 4 * body_force;
  return loads;
}

SolidCase random_solid(std::uint64_t seed, std::uint64_t index) {
  return Builder(seed, index).built();
}

std::vector<int> contact_labels(const SolidCase& problem) {
  std::set<int> labels;
  for (const int face : problem.surface.face)
    labels.insert(
        problem.mesh.boundary_label[problem.faces.boundary_index[face]]);
  return {labels.begin(), labels.end()};
}

SolidCase refined_once(const SolidCase& coarse,
                       const std::vector<int>& labels) {
  SolidCase fine;
  const SolidMesh& mesh = coarse.mesh;
  std::map<std::pair<int, int>, int> middle;
  std::vector<std::pair<int, int>> ends;
  const auto between = [&](int a, int b) {
    if (a > b) std::swap(a, b);
    const auto [at, is_new] = middle.emplace(
        std::pair(a, b), mesh.vertex_count() + static_cast<int>(ends.size()));
    if (is_new) ends.emplace_back(a, b);
    return at->second;
  };
  std::vector<std::array<int, 4>> cells;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Eigen::Vector4i v = mesh.cells.col(t);
    const int m01 = between(v[0], v[1]), m02 = between(v[0], v[2]),
              m03 = between(v[0], v[3]), m12 = between(v[1], v[2]),
              m13 = between(v[1], v[3]), m23 = between(v[2], v[3]);
    for (const std::array<int, 4>& cell :
         {std::array<int, 4>{v[0], m01, m02, m03},
          {m01, v[1], m12, m13},
          {m02, m12, v[2], m23},
          {m03, m13, m23, v[3]},  // around m02 - m13
          {m02, m13, m01, m03},
          {m02, m13, m03, m23},
          {m02, m13, m23, m12},
          {m02, m13, m12, m01}}) {
      cells.push_back(cell);
      fine.hooke.push_back(coarse.hooke[t]);
    }
  }
  fine.mesh.vertices.resize(
      3, mesh.vertex_count() + static_cast<Index>(ends.size()));
  fine.mesh.vertices.leftCols(mesh.vertex_count()) = mesh.vertices;
  for (std::size_t k = 0; k < ends.size(); ++k)
    fine.mesh.vertices.col(mesh.vertex_count() + static_cast<Index>(k)) =
        (mesh.vertices.col(ends[k].first) + mesh.vertices.col(ends[k].second)) /
        2;
  fine.mesh.cells.resize(4, static_cast<Index>(cells.size()));
  for (std::size_t t = 0; t < cells.size(); ++t) {
    const auto column = static_cast<Index>(t);
    for (int k = 0; k < 4; ++k) fine.mesh.cells(k, column) = cells[t][k];
    if (hats_of(corners_at(fine.mesh, static_cast<int>(t))).volume < 0)
      std::swap(fine.mesh.cells(0, column), fine.mesh.cells(1, column));
  }
  fine.mesh.boundary.resize(3, 4 * mesh.boundary.cols());
  fine.mesh.boundary_label.resize(4 * mesh.boundary.cols());
  for (Index f = 0; f < mesh.boundary.cols(); ++f) {
    const Vector3i v = mesh.boundary.col(f);
    const int a = between(v[0], v[1]), b = between(v[1], v[2]),
              c = between(v[2], v[0]);
    fine.mesh.boundary.middleCols<4>(4 * f) << v[0], a, c, a, a, v[1], b, b, c,
        b, v[2], c;
    for (int k = 0; k < 4; ++k) {
      fine.mesh.boundary_label[4 * f + k] = mesh.boundary_label[f];
      fine.on_face.push_back(coarse.on_face[f]);
    }
  }
  fine.faces = facets_of(fine.mesh);
  fine.surface = contact_surface(fine.mesh, fine.faces, labels);
  fine.law.friction = VectorXd::Zero(fine.surface.node_count());
  fine.body_force = coarse.body_force;
  fine.stiffness = assembled_stiffness(fine.mesh, fine.hooke);
  fine.load = assembled_loads(fine);
  fine.prescribed = Flags(fine.load.size(), 0);
  fine.value = VectorXd::Zero(fine.load.size());
  std::copy(coarse.prescribed.begin(), coarse.prescribed.end(),
            fine.prescribed.begin());
  fine.value.head(coarse.value.size()) = coarse.value;
  // linear between vertices that are prescribed, where that holds more than faces do, too
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      const int a = 3 * ends[k].first + c, b = 3 * ends[k].second + c;
      const Index dof = 3 * (mesh.vertex_count() + static_cast<Index>(k)) + c;
      if (!coarse.prescribed[a] || !coarse.prescribed[b]) continue;
      fine.prescribed[dof] = 1;
      fine.value[dof] = (coarse.value[a] + coarse.value[b]) / 2;
    }
  return fine;
}

}  // namespace ffcontact::fuzz
