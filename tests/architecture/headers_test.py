"""Every header compiles by itself. Usage: headers_test.py COMPILER [FLAG ...]"""

import concurrent.futures
import os
import subprocess
import sys

import source_tree

# Parts of stage.hpp that are included once for each lane width, in that width's namespace, and so have
# neither an include guard nor a meaning of their own.
NOT_ALONE = {"pipeline/shader/vectors.hpp", "pipeline/shader/scalar.hpp", "pipeline/shader/wide.hpp"}
# Made for one lane width: what the generated source defines before it includes them.
DEFINES = ["-DCAUSTICS_LANES=1", "-DCAUSTICS_LANE_NAMESPACE=lanes_scalar"]


def compile_alone(compiler, flags, header):
    command = [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-I", source_tree.ROOT,
               *DEFINES, *flags, "-x", "c++", "-"]
    text = f'#include "{header}"\n#include "{header}"\n'
    return subprocess.run(command, input=text, text=True, capture_output=True)


def main():
    compiler, flags = sys.argv[1], sys.argv[2:]
    headers = [source_tree.name(path) for path in source_tree.files(".hpp")]
    headers = [header for header in headers if header not in NOT_ALONE and "/lanes/" not in header]
    faults = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(lambda header: compile_alone(compiler, flags, header), headers)
        for header, result in zip(headers, results):
            if result.returncode != 0 or result.stderr:
                faults += 1
                print(f"{header} does not compile by itself:\n{result.stderr}")
    print(f"{len(headers)} headers, {faults} faults")
    return 1 if faults or not headers else 0


if __name__ == "__main__":
    sys.exit(main())
