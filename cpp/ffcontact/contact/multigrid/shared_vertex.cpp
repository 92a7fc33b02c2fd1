// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/shared_vertex.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// What is left of a normal, the earlier ones apart, where it is no combination of them.
constexpr double independent = 0.3;

/// Rows from which the others follow, one after the other, and what is left of all of them.
class IndependentRows {
 public:
  explicit IndependentRows(MatrixXd left) : left_(std::move(left)) {}

  bool lack() const { return count_of(found_) < left_.cols(); }
  bool has(Index i) const {
    return std::find(found_.begin(), found_.end(), i) != found_.end();
  }
  double left(Index i) const { return left_.row(i).norm(); }
  Index most() const {
    Index row = 0;
    left_.rowwise().norm().maxCoeff(&row);
    return row;
  }
  void take(Index i) {
    const VectorXd unit = left_.row(i).normalized();
    left_ -= left_ * unit * unit.transpose();
    found_.push_back(i);
  }

 private:
  MatrixXd left_;
  std::vector<Index> found_;
};

void take_normals(const std::vector<int>& rows, IndependentRows& own) {
  for (int i = 0; i < count_of(rows); ++i)
    if (rows[i] % 3 == 0 && own.lack() && own.left(i) > independent)
      own.take(i);
}

/// As many as columns: normal ones first, then those of which most is left.
IndependentRows own_rows(const MatrixXd& A, const std::vector<int>& rows) {
  IndependentRows own(A);
  take_normals(rows, own);
  while (own.lack()) own.take(own.most());
  return own;
}

/// The same rows, some of them first.
template <class IsFirst>
void put_first(const IsFirst& is_first, std::vector<int>& rows) {
  std::vector<int> first, others;
  for (int i = 0; i < count_of(rows); ++i)
    (is_first(i) ? first : others).push_back(rows[i]);
  first.insert(first.end(), others.begin(), others.end());
  rows = std::move(first);
}

Matrix3d padded(const MatrixXd& M) {
  Matrix3d result = Matrix3d::Zero();
  result.topLeftCorner(M.rows(), M.cols()) = M;
  return result;
}

/// How the components of the trace move the rows of a vertex:
///     v = A w + sum_j A_j u_j,   u = D w.
struct Motions {
  MatrixXd A;
  std::map<int, SharedVertex::Rows3> faced;  ///< A_j
  Matrix<double, 3, Dynamic> D;
};

/// w = A_own^-1 (y - sum_j A_own,j u_j), A_own^-1 of the first rows.
MatrixXd inverse_of_own(const Motions& motions) {
  const Index own = motions.A.cols();
  if (own == 0) return MatrixXd(0, 0);
  return motions.A.topRows(own).inverse();
}

void put_frame(const Motions& motions, SharedVertex& shared) {
  shared.T = padded(motions.D * inverse_of_own(motions));
  for (const auto& [j, A] : motions.faced)
    shared.B.push_back(padded(-A.topRows(shared.own)));
}

MatrixXd without_rounding(const MatrixXd& E) {
  constexpr double rounding = 1e-12;
  return E.unaryExpr([](double e) { return std::abs(e) > rounding ? e : 0; });
}

/// E = A A_own^-1, E_j = A_j - E A_own,j
void put_rows(const Motions& motions, SharedVertex& shared) {
  const MatrixXd E = motions.A * inverse_of_own(motions);
  shared.E.setZero(motions.A.rows(), 3);
  shared.E.leftCols(shared.own) = E;
  shared.faced.clear();
  for (const auto& [j, A] : motions.faced)
    shared.faced.push_back(
        {j, without_rounding(A - E * A.topRows(shared.own))});
}

bool couples(const SharedVertex& shared, int row) {
  return std::any_of(shared.faced.begin(), shared.faced.end(),
                     [&](const SharedVertex::Link& link) {
                       return !link.E.row(row).isZero(0);
                     });
}

class Builder {
 public:
  Builder(const ContactSurface& surface, const SurfaceTrace& trace,
          const VectorXd& compliance, const ElasticSystem& system)
      : surface_(surface),
        trace_(trace),
        compliance_(compliance),
        A_(trace.trace.A),
        K_(system.stiffness.diagonal()),
        vertex_(A_.cols(), -1),
        direction_(Matrix3Xd::Zero(3, A_.cols())) {
    for (Index k = 0; k < A_.cols(); ++k) put_component(k);
    for (Index dof = 0; dof < K_.size(); ++dof)
      if (system.prescribed[dof]) K_[dof] = 0;
  }

