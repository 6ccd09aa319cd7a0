"""``python -m stridemap`` is the command ``stridemap``."""

from stridemap.cli.app import main

if __name__ == "__main__":
    main()
