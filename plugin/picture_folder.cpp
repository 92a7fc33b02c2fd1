// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_folder.hpp"

#include <regex>
#include <system_error>
#include <vector>

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

namespace fs = std::filesystem;

/// Is this a file of the step or of a later one?
bool is_of_step(const std::string& name, long step) {
  static const std::regex pattern(
      R"((?:(?:contact|tractions)(\d{1,9})\.txt)|(?:(?:step|stress|surface)(\d{1,9})[a-z]?\.(?:vtu|msh)))");
  std::smatch match;
  if (!std::regex_match(name, match, pattern)) return false;
  return std::stol(match[match[1].matched ? 1 : 2]) >= step;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    refuse("the folder ", folder.string(),
           " cannot be made: ", error.message());
}

void remove_later_steps(const fs::path& folder, long step) try {
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_of_step(entry.path().filename().string(), step))
      old.push_back(entry.path());
  for (const fs::path& file : old) fs::remove(file);
} catch (const fs::filesystem_error& error) {
  refuse("old files in the folder ", folder.string(),
         " cannot be removed: ", error.code().message());
}

}  // namespace

std::string picture_file(const char* name, long step, int body,
                         const char* extension) {
  const std::string letter =
      body > 0 ? std::string(1, static_cast<char>('a' + body)) : "";
  return name + std::to_string(step) + letter + extension;
}

void make_picture_folder(const fs::path& folder, long step) {
  make_folder(folder);
  remove_later_steps(folder, step);
}

}  // namespace ffcontact::plugin
