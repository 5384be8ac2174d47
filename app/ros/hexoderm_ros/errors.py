"""Errors that end the program: each has its exit code, and a text that says what is wrong."""


class UsageError(Exception):
    """The command line, or what the environment says, can't be followed."""

    code = 2


class InputError(Exception):
    """A file is not as it should be; the text says where, and what was expected."""

    code = 3


class AddressError(Exception):
    """The port can't be listened to."""

    code = 4
