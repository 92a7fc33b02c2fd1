// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/facing_star.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// What is left at the root below this part of the wrenches is rounding.
constexpr double root_rounding = 1e-11;
/// Conditions on x that depend on others but for this part.
constexpr PivotThreshold dependent_rows{1e-9};

/// The wrenches and modes of facets by x.
template <int d>
using ByUnknowns = std::map<int, Matrix<double, d * d, Dynamic>>;

/// A facet that is faced, and the ridge to the one nearer to the root; -1 at the root.
struct Branch {
  int facet, parent, ridge;
};

/// From the root on, parents before what hangs on them; empty where not all hang together.
template <int d>
std::vector<Branch> tree_of(const FacetTopology<d>& topology,
                            std::set<int> facets, int root) {
  std::vector<Branch> tree{{root, -1, -1}};
  facets.erase(root);
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const int from = tree[k].facet;
    for (const int ridge : topology.ridges.of_facet.col(from))
      for (const int to : topology.ridges.facets_of(ridge))
        if (facets.erase(to) > 0) tree.push_back({to, from, ridge});
  }
  if (!facets.empty()) tree.clear();
  return tree;
}

template <int d>
class FacingStarBuilder {
 public:
  using Element = CompositeElement<d>;
  static constexpr int wrench = Element::wrench, modes = Element::modes;

  FacingStarBuilder(const FacetTopology<d>& topology,
                    const std::vector<ContactFacet<d>>& contact)
      : topology_(topology), contact_(contact) {}

  /// @param own  places of the contact facets around the ridge
  std::optional<FacingStar<d>> star(int ridge, const std::vector<int>& own) {
    columns_.clear();
    by_x_.clear();
    rows_.clear();
    put_own(ridge, own);
    if (!put_opposite()) return std::nullopt;
    return reduced();
  }

 private:
  FacetMatrix<d> basis(int facet) const {
    return wrench_basis<d>(topology_.facet_corners(facet));
  }
  auto& column(int facet) {
    Matrix<double, d * d, Dynamic> none = MatrixXd::Zero(d * d, unknowns_);
    return columns_.emplace(facet, std::move(none)).first->second;
  }

  /// The facets around the ridge, and R.
  void put_own(int ridge, const std::vector<int>& own) {
    const bool is_carried = own.size() == 2;  // w, from one to the other
    unknowns_ = modes * count_of(own) + (is_carried ? wrench : 0);
    for (const int facet : topology_.ridges.facets_of(ridge))
      if (is_carried)
        column(facet).template topLeftCorner<wrench, wrench>() =
            wrench_shift<d>(topology_, facet, ridge).matrix();
    int next = is_carried ? wrench : 0;
    for (const int m : own) {
      const ContactFacet<d>& facet = contact_[m];
      column(facet.facet)
          .template block<modes, modes>(wrench, next)
          .setIdentity();
      next += modes;
      const MatrixXd R = tractions_of_columns<d>(
          facet, basis(facet.facet) * column(facet.facet));
      by_x_.emplace_back(m, R);
      keep_law(facet, R);
    }
  }

  /// r_t stays where friction may vanish, as a moment.
  void keep_law(const ContactFacet<d>& facet, const MatrixXd& R) {
    for (int i = 0; i < d; ++i)
      if (facet.cone[i].frictionless())
        rows_.emplace_back(facet.measure / (d * (d + 1)) *
                           R.template middleRows<d - 1>(d * i + 1));
  }

  /// @return whether what is faced hangs together
  bool put_opposite() {
    ByUnknowns<d> carried;
    for (const auto& [m, R] : by_x_)
      for (const FacingPart<d>& part : contact_[m].facing) {
        auto& moments =
            carried.emplace(part.facet, MatrixXd::Zero(d * d, unknowns_))
                .first->second;
        moments += part.moments * R;
      }
    std::set<int> facets;
    int root = -1;
    double largest = -1;
    for (auto& [facet, moments] : carried) {
      facets.insert(facet);
      if (moments.norm() > largest) {
        root = facet;
        largest = moments.norm();
      }
      moments = basis(facet).partialPivLu().solve(moments).eval();
    }
    const std::vector<Branch> tree = tree_of<d>(topology_, facets, root);
    if (tree.empty()) return false;
    for (const auto& [facet, unknowns] : carried)
      column(facet).template bottomRows<modes>() =
          unknowns.template bottomRows<modes>();
    pass_down(tree, carried);
    return true;
  }

