// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact::test {

constexpr double pi = 3.14159265358979323846;

}  // namespace ffcontact::test
