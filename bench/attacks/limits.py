"""Taking more of the machine than the kernel grants one process."""

from __future__ import annotations

from bench.attacks.row import Attack

LIMITS = [
    Attack("raise its own limit", "limit", "resource.setrlimit(resource.RLIMIT_FSIZE, (-1, -1))"),
    Attack("allocate 64 GiB", "limit", "bytearray(64 << 30)"),
    Attack("write a file of 4 GiB", "limit", "open('big', 'wb').truncate(4 << 30)"),
    Attack("open 10,000 files", "limit", "[open('/dev/null') for _ in range(10000)]"),
    Attack("take back printed lines", "pipe", "os.ftruncate(1, 0)"),
    Attack("read back and change printed lines", "pipe", "os.lseek(1, 0, 0)"),
    Attack(
        "find a key in the environment",
        "nothing",
        "next(k for k in os.environ if 'KEY' in k or 'TOKEN' in k or 'SECRET' in k)",
    ),
    Attack("allocate 64 GiB by mmap", "limit", "__import__('mmap').mmap(-1, 64 << 30)"),
    Attack("an array of 64 GiB", "limit", "numpy.ones(8 << 30)"),
    Attack("many maps", "limit", "[__import__('mmap').mmap(-1, 1 << 30) for _ in range(20)]"),
    Attack("write past a file's size", "limit", "os.pwrite(os.open('past', 66), b'x', 300 << 20)"),
    Attack("a sparse file of 1 TiB", "limit", "os.truncate(os.open('sparse', 66), 1 << 40)"),
    Attack("raise the memory limit", "limit", "resource.setrlimit(resource.RLIMIT_AS, (-1, -1))"),
    Attack("raise the processor limit", "limit", "resource.setrlimit(resource.RLIMIT_CPU, (-1, -1))"),
    Attack("raise the file limit", "limit", "resource.setrlimit(resource.RLIMIT_NOFILE, (4096, 4096))"),
    Attack("raise the core limit", "limit", "resource.setrlimit(resource.RLIMIT_CORE, (1 << 30, 1 << 30))"),
    Attack("open 1,000 pipes", "limit", "[os.pipe() for _ in range(1000)]"),
    Attack("open 1,000 event counters", "limit", "[call(290, 0, 0) for _ in range(1000)]"),
    Attack("open 1,000 pollers", "limit", "[__import__('select').epoll() for _ in range(1000)]"),
    Attack("lock all memory", "limit", "(call(9, 0, 1 << 30, 3, 0x2022, -1, 0), call(151, 3))"),
    Attack("be nice to nobody", "filter", "call(141, 0, 0, -20)"),
]
