"""Files that are too large, too deep or no text; as a script: try them and the corpus, print peak memory."""

import resource
import sys
from pathlib import Path

from eom import DescriptionError, assemble, loads

FOLDER = Path(__file__).parents[1] / "bad_files"
BODY = "bodies: {a: {mass: 1, at: [0, 0, 0]}}\n"
CHAIN = "parameters:\n" + "".join(f"  p{k}: {{value: p{k + 1}}}\n" for k in range(150)) + "  p150: {value: 1}\n"
UNITS = "".join(f"  u{k}: {{bodies: {{a: {{mass: 1, at: [0, 0, 0]}}}}}}\n" for k in range(300))
HITCHES = "".join(
    f"  h{k}: {{kind: pintle, between: [u{k}, u{k + 1}], at: {{u{k}: [0, 0, 1], u{k + 1}: [0, 0, 1]}}}}\n"
    for k in range(299)
)
BODIES = "".join(f"  b{k}: {{mass: {k}x, at: [0, 0, 0]}}\n" for k in range(190))

MONSTERS: dict[str, tuple[str | bytes, str]] = {
    "empty": ("", "a vehicle file is a mapping"),
    "nested brackets": ("a: " + "[" * 5000, "nested more than 30 deep"),
    "nested braces": ("{a: " * 5000, "nested more than 30 deep"),
    "nested lines": ("".join(" " * k + "a:\n" for k in range(1000)), "nested more than 30 deep"),
    "nested parentheses": ("name: n\ngravity: " + "(" * 90_000, "an expression has at most 200 characters"),
    "many keys": ("".join(f"k{k}: 1\n" for k in range(70_000)), "more than 60000 keys and values"),
    "very many keys": ("".join(f"k{k}: 1\n" for k in range(200_000)), "at most 1000000"),
    "many unknown keys": ("name: n\n" + "".join(f"boodies{k}: 1\n" for k in range(4990)), "unknown key 'boodies0'"),
    "many wrong bodies": ("name: n\nbodies:\n" + BODIES, "unknown unit of measure 'x'"),
    "many anchors": ("".join(f"k{k}: &a{k} {{}}\n" for k in range(70_000)), "at most 1000000"),
    "two megabytes of comment": ("#" * 2_000_000, "at most 1000000"),
    "two megabytes of name": ("name: " + "x" * 2_000_000, "at most 1000000"),
    "long name": ("name: " + "x" * 900_000 + "\n" + BODY, "is longer than 200 characters"),
    "long key": ("x" * 900_000 + ": 1\n", "not readable as YAML"),
    "long quoted key": ('? "' + "x" * 900_000 + '"\n: 1\n', "has 900000 characters"),
    "long number": ("name: n\ngravity: " + "9" * 900_000, "is too large for a number"),
    "long type": (f"name: n\nconnectors: {{a: {{type: {'x' * 900_000}}}}}\n" + BODY, "unknown type"),
    "long unit of measure": ("name: n\ngravity: 1 " + "m" * 900_000, "the unit of measure is too long"),
    "long tag": ("name: !" + "x" * 900_000 + " 1\n", "is not read"),
    "binary": (bytes(range(256)), "not readable as UTF-8 text"),
    "NUL": ("name: n\0\n", "control characters are not allowed"),
    "lone surrogate": ("name: \ud800\n", "not readable as UTF-8 text"),
    "UTF-16": ("name: n\n".encode("utf-16"), "not readable as UTF-8 text"),
    "many units": (f"name: n\ntrim: {{speed: 1}}\nunits:\n{UNITS}couplings:\n{HITCHES}", "expected at most 20"),
    "long chain with a cycle": ("name: n\n" + CHAIN.replace("value: 1}", "value: p0}") + BODY, "computed from itself"),
}


def peak_memory() -> int:
    """Largest resident size of this process [kB]; getrusage would count from the size of its parent."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    return int(status.split("VmHWM:")[1].split()[0])


def main() -> None:
    """Load and assemble every bad file; a runaway dies of its limit before the machine does."""
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    texts = [text for text, _ in MONSTERS.values()] + [file.read_bytes() for file in sorted(FOLDER.glob("*.yaml"))]
    for text in texts:
        try:
            assemble(loads(text))
        except DescriptionError:
            continue
        sys.exit("a bad file was read")
    print(peak_memory())


if __name__ == "__main__":
    main()
