"""Packages as files: ``PackageTools``."""

from __future__ import annotations

import re
from pathlib import Path

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.packs.store import package_path

_FORBIDDEN = re.compile(r"""[\\:*?"<>|' ,.&!~\n\r\t@#(){}\[\]=;^%$`]""")

_KINDS = {".umap": "level", ".uasset": "asset"}


@public
class PackageTools(Object):
    """Names of packages."""

    _class_module = "UnrealEd"

    @classmethod
    @api
    def sanitize_package_name(cls, package_name: str) -> str:
        """A package name with ``_`` for what none may hold, and one slash where there were more."""
        return re.sub(r"/+", "/", _FORBIDDEN.sub("_", str(package_name)))

    @classmethod
    @api
    def package_name_to_filename(cls, package_name: str, extension: str = "") -> str:
        """The file that holds a package, and for one that is not there its place in the content; empty for no package.

        An extension of Unreal's finds only what it is for: ``.umap`` a level, ``.uasset`` an asset.
        """
        package = package_path(str(package_name))
        file = world().package_file(package, _KINDS.get(str(extension).lower()))
        if file is None:
            file = world().content_file(package, str(extension))
        return file.as_posix() if file is not None else ""

    @classmethod
    @api
    def filename_to_package_name(cls, filename: str) -> str:
        """The package of a file in the content folder; empty for any other."""
        file = Path(str(filename))
        if not file.is_relative_to(world().content):
            return ""
        return "/" + file.relative_to(world().content).as_posix().partition(".")[0]
