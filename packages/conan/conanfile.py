"""Conan 2: `conan create packages/conan` in a checkout. Shared by default; shapes lie in lib/carom/plugins, where the library looks."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, CMakeDeps, cmake_layout
from conan.tools.files import copy, load


class Carom(ConanFile):
    name = "carom"
    license = "MIT"
    description = "Rigid-body physics engine: the same bits on every machine, shapes as plugins"
    settings = "os", "arch", "compiler", "build_type"
    package_type = "shared-library"

    def set_version(self):
        text = load(self, os.path.join(self.recipe_folder, "..", "..", "include", "carom", "base.h"))
        self.version = ".".join(re.findall(r"#define CAROM_VERSION_\w+ (\d+)u", text))

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "*.md", "include/*", "plugins/*", "src/*", "bindings/CMakeLists.txt", "packages/*.cmake",
                        "packages/debian/*", "packages/carom.1"):
            copy(self, pattern, root, self.export_sources_folder, excludes=("*/node_modules/*", "*/dist/*"))

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("eigen/3.4.0", visible=False)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for what in ("BUILD_TOOLS", "BUILD_TESTS", "BUILD_STATIC"):
            toolchain.cache_variables[f"CAROM_{what}"] = False
        toolchain.cache_variables["CAROM_UNITY"] = True
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["carom"]
        self.cpp_info.set_property("cmake_file_name", "carom")
        self.cpp_info.set_property("cmake_target_name", "carom::carom")
        self.cpp_info.set_property("pkg_config_name", "carom")
        self.runenv_info.prepend_path("CAROM_PLUGIN_PATH", os.path.join(self.package_folder, "lib", "carom", "plugins"))