  /// Wrenches from the leaves to the root, through the ridges between them.
  void pass_down(const std::vector<Branch>& tree, ByUnknowns<d> carried) {
    double scale =
        0;  // of the modes as well: a face within another one has them alone
    for (const auto& [facet, unknowns] : carried)
      scale = std::max(scale, max_norm(unknowns));
    for (auto branch = tree.rbegin(); branch != tree.rend(); ++branch) {
      const MatrixXd w = carried[branch->facet].template topRows<wrench>();
      if (branch->ridge < 0) {
        const double left = max_norm(w);
        if (left > root_rounding * scale) rows_.emplace_back(w * scale / left);
        return;
      }
      const MatrixXd of_ridge =
          wrench_shift<d>(topology_, branch->facet, branch->ridge)
              .matrix()
              .partialPivLu()
              .solve(w);
      for (const int facet : topology_.ridges.facets_of(branch->ridge)) {
        const MatrixXd through =
            wrench_shift<d>(topology_, facet, branch->ridge).matrix() *
            of_ridge;
        column(facet).template topRows<wrench>() += through;
        if (facet == branch->parent)
          carried[facet].template topRows<wrench>() -= through;
      }
    }
  }

  /// By those x that all conditions leave.
  std::optional<FacingStar<d>> reduced() const {
    MatrixXd basis = MatrixXd::Identity(unknowns_, unknowns_);
    if (!rows_.empty()) {
      MatrixXd rows(0, unknowns_);
      for (const MatrixXd& more : rows_) {
        rows.conservativeResize(rows.rows() + more.rows(), Eigen::NoChange);
        rows.bottomRows(more.rows()) = more;
      }
      basis = kernel_basis(rows, dependent_rows);
    }
    if (basis.cols() == 0) return std::nullopt;
    FacingStar<d> star;
    for (const auto& [m, R] : by_x_) {
      star.contact.push_back(m);
      star.tractions.push_back(R * basis);
    }
    star.columns.Z.resize(d * d * count_of(columns_), basis.cols());
    for (const auto& [facet, by_x] : columns_) {
      star.columns.Z.template middleRows<d * d>(
          d * d * count_of(star.columns.facet)) = by_x * basis;
      star.columns.facet.push_back(facet);
    }
    return star;
  }

  const FacetTopology<d>& topology_;
  const std::vector<ContactFacet<d>>& contact_;
  Index unknowns_ = 0;                          ///< in x
  ByUnknowns<d> columns_;                       ///< of all facets of the star
  std::vector<std::pair<int, MatrixXd>> by_x_;  ///< R of the contact facets
  std::vector<MatrixXd> rows_;                  ///< conditions on x
};

}  // namespace

template <int d>
std::vector<FacingStar<d>> facing_stars(
    const FacetTopology<d>& topology,
    const std::vector<ContactFacet<d>>& contact) {
  std::map<int, std::vector<int>> around;  // of each ridge
  std::vector<int> ridges;
  for (int m = 0; m < count_of(contact); ++m)
    for (int k = 0; k < d && !contact[m].facing.empty(); ++k) {
      const int ridge = topology.ridges.of_facet(k, contact[m].facet);
      if (around[ridge].empty()) ridges.push_back(ridge);
      around[ridge].push_back(m);
    }
  FacingStarBuilder<d> builder(topology, contact);
  std::vector<FacingStar<d>> stars;
  for (const int ridge : ridges)
    if (auto star = builder.star(ridge, around[ridge]))
      stars.push_back(*std::move(star));
  return stars;
}

template std::vector<FacingStar<FFCONTACT_DIMENSION>> facing_stars(
    const FacetTopology<FFCONTACT_DIMENSION>&,
    const std::vector<ContactFacet<FFCONTACT_DIMENSION>>&);

}  // namespace ffcontact
