"""The wheel: the library, the command and their data beside the modules; for any Python 3, on this kind of machine.

./do wheel makes it; or, without the network, pip install --no-build-isolation ./python
"""

import pathlib
import re
import shutil
import subprocess

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution
from wheel.bdist_wheel import bdist_wheel

sources = pathlib.Path(__file__).resolve().parents[1]
built = sources / "build/release"
library, command = built / "c/libdashpad.so.1", built / "app/dashpad"


def needed_by(*files):
    """The libraries that a plain system does not have."""
    loaded = "".join(subprocess.run(["ldd", file], check=True, capture_output=True, text=True).stdout for file in files)
    return sorted(set(re.findall(r"=> (\S*lib(?:fmt|sqlite3|tbb)\S*) ", loaded)))


class WithLibrary(build_py):
    def run(self):
        super().run()
        if not (library.exists() and command.exists()):
            subprocess.run(["cmake", "--preset", "release"], cwd=sources, check=True)
            targets = ["--target", "dashpad-shared", "dashpad-command"]
            subprocess.run(["cmake", "--build", "--preset", "release", *targets], cwd=sources, check=True)
        package = pathlib.Path(self.build_lib, "dashpad")
        (package / "bin").mkdir(parents=True, exist_ok=True)
        for file, folder in ((command, package / "bin"), *((each, package) for each in (library, *needed_by(library, command)))):
            subprocess.run(["strip", "--strip-unneeded", "-o", shutil.copy(file, folder), file], check=True)
        shutil.copy(sources / "LICENSE", package)
        for data in ("materials", "standards"):
            shutil.copytree(sources / data, package / data, dirs_exist_ok=True)


class WithBinaries(Distribution):
    def has_ext_modules(self):
        return True


class ForAnyPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(
    version=re.search(r"^ *VERSION ([0-9.]+)$", (sources / "CMakeLists.txt").read_text(), re.MULTILINE)[1],
    distclass=WithBinaries,
    cmdclass={"bdist_wheel": ForAnyPython, "build_py": WithLibrary},
)
