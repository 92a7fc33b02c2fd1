// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/airy_reference.hpp"

#include <array>

#include "ffcontact/equilibrium/airy_function.hpp"

namespace ffcontact {

namespace {

Vector2d gradient_at(const ReferenceUnknowns& x, int vertex) {
  return x.segment<2>(3 * vertex + 1);
}

/// grad A in the middle of side k.
Vector2d gradient_in_middle(const ReferenceUnknowns& x, int k) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const Vector2d e = side_of(reference_triangle(), k);
  const double along = 1.5 * (x[3 * j] - x[3 * i]) -
                       0.25 * e.dot(gradient_at(x, i) + gradient_at(x, j));
  return (along * e + x[9 + k] * turned_right(e)) / e.squaredNorm();
}

/// Edge loads of an Airy function on the reference triangle.
EdgeLoads reference_loads(const ReferenceUnknowns& x) {
  EdgeLoads loads;
  for (int k = 0; k < 3; ++k)
    loads.segment<4>(4 * k) = moments_of_gradients(gradient_at(x, (k + 1) % 3),
                                                   gradient_in_middle(x, k),
                                                   gradient_at(x, (k + 2) % 3));
  return loads;
}

ReferenceStress solve_reference_airy() {
  ReferenceStress stress;
  for (int c = 0; c < 12; ++c) {
    const EdgeLoads loads = reference_loads(ReferenceUnknowns::Unit(c));
    stress.col(c) =
        composite_stress(reference_triangle(), loads, BodyLoads::Zero())
            .reshaped();
  }
  return stress;
}

/// Component q in the place of p, and p in that of q.
CompositeStress exchanged(const CompositeStress& stress, int p, int q) {
  CompositeStress dual = CompositeStress::Zero();
  dual.row(p) += stress.row(q);
  if (p != q) dual.row(q) += stress.row(p);
  return dual;
}

/// int s_p t_q + s_q t_p over the reference triangle of a stress s and each of the unknowns,
/// once where p = q.
Matrix<double, 12, 1> products_with(const CompositeStress& stress, int p,
                                    int q) {
  constexpr double area = 0.5;
  const CompositeStress dual = massed(exchanged(stress, p, q), area);
  return reference_stress().transpose() * dual.reshaped();
}

/// S_pq with x' S_pq x = int s_p s_q over the reference triangle for Voigt components p
/// <= q, the products p q and q p added up.
ReferenceEnergy reference_product(int p, int q) {
  ReferenceEnergy S;
  for (int c = 0; c < 12; ++c) {
    const Map<const CompositeStress> stress(reference_stress().col(c).data());
    S.col(c) = products_with(stress, p, q);
  }
  return S;
}

using ReferenceProducts = std::array<ReferenceEnergy, 6>;

/// In the order of the upper triangle, by rows.
const ReferenceProducts& reference_products() {
  static const ReferenceProducts products{
      reference_product(0, 0), reference_product(0, 1),
      reference_product(0, 2), reference_product(1, 1),
      reference_product(1, 2), reference_product(2, 2)};
  return products;
}

}  // namespace

const ReferenceStress& reference_stress() {
  static const ReferenceStress stress = solve_reference_airy();
  return stress;
}

ReferenceEnergy weighted_products(const Matrix3d& W) {
  const ReferenceProducts& S = reference_products();
  const double w[] = {W(0, 0), W(0, 1), W(0, 2), W(1, 1), W(1, 2), W(2, 2)};
  ReferenceEnergy sum;
  // numbers in place of Eigen's expressions, each of whose terms is a type of its own
  for (Index i = 0; i < sum.size(); ++i) {
    double entry = w[0] * S[0](i);
    for (int p = 1; p < 6; ++p) entry += w[p] * S[p](i);
    sum(i) = entry;
  }
  return sum;
}

CompositeStress massed(const CompositeStress& values, double area) {
  CompositeStress result;
  for (int k = 0; k < 9; k += 3) {
    const Vector3d sum = values.col(k) + values.col(k + 1) + values.col(k + 2);
    for (int a = k; a < k + 3; ++a)
      result.col(a) = area / 36 * (sum + values.col(a));
  }
  return result;
}

}  // namespace ffcontact
