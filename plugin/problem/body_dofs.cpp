// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/body_dofs.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact::plugin {

void BodyDofs::require_dofs(const char* name, int body, Index count) const {
  if (count != dof_count(body))
    refuse(name, " has size ", count, " but ", space_in_words(dimension_),
           " has ", dof_count(body), " dofs on this mesh");
}

void BodyDofs::require_bodies(const char* names, std::size_t count) const {
  if (static_cast<int>(count) != body_count())
    refuse(names, " are given for ", count, " bodies, but the contact has ",
           body_count());
}

}  // namespace ffcontact::plugin
