"""Command line: ``eom`` and its commands, see `eom.cli.app`."""

import sys


def main() -> None:
    """Run the command line; mistakes of the user end it with their sentences and exit status 2."""
    from eom.cli.app import app  # noqa: PLC0415
    from eom.errors import EomError  # noqa: PLC0415

    try:
        app()
    except EomError as error:
        sys.stderr.write(f"{error}\n")
        sys.exit(2)
    except OSError as error:
        sys.stderr.write(f"{error.filename or 'the output'}: cannot be written: {error.strerror or error}\n")
        sys.exit(2)
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.exit(130)
