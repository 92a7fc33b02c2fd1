// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace ffcontact::plugin {

/// A folder of our own for what goes to gmsh and comes back; it lives as long as the
/// call.
class TemporaryFolder {
 public:
  /// @throws std::invalid_argument  if it cannot be made
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const char* name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// The first line of a file that is neither empty nor a rule of dashes.
std::string first_line(const std::filesystem::path& file);

/// Runs gmsh on `input`; its mesh (MSH 2.2, text) goes to `output`, what it says of
/// errors to `log`.
/// @param dimension  "-0" to "-3"
/// @param what       what the user calls the input
/// @param otherwise  what else the user can do without gmsh, or nothing
/// @throws std::invalid_argument  if gmsh is missing, or makes no mesh
void run_gmsh(const std::string& dimension, const std::filesystem::path& input,
              const std::filesystem::path& output, const std::string& what,
              const std::filesystem::path& log,
              const std::string& otherwise = {});

}  // namespace ffcontact::plugin
