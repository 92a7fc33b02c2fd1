// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// FreeFEM's own headers, in the order they want. They bring `using namespace std` and
// `#define cerr cout`, so the core's headers come before this one.
#include "ff++.hpp"
//
#include "AFunction_ext.hpp"
