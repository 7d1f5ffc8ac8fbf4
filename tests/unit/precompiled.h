// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/precompiled.h>

#include <gtest/gtest.h>
