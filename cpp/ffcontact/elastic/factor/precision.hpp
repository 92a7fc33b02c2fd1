// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact {

/// What a factor is computed and kept in.
enum class Precision { full, single };

}  // namespace ffcontact
