// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <ffcontact/ffcontact.hpp>
#include <iostream>

/// Links the whole core: the solver is reached, and refuses a body without triangles.
int main() {
  try {
    ffcontact::solve_contact({}, {}, {}, {});
  } catch (const std::exception& error) {
    std::cout << "refused: " << error.what() << '\n';
    return 0;
  }
  return 1;
}
