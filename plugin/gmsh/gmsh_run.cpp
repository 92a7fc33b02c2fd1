// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/gmsh_run.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <system_error>

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

using std::filesystem::path;

std::string quoted_for_shell(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) c == '\'' ? quoted += "'\\''" : quoted += c;
  return quoted + "'";
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const path parent = std::filesystem::temp_directory_path(error);
  if (error)
    refuse("the folder of temporary files (TMPDIR) cannot be used: ",
           error.message());
  std::string name = (parent / "ffcontact.XXXXXX").string();
  if (!mkdtemp(name.data()))
    refuse("no temporary folder can be made in ", parent);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string first_line(const path& file) {
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line))
    if (!line.empty() && line.find("---") == std::string::npos) return line;
  return {};
}

void run_gmsh(const std::string& dimension, const path& input,
              const path& output, const std::string& what, const path& log,
              const std::string& otherwise) {
  constexpr int shell_found_nothing = 127;
  const std::string command =
      "gmsh " + dimension + " -v 1 " + quoted_for_shell(input.string()) +
      " -setnumber Mesh.Binary 0 -format msh22 -o " +
      quoted_for_shell(output.string()) + " </dev/null >" +
      quoted_for_shell(log.string()) + " 2>&1";
  const int status = std::system(command.c_str());
  if (WIFEXITED(status) && WEXITSTATUS(status) == shell_found_nothing)
    refuse(
        "the program gmsh was not found; install it (Debian: apt-get install "
        "gmsh) or add its folder to PATH",
        otherwise);
  if (status != 0 || !std::filesystem::exists(output))
    refuse("gmsh could not use ", what, ": ", first_line(log));
}

}  // namespace ffcontact::plugin
