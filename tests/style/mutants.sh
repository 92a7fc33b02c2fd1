#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Each change of mutants.txt has its one place in the code of today.
exec bash tests/mutants --find
