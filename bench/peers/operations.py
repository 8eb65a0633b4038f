"""Counts what generated C does."""

import re

TOKEN = re.compile(r"\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?|[A-Za-z_]\w*|[=!<>]=|\S")
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
DIRECTIVE = re.compile(r"^\s*#.*$", re.MULTILINE)
ENDS_A_VALUE = re.compile(r"[\w.)\]]")


def in_statement(text):
    """Multiplications and additions on the right of an assignment. A sign counts nothing."""
    count, assigned, before = 0, False, ""
    for token in TOKEN.findall(text):
        if assigned and token in "+-*" and before and ENDS_A_VALUE.fullmatch(before[-1]):
            count += 1
        elif assigned and token == "casadi_sq":  # a square
            count += 1
        assigned = assigned or token == "="
        before = token
    return count


def in_code(text):
    text = DIRECTIVE.sub("", COMMENT.sub("", text))
    return sum(in_statement(statement) for statement in text.split(";"))
