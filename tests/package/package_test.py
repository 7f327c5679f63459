"""The install tree is enough for another project: installs the built project into a scratch folder, builds
examples/ against it and runs them.
Usage: package_test.py CMAKE BUILD_FOLDER COMPILER [LINK FLAG]"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command):
    result = subprocess.run([str(word) for word in command], text=True, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{result.stdout}exit {result.returncode}")
    return result.stdout


def main():
    cmake, built, compiler, flags = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]
    with tempfile.TemporaryDirectory() as scratch:
        installed, folder = pathlib.Path(scratch, "installed"), pathlib.Path(scratch, "examples")
        run(cmake, "--install", built, "--prefix", installed)
        headers = [path.name for path in installed.rglob("*.hpp")]
        if "software_device.hpp" not in headers or any("_test" in name for name in headers):
            sys.exit(f"wrong headers in the install tree: {headers}")
        for file in ("man/man1/caustics.1", "bash-completion/completions/caustics",
                     "zsh/site-functions/_caustics", "fish/vendor_completions.d/caustics.fish"):
            if "caustics" not in (installed / "share" / file).read_text():
                sys.exit(f"share/{file} says nothing")
        run(cmake, "-S", ROOT / "examples", "-B", folder, f"-DCMAKE_PREFIX_PATH={installed}",
            f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={' '.join(flags)}",
            "-DCMAKE_BUILD_TYPE=Release")
        run(cmake, "--build", folder)
        said = run(folder / "read_caustic_map", ROOT / "scenes/glass_sphere.glb")
        if not re.fullmatch(r"512x512 texels, 0\.\d+ in all\n", said):
            sys.exit(f"read_caustic_map said: {said}")
        said = run(folder / "luminance_test")
        if "software" not in said or "FAILED" in said:
            sys.exit(f"luminance_test said: {said}")
        print(said, end="")


if __name__ == "__main__":
    main()
