#!/usr/bin/env python3
"""What the OpenGL Device hands to the driver is GLSL 4.50, and every float operation in it is precise.

    shaders.py caustics_shader_texts    the program that writes the texts

glslangValidator, which follows the specification to the letter, compiles them to SPIR-V. There a precise
operation bears the decoration NoContraction. Without it the test is skipped (exit code 77)."""
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

# By number: OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem, OpFMod, and OpVectorTimesScalar to OpDot.
FLOAT_ARITHMETIC = {127, 129, 131, 133, 136, 140, 141, *range(142, 149)}
OP_LINE, OP_DECORATE, NO_CONTRACTION = 8, 71, 42


def instructions(module):
    """Number of the operation and operands of each instruction (the SPIR-V specification, 2.3)."""
    words = struct.unpack(f'<{len(module) // 4}I', module)
    at = 5
    while at < len(words):
        length, operation = words[at] >> 16, words[at] & 0xffff
        yield operation, words[at + 1:at + length]
        at += length


def float_operations(module):
    """The source line of each float operation, and the lines of those that are not precise."""
    lines, precise, line = {}, set(), 0
    for operation, operands in instructions(module):
        if operation == OP_LINE:
            line = operands[1]
        elif operation == OP_DECORATE and operands[1] == NO_CONTRACTION:
            precise.add(operands[0])
        elif operation in FLOAT_ARITHMETIC:
            lines[operands[1]] = line
    return lines.values(), [line for result, line in lines.items() if result not in precise]


def examine(file):
    """What is wrong with a text, and how many float operations it has."""
    text = file.read_text(encoding='utf-8')
    if not text.isascii():
        return [f'{file.name}: GLSL is ASCII, and a character here is not'], 0
    binary = file.with_name(file.name + '.spv')
    result = subprocess.run(['glslangValidator', '-G', '-g', '--aml', '--amb', '-o', binary, file], text=True,
                            capture_output=True)
    if result.returncode:
        errors = [line for line in result.stdout.splitlines() if line.startswith('ERROR')]
        return [f'{file.name}: ' + ' | '.join(errors)], 0
    operations, unmarked = float_operations(binary.read_bytes())
    shader_text = text.partition('\n#line 1\n')[2].splitlines()
    return [f'{file.name}: a float operation here is not precise; give its value a variable: '
            + shader_text[line - 1].strip() for line in sorted(set(unmarked))], len(operations)


def main():
    if not shutil.which('glslangValidator'):
        print('skipped: no glslangValidator here')
        return 77
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        files = sorted(pathlib.Path(folder).iterdir())
        examined = [examine(file) for file in files]
    wrong = [line for lines, _ in examined for line in lines]
    operations = sum(count for _, count in examined)
    print('\n'.join(wrong)
          or f'{len(files)} texts are GLSL 4.50; all of {operations} float operations are precise')
    return 1 if wrong or len(files) < 20 or operations < 1000 else 0


sys.exit(main())
