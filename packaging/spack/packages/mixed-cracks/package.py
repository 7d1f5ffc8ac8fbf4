# SPDX-License-Identifier: GPL-2.0-or-later
"""Untested: there was no Spack where it was written.

    spack repo add packaging/spack
    spack dev-build mixed-cracks@main
"""
from spack.package import *


class MixedCracks(CMakePackage):
    """Phase-field fracture of nearly incompressible, rubber-like solids."""

    license("GPL-2.0-or-later")
    version("main")

    depends_on("cmake@3.18:", type="build")
    depends_on("mpi")
    depends_on("dealii@9.4:+mpi+trilinos+p4est+muparser")
    depends_on("muparser")
    depends_on("mumps@5.5:+mpi")
    depends_on("metis@5:")
    depends_on("python@3.11:", type="run")
    depends_on("py-matplotlib", type="run")
    depends_on("py-scipy", type="run")

    def cmake_args(self):
        return [self.define("MIXED_CRACKS_TESTS", False)]
