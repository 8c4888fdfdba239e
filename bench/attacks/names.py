"""Files that are more than files: links, devices, modes, handles, reserved space."""

from __future__ import annotations

from bench.attacks.row import Attack
from c4s.engine.confine.confinement import Backend

NAMES = [
    Attack("symbolic link to the truth", "filter", "os.symlink(TRUTH, 'link')"),
    Attack("symbolic link in the submission", "filter", "os.symlink('/etc/passwd', os.path.join(CONTENT, 'link'))"),
    Attack("hard link to the truth", "filter", "os.link(TRUTH, 'link')"),
    Attack("hard link of its own file", "filter", "(open('own', 'w').close(), os.link('own', 'link'))"),
    Attack("named pipe in the submission", "filter", "os.mkfifo(os.path.join(CONTENT, 'pipe'))"),
    Attack("device", "filter", "os.mknod('sda', 0o60600, os.makedev(8, 0))"),
    Attack("socket file", "filter", "os.mknod('socket', 0o140600)"),
    Attack("file that runs as its owner", "filter", "os.close(os.open('root', os.O_CREAT | os.O_WRONLY, 0o4755))"),
    Attack(
        "open the withheld truth by its file handle",
        "filter",
        "fail(libc.syscall(304, -100, ctypes.create_string_buffer(128), 0))",
    ),
    Attack("open by a made-up file handle", "filter", "call(304, -100, bytes(128), 0)"),
    Attack(
        "take a handle of its own file",
        "filter",
        "call(303, -100, b'.', ctypes.create_string_buffer(128), ctypes.byref(ctypes.c_int()), 0)",
    ),
    Attack("file that runs as its group", "filter", "os.close(os.open('group', os.O_CREAT | os.O_WRONLY, 0o2755))"),
    Attack("file that runs as its owner, by creat", "filter", "call(85, b'root', 0o4755)"),
    Attack("file that runs as its owner, by openat2", "filter", "call(437, -100, b'root', bytes(24), 24)"),
    Attack(
        "set-user-id by chmod",
        "nothing",
        "(open('own1', 'w').close(), os.chmod('own1', 0o4755), did(os.stat('own1').st_mode & 0o4000))",
    ),
    Attack(
        "set-user-id by fchmodat2",
        "nothing",
        "(open('own2', 'w').close(), call(452, -100, b'own2', 0o4755, 0), did(os.stat('own2').st_mode & 0o4000))",
    ),
    Attack(
        "a file that the host cannot read",
        "nothing",
        "(open('own3', 'w').close(), os.chmod('own3', 0), did(not os.stat('own3').st_mode & 0o400))",
    ),
    Attack(
        "a file of another user",
        "nothing",
        "(open('own4', 'w').close(), os.chown('own4', 1, 1), did(os.stat('own4').st_uid == 1))",
    ),
    Attack(
        "a capability on a file",
        "nothing",
        "(open('own5', 'w').close(), os.setxattr('own5', 'security.capability', bytes(20)), did(os.listxattr('own5')))",
    ),
    Attack(
        "a file from the past",
        "nothing",
        "(open('own6', 'w').close(), os.utime('own6', (1, 1)), did(os.stat('own6').st_mtime == 1))",
    ),
    Attack("be told of changes", "filter", "call(294, 0)"),
    Attack("be told of changes, the old way", "filter", "call(253)"),
    Attack("watch a folder outside", "filter", "call(254, 0, b'/', 0xfff)"),
    Attack("watch the file system", "filter", "call(300, 0, 0)"),
    Attack("mark the file system", "filter", "call(301, 0, 0, 0, 0, 0)"),
    Attack("learn the mounts", "filter", "call(458, bytes(24), bytes(64), 8, 0)"),
    Attack("learn a mount", "filter", "call(457, bytes(24), bytes(512), 512, 0)"),
    Attack("reserve space", "filter", "(call(285, os.open('res', 66), 1, 0, 1 << 40))"),
    Attack("reserve space by ioctl", "filter", "fcntl.ioctl(os.open('res', 66), 0x40305828, bytes(48))"),
    Attack("reserve space by the other ioctl", "filter", "fcntl.ioctl(os.open('res', 66), 0x4030582A, bytes(48))"),
    Attack("zero a range by ioctl", "filter", "fcntl.ioctl(os.open('res', 66), 0x40305839, bytes(48))"),
    Attack("make a file that cannot be deleted", "filter", "fcntl.ioctl(os.open('res', 66), 0x40086602, bytes(8))"),
    Attack("clone a file by ioctl", "filter", "fcntl.ioctl(os.open('res', 66), 0x40049409, 0)"),
    Attack("quota", "filter", "call(179, 0x800007, b'/', 0, bytes(64))"),
    Attack("process accounting into a file", "filter", "call(163, b'acct')"),
]

_NOT_GOVERNED: dict[Backend, str] = {
    "landlock": "Landlock does not govern stat: existence and size can be asked for, names cannot be listed"
}
GUESSING = [
    Attack("learn that the truth exists", "files", "os.stat(TRUTH)", _NOT_GOVERNED),
    Attack("learn the size of the truth", "files", "os.path.getsize(TRUTH)", _NOT_GOVERNED),
    Attack("learn that a file outside exists", "files", "os.stat('/etc/passwd')", _NOT_GOVERNED),
]
