"""The wheel is for any Python 3 (ctypes needs no extension module) and one platform (it contains the library). build_wheel.py puts a library
in; where there is none, as in a source package or a checkout, it is built: that takes cmake, a C++20 compiler and Eigen."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return True


class BuildLibrary(build_py):
    def run(self):
        super().run()
        lib = Path(self.build_lib, "carom", "lib")
        if self.editable_mode or list(lib.glob("*carom*")):
            return
        sources = next((at for at in (HERE / "source", *HERE.parents) if (at / "src" / "abi" / "carom.map").exists()), None)
        if not sources:
            sys.exit("carom: no library in carom/lib, and no sources to build it of. Install a wheel, or from a checkout of the repository")
        build = Path(self.build_lib).resolve().parent / "carom"
        options = [f"-DCAROM_{what}=OFF" for what in ("BUILD_TOOLS", "BUILD_TESTS", "BUILD_STATIC", "INSTALL")]
        try:
            subprocess.run(["cmake", "-S", sources, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCAROM_UNITY=ON", *options], check=True)
            subprocess.run(["cmake", "--build", build, "-j", os.environ.get("CAROM_JOBS", str(os.cpu_count()))], check=True)
        except FileNotFoundError:
            sys.exit("carom: building the library takes cmake, which is not installed. Debian: apt install cmake g++ libeigen3-dev")
        except subprocess.CalledProcessError:
            sys.exit("carom: the library could not be built, see above. It takes a C++20 compiler and Eigen: apt install g++ libeigen3-dev")
        (lib / "plugins").mkdir(parents=True)
        for file in [*(build / "lib").glob("libcarom*.0.9*"), *(build / "bin").glob("carom.dll")]:
            if file.is_symlink() or file.suffix == ".dll":  # under the name that is looked for
                shutil.copy(file.resolve(), lib / file.name)
        for plugin in [*(build / "plugins").glob("*.so"), *(build / "plugins").glob("*.dll")]:
            if plugin.stem != "template":  # the one to copy, not to use
                shutil.copy(plugin, lib / "plugins")


class PlatformWheel(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(distclass=WithLibrary, cmdclass={"build_py": BuildLibrary, "bdist_wheel": PlatformWheel})
