"""Compiling the modules of a wheel.  Python for the browser does it once, when the site is made, and no page has to.

It runs with nothing but the standard library.
"""

import ast
import marshal
import re
import warnings
from importlib.util import MAGIC_NUMBER, source_hash
from io import BytesIO
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

_DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
_UNCHECKED = (1).to_bytes(4, "little")
"""The flags of compiled code that is not compared with its source."""


def compiled(wheel: bytes) -> bytes:
    """Return a ZIP file that Python imports modules from: a wheel without tests and docstrings, with its licence."""
    written = BytesIO()
    with ZipFile(BytesIO(wheel)) as archive, ZipFile(written, "w") as out, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name in sorted(archive.namelist()):
            if name.endswith(".py") and "/tests/" not in name:
                _write(out, f"{name}c", _bytecode(archive.read(name), name))
            elif re.search(r"\.dist-info/.*(licen[cs]e|copying|authors)", name, re.IGNORECASE):
                _write(out, name, archive.read(name))
    return written.getvalue()


def _bytecode(source: bytes, name: str) -> bytes:
    tree = ast.parse(source)
    for node in ast.walk(tree):
        if isinstance(node, _DOCUMENTED) and ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:] or [ast.Pass(lineno=1, col_offset=0)]
    code = compile(tree, name, "exec", dont_inherit=True)
    return MAGIC_NUMBER + _UNCHECKED + source_hash(source) + marshal.dumps(code)


def _write(archive: ZipFile, name: str, content: bytes) -> None:
    archive.writestr(ZipInfo(name), content, ZIP_DEFLATED)
