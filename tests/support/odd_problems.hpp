// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>

#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

/// Small contact problems of every kind that have a solution, and exactly one without
/// friction, with Tresca's law and with little friction: any support, load, material,
/// shape of the boundary and of the triangles.
namespace ffcontact::test {

class OddProblem {
 public:
  explicit OddProblem(std::mt19937& random) : random_(random) {}

  /// @param friction  Coulomb's coefficient at most
  Problem operator()(double friction) {
    for (;;) {
      const Mesh mesh = labelled(flipped(bitten(cells())));
      for (int label = 0; label < labels_; ++label)
        kind_[label] = static_cast<Kind>(pick(3));
      kind_[0] = held;
      kind_[1] = contact;
      std::vector<int> lines;
      for (int label = 0; label < labels_; ++label)
        if (kind_[label] == contact) lines.push_back(label);
      const Problem problem =
          loaded(body(mesh, material(power(-1, 5), number(-0.9, 0.499)), lines),
                 friction);
      if (!contact_dofs(problem.line, problem.system()).empty()) return problem;
    }
  }

 private:
  enum Kind { held, contact, free };

  double number(double low, double high) { return Uniform{low, high}(random_); }
  double power(double low, double high) {
    return std::pow(10, number(low, high));
  }
  int pick(int choices) { return static_cast<int>(random_() % choices); }
  bool chance(double p) { return number(0, 1) < p; }
  Vector2d vector(double size) {
    return size * Vector2d(number(-1, 1), number(-1, 1));
  }

  Mesh cells() {
    const int nx = 1 + pick(10), ny = 1 + pick(6);
    width_ = power(-1, 2);
    const double cell = width_ / nx, height = ny * cell * power(-0.5, 0.5);
    Mesh mesh = rectangle(nx, ny, width_, height);
    return chance(0.8) ? moved(mesh, std::min(cell, height / ny), 0.24, random_)
                       : mesh;
  }

  static std::map<std::pair<int, int>, std::vector<int>> sides(
      const Mesh& mesh, const std::vector<char>& kept) {
    std::map<std::pair<int, int>, std::vector<int>> sides;
    for (int t = 0; t < mesh.cell_count(); ++t)
      for (int k = 0; k < 3 && kept[t]; ++k)
        sides[std::minmax(mesh.cells(k, t), mesh.cells((k + 1) % 3, t))]
            .push_back(t);
    return sides;
  }

  /// Connected, and every boundary vertex on exactly two boundary edges: one loop.
  static bool is_one_loop(const Mesh& mesh, const std::vector<char>& kept) {
    const auto all = sides(mesh, kept);
    std::map<int, std::vector<int>> next;
    int count = 0;
    for (int t = 0; t < mesh.cell_count(); ++t)
      for (int k = 0; k < 3 && kept[t]; ++k) {
        const int a = mesh.cells(k, t), b = mesh.cells((k + 1) % 3, t);
        if (all.at(std::minmax(a, b)).size() == 1)
          next[a].push_back(b), ++count;
      }
    for (const auto& [v, after] : next)
      if (after.size() != 1) return false;
    if (next.empty()) return false;
    int v = next.begin()->first, steps = 0;
    do v = next[v][0], ++steps;
    while (v != next.begin()->first && steps <= count);
    return steps == count;
  }

