"""Compiling the modules of a wheel.  Python for the browser does it once, when the site is made, and no page has to.

It runs with nothing but the standard library.
"""

from __future__ import annotations

import marshal
import warnings
from importlib.util import MAGIC_NUMBER, source_hash
from io import BytesIO
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

_UNCHECKED = (1).to_bytes(4, "little")
"""The flags of compiled code that is not compared with its source."""


def compiled(wheel: bytes) -> bytes:
    """Return a ZIP file that Python imports modules from: those of a wheel but for its tests, and its licence."""
    written = BytesIO()
    with ZipFile(BytesIO(wheel)) as archive, ZipFile(written, "w") as out, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name in sorted(archive.namelist()):
            if name.endswith(".py") and "/tests/" not in name:
                _write(out, f"{name}c", _bytecode(archive.read(name), name))
            elif ".dist-info/" in name:
                _write(out, name, archive.read(name))
    return written.getvalue()


def _bytecode(source: bytes, name: str) -> bytes:
    code = compile(source, name, "exec", dont_inherit=True)
    return MAGIC_NUMBER + _UNCHECKED + source_hash(source) + marshal.dumps(code)


def _write(archive: ZipFile, name: str, content: bytes) -> None:
    archive.writestr(ZipInfo(name), content, ZIP_DEFLATED)
