"""``python -m stridemap`` is the command ``stridemap``."""

from stridemap.cli import main

if __name__ == "__main__":
    main()
