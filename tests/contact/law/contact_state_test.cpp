// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_state.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(ContactState, slip_sign_is_the_sign_of_the_motion_along_t) {
  EXPECT_EQ(slip_sign(ContactState::slip_forward), 1);
  EXPECT_EQ(slip_sign(ContactState::slip_backward), -1);
  EXPECT_EQ(slip_sign(ContactState::stick), 0);
  EXPECT_EQ(slip_sign(ContactState::open), 0);
}

}  // namespace
}  // namespace ffcontact
