// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/matrix_free/product_equations.hpp"

namespace ffcontact {

namespace {

double sum_of(const Equation& equation, const ContactRows& rows) {
  double sum = 0;
  for (const Term& term : equation.terms)
    sum += term.P * rows.P[term.row] + term.v * rows.v[term.row];
  return sum;
}

}  // namespace

ProductEquations::ProductEquations(const ProductRelation& of_relation,
                                   const SurfaceEquations& of_law)
    : relation(of_relation), law(of_law) {
  const VectorXd R =
      relation.blocks.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Index f = count_of(relation.primary);
  std::vector<double> units, scales;
  for (int k = 0; k < relation.size(); ++k) {
    const int row = relation.row(k);
    if (k < f && law.is_fixed(row)) continue;
    unknown.push_back(k);
    equation.push_back(k < f ? law.equation(row) : Equation{{{row, 1, 0}}, 0});
    units.push_back(R[k]);
    scales.push_back(R[k]);
  }
  for (int d = 0; d < count_of(relation.dependent); ++d) {
    const int row = relation.dependent[d];
    if (law.is_held(row)) continue;
    dependent.push_back(d);
    equation.push_back(law.equation(row));
    double square = 0;
    for (SparseMatrix::InnerIterator e(relation.E, d); e; ++e)
      square += std::pow(e.value() * R[e.row()], 2);
    const double unit = 1 / (square > 0 ? std::sqrt(square) : R.mean());
    units.push_back(unit);
    scales.push_back(law.is_fixed(row) ? unit : 1 / unit);
  }
  unit = packed(units);
  scale = packed(scales);
}

VectorXd ProductEquations::residual(const ContactRows& at) const {
  return VectorXd::NullaryExpr(size(), [&](Index e) {
    return scale[e] * (equation[e].value - sum_of(equation[e], at));
  });
}

ContactRows ProductEquations::increment(const VectorXd& scaled) const {
  const VectorXd values = unit.cwiseProduct(scaled);
  const Index n = count_of(unknown);
  VectorXd x = VectorXd::Zero(relation.size()),
           q = VectorXd::Zero(relation.E.cols());
  x(unknown) = values.head(n);
  q(dependent) = values.tail(count_of(dependent));
  return change_of_rows(relation, x, q);
}

VectorXd ProductEquations::sums(const ContactRows& rows) const {
  return VectorXd::NullaryExpr(
      size(), [&](Index e) { return scale[e] * sum_of(equation[e], rows); });
}

VectorXd ProductEquations::product(const VectorXd& scaled) const {
  VectorXd sums = this->sums(increment(scaled));
  const Index d = count_of(dependent);
  sums.tail(d) += proximal_share * scaled.tail(d);
  return sums;
}

}  // namespace ffcontact
