"""Paths: the folders of the project and the parts of file names."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path, PurePosixPath

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.core import Object, api, public


@public
class Paths(Object):
    """Folders of the project, with a slash behind, and parts of file names."""

    @classmethod
    @api
    def project_dir(cls) -> str:
        """The project: the folder of the writable root."""
        return f"{world().content.parent.as_posix()}/"

    @classmethod
    @api
    def get_project_file_path(cls) -> str:
        """Where the project file would be; there is none on disk."""
        folder = world().content.parent
        return f"{folder.as_posix()}/{folder.name}.uproject"

    @classmethod
    @api
    def project_content_dir(cls) -> str:
        """The content."""
        return f"{world().content.as_posix()}/"

    @classmethod
    @api
    def project_saved_dir(cls) -> str:
        """Scratch."""
        return f"{world().scratch.as_posix()}/"

    @classmethod
    @api
    def project_log_dir(cls) -> str:
        """Folder for logs, in scratch."""
        return f"{world().scratch.as_posix()}/Logs/"

    @classmethod
    @api
    def screen_shot_dir(cls) -> str:
        """Folder for pictures, in scratch."""
        return f"{world().scratch.as_posix()}/Screenshots/"

    @classmethod
    @api
    def convert_relative_path_to_full(cls, path: str, base_path: str = "") -> str:
        """Paths here are full already."""
        return str(path)

    @classmethod
    @api
    def combine(cls, paths: Sequence[str]) -> str:
        """Parts of a path as one."""
        parts = [str(path) for path in paths]
        return "/".join([part.rstrip("/") for part in parts[:-1] if part] + parts[-1:])

    @classmethod
    @api
    def file_exists(cls, path: str) -> bool:
        """Whether a file exists."""
        return Path(str(path)).is_file()

    @classmethod
    @api
    def directory_exists(cls, path: str) -> bool:
        """Whether a folder exists."""
        return Path(str(path)).is_dir()

    @classmethod
    @api
    def get_path(cls, path: str) -> str:
        """The part before the last slash."""
        return str(path).replace("\\", "/").rpartition("/")[0]

    @classmethod
    @api
    def get_clean_filename(cls, path: str) -> str:
        """The part behind the last slash."""
        return str(path).replace("\\", "/").rpartition("/")[2]

    @classmethod
    @api
    def get_base_filename(cls, path: str, remove_path: bool = True) -> str:
        """A path without its extension, and without folders unless ``remove_path`` is False."""
        text = str(path).replace("\\", "/")
        return str(PurePosixPath(text).stem) if remove_path else text.removesuffix(PurePosixPath(text).suffix)

    @classmethod
    @api
    def get_extension(cls, path: str, include_dot: bool = False) -> str:
        """The part behind the last dot of a file name."""
        suffix = PurePosixPath(str(path)).suffix
        return suffix if include_dot else suffix[1:]
