# SPDX-License-Identifier: GPL-3.0-or-later
#
# Recipe for Spack; it has not been run. In a repository of packages of your own
# (spack repo create), as packages/grainfoam/package.py; then, in the folder of
# grainFoam,
#
#     spack dev-build grainfoam@0.9.0
#
# There is no address to fetch a release from yet.

from spack.package import *


class Grainfoam(Package):
    """Resolved rigid grains in confined incompressible flow, on OpenFOAM."""

    version("0.9.0")

    depends_on("openfoam@1912:2506")
    depends_on("fftw@3")
    depends_on("blas")
    depends_on("lapack")
    depends_on("python", type="run")
    depends_on("py-numpy", type="run")
    depends_on("py-matplotlib", type="run")

    def script(self, prefix, command):
        """A command with OpenFOAM and grainFoam set up in this folder."""
        openfoam = self.spec["openfoam"].prefix
        platforms = f"{prefix}/platforms/$WM_OPTIONS"
        return (
            f'. "{openfoam}/etc/bashrc";'
            f' export FOAM_USER_APPBIN="{platforms}/bin"'
            f' FOAM_USER_LIBBIN="{platforms}/lib";'
            f' . "{prefix}/etc/bashrc" && {command}'
        )

    def install(self, spec, prefix):
        # Cases need more than the binaries: templates, tables, tutorials
        install_tree(self.stage.source_path, prefix)
        with working_dir(prefix):
            which("bash")("-c", self.script(prefix, "./Allwmake"))

    def setup_run_environment(self, env):
        # Spack has the variables of OpenFOAM; the rest is that of etc/bashrc
        env.set("GRAINFOAM_DIR", self.prefix)
        env.set("WM_PROJECT_SITE", self.prefix)
        env.prepend_path("PATH", self.prefix.bin)
        env.prepend_path("PYTHONPATH", self.prefix.python)
        for platform in find(self.prefix.platforms, "bin"):
            env.prepend_path("PATH", platform)
        for platform in find(self.prefix.platforms, "lib"):
            env.prepend_path("LD_LIBRARY_PATH", platform)
