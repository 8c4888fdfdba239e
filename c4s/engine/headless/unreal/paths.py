"""Paths: the folders of the project and the parts of file names."""

from __future__ import annotations

import re
from collections.abc import Sequence
from os.path import normpath, relpath
from pathlib import Path, PurePosixPath
from uuid import uuid4

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.core import Object, api, public

_INVALID = '/?:&\\*"<>|%#@^ '


def _slashes(path: object) -> str:
    return str(path).replace("\\", "/")


def _dotted(extension: object) -> str:
    return f".{str(extension).removeprefix('.')}" if str(extension) else ""


@public
class Paths(Object):
    """Folders of the project, with a slash behind, and parts of file names."""

    @classmethod
    @api
    def project_dir(cls) -> str:
        """The project; ``Saved`` in it is writable."""
        return f"{world().scratch.parent.as_posix()}/"

    @classmethod
    @api
    def get_project_file_path(cls) -> str:
        """Where the project file would be; there is none on disk."""
        folder = world().scratch.parent
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
    def project_config_dir(cls) -> str:
        """Where settings would be; there are none on disk."""
        return f"{cls.project_dir()}Config/"

    @classmethod
    @api
    def project_plugins_dir(cls) -> str:
        """Where plugins would be; there are none."""
        return f"{cls.project_dir()}Plugins/"

    @classmethod
    @api
    def project_intermediate_dir(cls) -> str:
        """Folder for what can be made anew."""
        return f"{cls.project_dir()}Intermediate/"

    @classmethod
    @api
    def project_user_dir(cls) -> str:
        """The project."""
        return cls.project_dir()

    @classmethod
    @api
    def root_dir(cls) -> str:
        """The project: there is no engine on disk around it."""
        return cls.project_dir()

    @classmethod
    @api
    def launch_dir(cls) -> str:
        """The project."""
        return cls.project_dir()

    @classmethod
    @api
    def is_project_file_path_set(cls) -> bool:
        """There is a project."""
        return True

    @classmethod
    @api
    def is_relative(cls, path: str) -> bool:
        """Whether a path begins nowhere fixed."""
        return not PurePosixPath(_slashes(path)).is_absolute() and ":" not in str(path)

    @classmethod
    @api
    def is_same_path(cls, path_a: str, path_b: str) -> bool:
        """Whether two paths are one."""
        return normpath(_slashes(path_a)) == normpath(_slashes(path_b))

    @classmethod
    @api
    def split(cls, path: str) -> tuple[str, str, str]:
        """Folder, name and extension."""
        return cls.get_path(path), cls.get_base_filename(path), cls.get_extension(path)

    @classmethod
    @api
    def change_extension(cls, path: str, new_extension: str) -> str:
        """With another extension; as it is where it has none."""
        text, ending = _slashes(path), PurePosixPath(_slashes(path)).suffix
        return f"{text.removesuffix(ending)}{_dotted(new_extension)}" if ending else text

    @classmethod
    @api
    def set_extension(cls, path: str, new_extension: str) -> str:
        """With an extension, instead of the one it may have."""
        text = _slashes(path)
        return f"{text.removesuffix(PurePosixPath(text).suffix)}{_dotted(new_extension)}"

    @classmethod
    @api
    def normalize_filename(cls, path: str) -> str:
        """With slashes only."""
        return _slashes(path)

    @classmethod
    @api
    def normalize_directory_name(cls, path: str) -> str:
        """With slashes only, and none at the end."""
        text = _slashes(path)
        return text.rstrip("/") or text[:1]

    @classmethod
    @api
    def make_standard_filename(cls, path: str) -> str:
        """With slashes only and no step back."""
        return normpath(_slashes(path))

    @classmethod
    @api
    def make_platform_filename(cls, path: str) -> str:
        """As the system writes it."""
        return _slashes(path)

    @classmethod
    @api
    def make_path_relative_to(cls, path: str, relative_to: str) -> str | None:
        """A path from the folder of another; None where one is fixed and the other is not."""
        start = _slashes(relative_to).rpartition("/")[0] or "."
        if cls.is_relative(path) is not cls.is_relative(relative_to):
            return None
        return relpath(_slashes(path), start)

    @classmethod
    @api
    def collapse_relative_directories(cls, path: str) -> str | None:
        """Without steps back; None where they lead out of it."""
        found = normpath(_slashes(path))
        return None if found.startswith("..") else found

    @classmethod
    @api
    def remove_duplicate_slashes(cls, path: str) -> str:
        """With one slash where there were more."""
        return re.sub("/+", "/", str(path))

    @classmethod
    @api
    def get_invalid_file_system_chars(cls) -> str:
        """What no file name may hold."""
        return _INVALID

    @classmethod
    @api
    def make_valid_file_name(cls, string: str, replacement_char: str = "") -> str:
        """Without what no file name may hold."""
        return "".join(str(replacement_char)[:1] if letter in _INVALID else letter for letter in str(string))

    @classmethod
    @api
    def create_temp_filename(cls, path: str, prefix: str = "", extension: str = ".tmp") -> str:
        """A file in a folder that is not there yet."""
        return f"{str(path).rstrip('/')}/{prefix}{uuid4().hex.upper()}{extension}"

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
