// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Several lines one after the other as one.
ContactLine joined_lines(const std::vector<ContactLine>& lines);

}  // namespace ffcontact
