"""What the program tells a person, on standard error."""

import sys


def say(text):
    print(f"hexoderm-ros: {text}", file=sys.stderr, flush=True)
