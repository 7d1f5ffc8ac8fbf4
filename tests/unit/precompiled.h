// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/precompiled.h>

#include <gtest/gtest.h>
