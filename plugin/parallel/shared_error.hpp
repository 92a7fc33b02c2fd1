// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "estimate/contact_error.hpp"
#include "parallel/shared_contact.hpp"
#include "problem/contact_type.hpp"

/// Estimates and sizes where processes share the bodies: each reads its part of the data,
/// process 0 does the rest.
namespace ffcontact::plugin {

/// contacterror.
/// @param read   what the script says of a process's bodies
/// @param judge  the estimate of the whole, with what it is to read there
/// @return eps
template <int d>
double error_shared(
    Stack stack, const NamedArguments& named, SharedContact& contact,
    const ReadBodies<d>& read,
    const std::function<double(const ReadBodies<d>& read_whole)>& judge);

/// The relaxation of a solid by the processes that have its parts, on process 0.
RelaxFacets<3> relax_shared(const SharedContact& contact);

/// optimalsize: what it makes of arrays over all cells, from those of each process.
/// @param arrays   of this process's cells, one below the other
/// @return the predicted number of cells
double sizes_shared(
    Stack stack, const NamedArguments& named, SharedContact& contact,
    const std::vector<VectorXd>& arrays,
    const std::function<double(const std::vector<VectorXd>& whole)>& sizes);

}  // namespace ffcontact::plugin