  Mesh with(const Mesh& mesh, const std::vector<char>& kept) const {
    Mesh result;
    std::vector<int> number(mesh.vertex_count(), -1);
    std::vector<Vector2d> vertices;
    std::vector<Vector3i> triangles;
    for (int t = 0; t < mesh.cell_count(); ++t) {
      if (!kept[t]) continue;
      Vector3i corners;
      for (int k = 0; k < 3; ++k) {
        int& n = number[mesh.cells(k, t)];
        if (n < 0) {
          n = static_cast<int>(vertices.size());
          vertices.push_back(mesh.corner(t, k));
        }
        corners[k] = n;
      }
      triangles.push_back(corners);
    }
    result.vertices.resize(2, static_cast<Index>(vertices.size()));
    for (std::size_t v = 0; v < vertices.size(); ++v)
      result.vertices.col(v) = vertices[v];
    result.cells.resize(3, static_cast<Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      result.cells.col(t) = triangles[t];
    return result;
  }

  /// Without some triangles of its boundary.
  Mesh bitten(const Mesh& mesh) {
    std::vector<char> kept(mesh.cell_count(), 1);
    const int bites = pick(mesh.cell_count() / 2 + 1) * pick(2);
    for (int bite = 0; bite < bites; ++bite) {
      const int t = pick(mesh.cell_count());
      if (!kept[t]) continue;
      kept[t] = 0;
      if (!is_one_loop(mesh, kept)) kept[t] = 1;
    }
    return with(mesh, kept);
  }

  static double area(const Mesh& m, int a, int b, int c) {
    const Vector2d x = m.vertices.col(b) - m.vertices.col(a),
                   y = m.vertices.col(c) - m.vertices.col(a);
    return x.x() * y.y() - x.y() * y.x();
  }

  /// Some inner edges turned to the other diagonal of their two triangles.
  Mesh flipped(Mesh mesh) {
    for (int flips = pick(2) * pick(mesh.cell_count() + 1); flips > 0;
         --flips) {
      const auto all = sides(mesh, std::vector<char>(mesh.cell_count(), 1));
      auto side = all.begin();
      std::advance(side, pick(static_cast<int>(all.size())));
      if (side->second.size() != 2) continue;
      const int s = side->second[0], t = side->second[1];
      const auto apex = [&](int triangle) {
        for (int v : mesh.cells.col(triangle))
          if (v != side->first.first && v != side->first.second) return v;
        return -1;
      };
      int a = side->first.first, b = side->first.second;
      const int c = apex(s), d = apex(t);
      // c to the left of a b, d to the right
      if (area(mesh, a, b, c) < 0) std::swap(a, b);
      const double whole = area(mesh, a, b, c) + area(mesh, b, a, d);
      if (area(mesh, a, d, c) < 0.05 * whole ||
          area(mesh, d, b, c) < 0.05 * whole)
        continue;
      mesh.cells.col(s) << a, d, c;
      mesh.cells.col(t) << d, b, c;
    }
    return mesh;
  }

  /// The boundary in pieces of random length with labels 0, 1, ...; one label may come
  /// back.
  Mesh labelled(Mesh mesh) {
    std::map<int, int> next;
    const auto all = sides(mesh, std::vector<char>(mesh.cell_count(), 1));
    for (int t = 0; t < mesh.cell_count(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = mesh.cells(k, t), b = mesh.cells((k + 1) % 3, t);
        if (all.at(std::minmax(a, b)).size() == 1) next[a] = b;
      }
    const int edges = static_cast<int>(next.size());
    labels_ = std::min(edges, 2 + pick(5));
    mesh.boundary.resize(2, edges);
    mesh.boundary_label.resize(edges);
    std::set<int> cuts{0};
    while (static_cast<int>(cuts.size()) < labels_) cuts.insert(pick(edges));
    int v = next.begin()->first;
    for (int turn = pick(edges); turn > 0; --turn) v = next[v];
    int label = -1;
    for (int e = 0; e < edges; ++e, v = next[v]) {
      label += static_cast<int>(cuts.count(e));
      mesh.boundary.col(e) << v, next[v];
      mesh.boundary_label[e] = label;
    }
    return mesh;
  }

  Problem loaded(Problem problem, double friction) {
    const double E = problem.hooke[0](2, 2),
                 load = chance(0.25) ? 0 : E * power(-6, -1);
    std::set<int> in_contact(problem.line.vertex.begin(),
                             problem.line.vertex.end());
    std::vector<char> prescribed(2 * problem.mesh.vertex_count(), 0);
    const Vector2d motion =
        chance(0.5) ? vector(width_ * power(-6, -1)) : Vector2d(0, 0);
    const double turn = chance(0.3) ? number(-1, 1) * motion.norm() : 0;
    for (int label = 0; label < labels_; ++label) {
      if (kind_[label] == held && (label == 0 || chance(0.5)))
        hold(problem, label, label == 0 || chance(0.5) ? 3 : 1 + pick(2),
             motion, turn, in_contact, prescribed);
      else if (kind_[label] != contact && chance(0.7))
        add_traction(problem, label, vector(load));
    }
    if (chance(0.3)) add_body_force(problem, vector(load / width_));
    ContactLaw<2>& law = problem.law;
    law.multiplier = chance(0.5) ? Multiplier::force : Multiplier::pressure;
    const auto node_values = [&](double low, double high) {
      const bool constant = chance(0.5);
      VectorXd values = everywhere(problem.line, number(low, high));
      for (double& value : values)
        if (!constant) value = number(low, high);
      return values;
    };
    if (friction > 0) law.friction = node_values(0, friction);
    if (friction == 0 && chance(0.6))
      law.slip_bound = node_values(0, E * power(-6, -1));
    if (chance(0.4)) {
      const double size = width_ * power(-6, -1);
      law.gap = node_values(chance(0.5) ? 0 : -size, size);
      for (int i = 0; i < problem.line.node_count(); ++i) {
        const int v = problem.line.vertex[i];
        if (prescribed[2 * v] || prescribed[2 * v + 1])
          law.gap[i] = std::max(0.0, law.gap[i]);
      }
    }
    return problem;
  }

  /// Contact vertices are held where they are, so that contact is possible.
  void hold(Problem& problem, int label, int components, const Vector2d& motion,
            double turn, const std::set<int>& in_contact,
            std::vector<char>& prescribed) {
    for (Index e = 0; e < problem.mesh.boundary.cols(); ++e) {
      if (problem.mesh.boundary_label[e] != label) continue;
      for (int v : problem.mesh.boundary.col(e))
        for (int c = 0; c < 2; ++c) {
          if (!(components & (1 << c)) || prescribed[2 * v + c]) continue;
          const Vector2d x = problem.mesh.vertices.col(v) / width_;
          const double value = motion[c] + turn * (c == 0 ? -x.y() : x.x());
          prescribe_dof(problem, 2 * v + c, in_contact.count(v) ? 0 : value);
          prescribed[2 * v + c] = 1;
        }
    }
  }

  std::mt19937& random_;
  int labels_ = 0;
  double width_ = 1;
  std::array<Kind, 8> kind_{};
};

inline Problem odd_problem(std::mt19937& random, double friction) {
  return OddProblem(random)(friction);
}

}  // namespace ffcontact::test
