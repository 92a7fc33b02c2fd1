// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures/picture_folder.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <system_error>
#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"

namespace ffcontact::plugin {

namespace {

namespace fs = std::filesystem;

bool is_one_of(const std::string& word,
               std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Is this what picture_file would make of a name, a step and one of its letters?
bool is_picture(const std::string& name, const std::string& letter,
                const std::string& extension) {
  if (is_one_of(name, {"contact", "tractions"}))
    return letter.empty() && extension == ".txt";
  const bool of_body =
      letter.empty() || (letter.size() == 1 && letter >= "a" && letter <= "z");
  return of_body && is_one_of(name, {"step", "stress", "surface"}) &&
         is_one_of(extension, {".vtu", ".msh"});
}

/// Is this a file of the step or of a later one?
bool is_of_step(const fs::path& file, long step) {
  constexpr auto digits = "0123456789";
  const std::string stem = file.stem().string(),
                    extension = file.extension().string();
  const std::size_t start = std::min(stem.find_first_of(digits), stem.size()),
                    end = std::min(stem.find_first_not_of(digits, start),
                                   stem.size());
  const std::optional<int> number =
      whole_number(stem.substr(start, end - start));
  return is_picture(stem.substr(0, start), stem.substr(end), extension) &&
         number && *number >= step;
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
    if (is_of_step(entry.path(), step)) old.push_back(entry.path());
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
