// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/slip_forms.hpp"

#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/uniqueness/trace_stiffness.hpp"
#include "ffcontact/linear/iterative/krylov.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Added to S, relative to its diagonal.
constexpr double stabilisation = 1e-10;
/// What a motion without energy makes of the squared ratio is more than this.
constexpr double largest_square = 1e8;

Cholesky factor_of(const MatrixXd& S, const std::vector<int>& rows) {
  MatrixXd own = S(rows, rows);
  own.diagonal() *= 1 + stabilisation;
  return Cholesky(own);
}

/// The normal rows that move, in the trace stiffness.
struct NormalRows {
  std::vector<int> rows;
  std::vector<int> place;  ///< of each node in them, or -1

  explicit NormalRows(const TraceStiffness& traces, int dimension)
      : place(traces.place.size() / dimension, -1) {
    for (std::size_t node = 0; node < place.size(); ++node) {
      const int row = traces.place[dimension * static_cast<Index>(node)];
      if (row < 0) continue;
      place[node] = count_of(rows);
      rows.push_back(row);
    }
  }
};

}  // namespace

std::optional<SlipForms> SlipForms::of(const CondensedContact& contact,
                                       const MatrixXd& weight,
                                       const Flags& is_left_out) {
  const int dim = contact.dimension, tangents = dim - 1;
  const TraceStiffness traces = trace_stiffness(contact);
  const NormalRows normal(traces, dim);
  std::vector<int> rows = normal.rows;
  SlipForms forms;
  Triplets entries;
  for (int node = 0; node < weight.cols(); ++node)
    for (int c = 0; c < tangents; ++c) {
      const int row = dim * node + 1 + c, place = traces.place[row],
                own_normal = traces.place[dim * node];
      if (contact.held[row] || is_left_out[node]) continue;
      const bool moves_alone =
          place >= 0 && own_normal >= 0 && !traces.is_followed[own_normal];
      if (weight(c, node) != 0 && !moves_alone) return std::nullopt;
      if (place < 0) continue;
      if (weight(c, node) != 0)
        entries.emplace_back(normal.place[node], count_of(forms.row_),
                             weight(c, node));
      forms.row_.push_back(tangents * node + c);
      rows.push_back(place);
    }
  forms.weight_ = packed(count_of(normal.rows), count_of(forms.row_), entries);
  forms.factor_ = factor_of(traces.S, rows);
  return forms;
}

double SlipForms::largest_ratio() const {
  if (!factor_.is_positive_definite()) return infinity;
  const Index n = weight_.rows(), t = weight_.cols();
  const auto L_nn =
      factor_.lower().topLeftCorner(n, n).triangularView<Eigen::Lower>();
  const auto L_tt =
      factor_.lower().bottomRightCorner(t, t).triangularView<Eigen::Lower>();
  const auto square = [&](const VectorXd& x) {
    const VectorXd v_n = weight_ * VectorXd(L_tt.transpose().solve(x)),
                   forces = L_nn * VectorXd(L_nn.transpose() * v_n);
    return VectorXd(L_tt.solve(VectorXd(weight_.transpose() * forces)));
  };
  const double largest = largest_eigenvalue(square, t);
  return largest < largest_square ? std::sqrt(largest) : infinity;
}

double SlipForms::dual_norm(const MatrixXd& moments) const {
  if (!factor_.is_positive_definite()) return infinity;
  const Index t = weight_.cols();
  const VectorXd b = moments.reshaped()(row_);
  return VectorXd(factor_.lower()
                      .bottomRightCorner(t, t)
                      .triangularView<Eigen::Lower>()
                      .solve(b))
      .norm();
}

}  // namespace ffcontact
