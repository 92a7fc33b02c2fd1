// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/layer/layer_parts.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

/// With hats phi_k of a facet's d corners: int 1 = 1, int phi_k = 1/d, int phi_k^2 =
/// 2/(d (d + 1)), int phi_k phi_l = 1/(d (d + 1)).
template <int d>
void integrates_products_of_hats() {
  const CompliantLayer layer{2, 3};
  using Fields = Matrix<double, 2, d>;
  const Fields one = Fields::Ones();
  EXPECT_NEAR(layer_product(layer, one, one), 2 + 3, 1e-15);
  Fields first = Fields::Zero(), second = first, pressed = first;
  first(1, 0) = second(1, 1) = pressed(0, 0) = 1;
  EXPECT_NEAR(layer_product(layer, first, one), 3.0 / d, 1e-15);
  EXPECT_NEAR(layer_product(layer, first, first), 6.0 / (d * (d + 1)), 1e-15);
  EXPECT_NEAR(layer_product(layer, first, second), 3.0 / (d * (d + 1)), 1e-15);
  EXPECT_NEAR(layer_product(layer, pressed, pressed), 4.0 / (d * (d + 1)),
              1e-15);
  EXPECT_EQ(layer_product(layer, pressed, first), 0);
}

TEST(LayerParts, integrate_products_of_hats_on_edges_and_faces) {
  integrates_products_of_hats<2>();
  integrates_products_of_hats<3>();
}

}  // namespace
}  // namespace ffcontact
