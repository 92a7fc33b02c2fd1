// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact {

/// [bytes]
double memory_of_the_machine();

/// What is left of it, swap included [bytes]: where more is asked for Linux ends the process.
double available_memory();

}  // namespace ffcontact