  std::vector<SharedVertex> vertices() const {
    std::map<int, std::vector<int>> components = components_of_vertices();
    std::vector<SharedVertex> shared;
    for (const auto& [v, rows] : rows_of_vertices())
      if (rows.size() > components[v].size())
        shared.push_back(vertex(v, rows, components[v]));
    return shared;
  }

 private:
  void put_component(Index k) {
    const ContactTrace& moved = trace_.trace;
    for (SparseMatrix::InnerIterator e(moved.to_kept, k); e; ++e) {
      const int dof = moved.kept_dofs[e.row()];
      vertex_[k] = dof / 3;
      direction_(dof % 3, k) = e.value();
    }
  }

  std::map<int, std::vector<int>> components_of_vertices() const {
    std::map<int, std::vector<int>> components;
    for (int k = 0; k < count_of(trace_.primary); ++k)
      components[vertex_[k]].push_back(k);
    return components;
  }

  std::map<int, std::vector<int>> rows_of_vertices() const {
    std::map<int, std::vector<int>> rows;
    for (int row = 0; row < count_of(trace_.held); ++row)
      if (!trace_.held[row]) rows[surface_.vertex[row / 3]].push_back(row);
    return rows;
  }

  SharedVertex vertex(int v, const std::vector<int>& rows,
                      const std::vector<int>& components) const {
    SharedVertex shared;
    shared.vertex = v;
    shared.own = count_of(components);
    shared.rows = rows;
    order_rows(components, shared);
    const Motions all = motions(shared.rows, components);
    put_rows(all, shared);
    put_frame(all, shared);
    shared.stiffness = stiffness(shared);
    shared.layer = compliance_(shared.rows);
    return shared;
  }

  /// Its own ones first, those that couple last.
  void order_rows(const std::vector<int>& components,
                  SharedVertex& shared) const {
    std::vector<int>& rows = shared.rows;
    const IndependentRows own = own_rows(motions(rows, components).A, rows);
    put_first([&](int i) { return own.has(i); }, rows);
    put_rows(motions(rows, components), shared);
    for (int i = 0; i < count_of(rows); ++i)
      if (couples(shared, i)) ++shared.coupling;
    put_first([&](int i) { return !couples(shared, i); }, rows);
  }

  Motions motions(const std::vector<int>& rows,
                  const std::vector<int>& components) const {
    Motions result;
    result.A = MatrixXd::Zero(count_of(rows), count_of(components));
    result.D = direction_(Eigen::all, components);
    for (int i = 0; i < count_of(rows); ++i)
      for (RowMatrix::InnerIterator e(A_, rows[i]); e; ++e) {
        const auto own =
            std::find(components.begin(), components.end(), e.col());
        if (own != components.end())
          result.A(i, own - components.begin()) = e.value();
        else
          add_faced(i, static_cast<int>(e.col()), e.value(), result);
      }
    return result;
  }

  void add_faced(int i, int component, double value, Motions& motions) const {
    const int j = vertex_[component];
    if (j < 0) return;
    const SharedVertex::Rows3 none =
        SharedVertex::Rows3::Zero(motions.A.rows(), 3);
    SharedVertex::Rows3& A_j = motions.faced.try_emplace(j, none).first->second;
    A_j.row(i) += value * direction_.col(component).transpose();
  }

  /// E K E' / |E|^4, so that a spring of it along v is to E as K.
  VectorXd stiffness(const SharedVertex& shared) const {
    VectorXd size = VectorXd::Zero(shared.row_count()), sum = size;
    const auto add = [&](int v, const SharedVertex::Rows3& E) {
      const VectorXd square = E.rowwise().squaredNorm();
      size += square;
      sum += SharedVertex::at(v, K_).maxCoeff() * square;
    };
    add(shared.vertex, shared.E);
    for (const auto& link : shared.faced) add(link.vertex, link.E);
    return sum.cwiseQuotient(size.cwiseAbs2());
  }

  const ContactSurface& surface_;
  const SurfaceTrace& trace_;
  const VectorXd& compliance_;
  RowMatrix A_;
  VectorXd K_;               ///< of free dofs, on the diagonal
  std::vector<int> vertex_;  ///< of each component, -1: of a layer
  Matrix3Xd direction_;      ///< of each component
};

}  // namespace

std::vector<SharedVertex> shared_vertices(const ContactSurface& surface,
                                          const SurfaceTrace& trace,
                                          const VectorXd& compliance,
                                          const ElasticSystem& system) {
  return Builder(surface, trace, compliance, system).vertices();
}

}  // namespace ffcontact
