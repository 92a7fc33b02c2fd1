// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// Name with the number of the step and the letter of the body: none, b, c, ...
std::string picture_file(const char* name, long step, int body,
                         const char* extension = ".vtu");

/// Makes a folder if it is missing, and removes what an earlier run left of this and of
/// later steps, so that its last steps are not taken for these.
/// @throws std::invalid_argument  if that fails
void make_picture_folder(const std::filesystem::path& folder, long step);

/// A nodal value, or another one where none are given.
inline double value_or(const VectorXd& values, Index i, double otherwise) {
  return values.size() > 0 ? values[i] : otherwise;
}

}  // namespace ffcontact::plugin
