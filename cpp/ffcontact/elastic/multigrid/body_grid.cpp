// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/body_grid.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Calls visit(w) for the vertices w whose dofs have an entry in the rows of a vertex, as
/// often as they have one.
template <int dim, class Visit>
void visit_neighbours(const RowMatrix& K, int v, const Visit& visit) {
  for (int c = 0; c < dim; ++c)
    for (RowMatrix::InnerIterator e(K, dof_of<dim>(v, c)); e; ++e)
      visit(static_cast<int>(e.col()) / dim);
}

/// Calls visit(i, F) for the rows of K that the row of y_v adds up, by F T_i'.
template <int dim, class Visit>
void visit_rows(const VertexFrames<dim>& frames, int v, const Visit& visit) {
  visit(v, MatrixOf<dim>(MatrixOf<dim>::Identity()));
  for (const auto& follower : frames.followers_of(v))
    visit(follower.vertex, MatrixOf<dim>(follower.B.transpose()));
}

template <int dim>
BlockPattern vertex_pattern(const RowMatrix& K,
                            const VertexFrames<dim>& frames) {
  const auto vertices = static_cast<int>(K.rows() / dim);
  BlockPattern pattern;
  NodeList seen(vertices, -1);
  for (int v = 0; v < vertices; ++v) {
    const auto see = [&](int w) {
      if (seen[w] == v) return;
      seen[w] = v;
      pattern.column.push_back(w);
    };
    see(v);
    visit_rows(frames, v, [&](int i, const MatrixOf<dim>&) {
      visit_neighbours<dim>(K, i, [&](int w) {
        see(w);
        for (const auto& link : frames.followed_by(w)) see(link.vertex);
      });
    });
    std::sort(pattern.column.begin() + pattern.first.back(),
              pattern.column.end());
    pattern.first.push_back(count_of(pattern.column));
  }
  pattern.column.shrink_to_fit();
  return pattern;
}

/// Rows of the stiffness of y, one after the other.
template <int dim>
class RowBuilder {
 public:
  RowBuilder(const RowMatrix& K, const VertexFrames<dim>& frames)
      : K_(K), frames_(frames), place_(K.rows() / dim, -1) {}

  void put(int v, BlockRows<dim, dim>& A) {
    const int begin = A.pattern.begin(v), end = A.pattern.end(v);
    sum_.assign(end - begin, MatrixOf<dim>::Zero());
    visit_rows(frames_, v, [&](int i, const MatrixOf<dim>& F) {
      read(i);
      for (int k = begin; k < end; ++k) place_[A.pattern.column[k]] = k - begin;
      add(F * frames_.of(i).transpose());
    });
    for (int k = begin; k < end; ++k)
      A.value[k] = sum_[k - begin].template cast<float>();
  }

 private:
  /// K_iw
  struct Entry {
    int vertex;
    MatrixOf<dim> K;
  };

  void read(int i) {
    entries_.clear();
    visit_neighbours<dim>(K_, i, [&](int w) { place_[w] = -1; });
    for (int c = 0; c < dim; ++c)
      for (RowMatrix::InnerIterator e(K_, dof_of<dim>(i, c)); e; ++e) {
        const int w = static_cast<int>(e.col()) / dim;
        if (place_[w] < 0) {
          place_[w] = count_of(entries_);
          entries_.push_back({w, MatrixOf<dim>::Zero()});
        }
        entries_[place_[w]].K(c, e.col() % dim) = e.value();
      }
  }

  /// F T_i' K_iw T_w to column w and to those that w follows.
  void add(const MatrixOf<dim>& FT) {
    for (const Entry& entry : entries_) {
      const MatrixOf<dim> own = FT * entry.K * frames_.of(entry.vertex);
      sum_[place_[entry.vertex]] += own;
      for (const auto& link : frames_.followed_by(entry.vertex))
        sum_[place_[link.vertex]] += own * link.B;
    }
  }

  const RowMatrix& K_;
  const VertexFrames<dim>& frames_;
  NodeList place_;
  std::vector<Entry> entries_;
  std::vector<MatrixOf<dim>> sum_;
};

/// The body of each vertex, by what its rows of K have entries for.
template <int dim>
NodeList bodies(const RowMatrix& K) {
  NodeList body(K.rows() / dim, -1), last;
  int count = 0;
  for (int v = 0; v < count_of(body); ++v) {
    const auto reach = [&](int w) {
      if (body[w] >= 0) return;
      body[w] = count;
      last.push_back(w);
    };
    reach(v);
    while (!last.empty()) {
      const int next = last.back();
      last.pop_back();
      visit_neighbours<dim>(K, next, reach);
    }
    if (body[v] == count) ++count;
  }
  return body;
}

/// Bodies, and of each what follows others.
template <int dim>
NodeList parts(const RowMatrix& K, const VertexFrames<dim>& frames) {
  if (!frames.has_followers()) return NodeList(K.rows() / dim, 0);
  NodeList part = bodies<dim>(K);
  for (int v = 0; v < count_of(part); ++v)
    part[v] = 2 * part[v] + (frames.followed_by(v).empty() ? 0 : 1);
  return part;
}

}  // namespace

template <int dim>
SingleBlock<dim, NodeMotions<dim, dim>::count> motions_along(
    const MatrixOf<dim>& T) {
  auto motions = NodeMotions<dim, dim>().motions;
  MatrixOf<dim> G = T.transpose() * T;
  for (int c = 0; c < dim; ++c)
    if (G(c, c) == 0) G(c, c) = 1;
  motions.template leftCols<dim>() =
      (G.inverse() * T.transpose()).template cast<float>();
  return motions;
}

template <int dim>
Grid<dim, dim> body_grid(const ElasticSystem& system,
                         const Matrix<double, dim, Dynamic>& vertices,
                         const VertexFrames<dim>& frames) {
  Grid<dim, dim> grid;
  grid.A.pattern = vertex_pattern<dim>(system.stiffness, frames);
  grid.A.value.resize(grid.A.pattern.column.size());
  grid.part = parts(system.stiffness, frames);
  const int count = grid.A.rows();
  grid.motions.resize(count);
#pragma omp parallel
  {
    RowBuilder<dim> builder(system.stiffness, frames);
#pragma omp for
    for (int v = 0; v < count; ++v) {
      builder.put(v, grid.A);
      grid.motions[v].centre = vertices.col(v);
      grid.motions[v].motions = motions_along<dim>(frames.of(v));
    }
  }
  return grid;
}

template Grid<3, 3> body_grid(const ElasticSystem&, const Matrix3Xd&,
                              const VertexFrames<3>&);
template SingleBlock<3, 6> motions_along<3>(const Matrix3d&);

}  // namespace ffcontact
