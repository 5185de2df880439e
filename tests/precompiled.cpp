// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled with the precompiled header, which main.cpp is not, so that there is a rule that makes
// it.
