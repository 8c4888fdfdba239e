"""Attacks that exhaust or break their engine: each goes on for ever, and must end it for the reason given."""

from __future__ import annotations

_ON_SOCKETS = (
    "import os, socket, stat\nfor n in range(3, 1024):\n try:\n  if stat.S_ISSOCK(os.fstat(n).st_mode): {}\n"
    " except OSError: pass"
)
_MIB = "bytes(1 << 20)"
_MACHINE_CODE = (
    "import ctypes, mmap\npage = mmap.mmap(-1, 4096, prot=7)\npage.write(bytes.fromhex({!r}))\n"
    "ctypes.CFUNCTYPE(ctypes.c_long)(ctypes.addressof(ctypes.c_char.from_buffer(page)))()"
)
ENDED = {
    "fill the memory": ("b = bytearray(1 << 30)\nfor i in range(0, 1 << 30, 4096): b[i] = 1", "of memory"),
    "fill the memory by maps": (
        "import mmap\nheld = []\nwhile True:\n held.append(mmap.mmap(-1, 64 << 20))\n"
        " for i in range(0, 64 << 20, 4096): held[-1][i] = 1",
        "of memory",
    ),
    "thread bomb": (
        "import threading\nthreading.stack_size(65536)\n"
        "while True: threading.Thread(target=threading.Event().wait, daemon=True).start()",
        "threads",
    ),
    "fill the disk": ("n = 0\nwhile True:\n open(f'big{n}', 'wb').write(bytes(16 << 20))\n n += 1", "files take"),
    "fill the disk without a name": (
        f"import os\nh = []\nwhile True:\n h.append(open('h', 'wb', 0))\n os.unlink('h'); h[-1].write({_MIB} * 9)",
        "files take",
    ),
    "fill the disk through a sparse map": (
        "import mmap\nf = open('s', 'w+b'); f.truncate(200 << 20)\nm = mmap.mmap(f.fileno(), 200 << 20)\n"
        "for i in range(0, 200 << 20, 4096): m[i] = 1",
        "files take",
    ),
    "wear the disk": (
        f"import os\nwhile True:\n f = open('again', 'wb', 0); f.write({_MIB} * 30); os.fsync(f.fileno()); f.close()",
        "in all",
    ),
    "write a hundred thousand files": ("for n in range(100_000): open(f'f{n}', 'w')", "files"),
    "nest folders without end": ("import os\nwhile True: os.mkdir('d' * 99); os.chdir('d' * 99)", "files"),
    "use the processor for ever": ("", "SIGKILL|SIGXCPU"),
    "print for ever": ("import os\nwhile True: os.write(1, b'x' * 65536)", "printed more"),
    "exit": ("import os; os._exit(0)", "exit code 0"),
    "crash": ("import ctypes; ctypes.string_at(1)", "SIGSEGV"),
    "32-bit call by int 0x80": (_MACHINE_CODE.format("b814000000cd80c3"), "SIGSYS"),
    "cut the line to the host": (_ON_SOCKETS.format("socket.socket(fileno=os.dup(n)).shutdown(2)"), "exit code 1"),
    "speak nonsense to the host": (_ON_SOCKETS.format("os.write(n, b'\\xff' * 64)"), "message"),
}
