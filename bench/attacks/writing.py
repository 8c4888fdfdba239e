"""Changing what is not one's own."""

from __future__ import annotations

from bench.attacks.row import Attack

WRITING = [
    Attack("write beside the truth", "files", "open(TRUTH + '.new', 'w').write('x')"),
    Attack("delete the truth", "files", "os.unlink(TRUTH)"),
    Attack("move the truth here", "files", "os.rename(TRUTH, 'stolen')"),
    Attack(
        "overwrite the toolbox",
        "files",
        "open(os.path.join(os.path.dirname(c4s.__file__), 'toolbox/client.py'), 'a').write('x')",
    ),
    Attack(
        "overwrite the editor scripts",
        "files",
        "open(os.path.join(os.path.dirname(c4s.__file__), 'editor', 'snapshot.py'), 'a')",
    ),
    Attack(
        "plant a module beside numpy", "files", "open(os.path.join(os.path.dirname(numpy.__file__), 'evil.py'), 'w')"
    ),
    Attack(
        "plant a program beside the interpreter",
        "files",
        "open(os.path.join(os.path.dirname(sys.executable), 'evil'), 'w')",
    ),
    Attack("overwrite the compiled kernels", "files", "open(next(iter(glob.glob(KERNELS))), 'ab').write(b'x')"),
    Attack("write under /usr", "files", "open('/usr/lib/evil', 'w')"),
    Attack("write under /tmp", "files", "open('/tmp/evil', 'w')"),
    Attack("write into shared memory", "files", "open('/dev/shm/evil', 'w')"),
    Attack("forge the job log", "files", "open(os.path.join(LOGS, 'job-1.log'), 'w').write('all is well')"),
    Attack("forge the engine log", "files", "open(os.path.join(LOGS, 'engine.log'), 'w').write('all is well')"),
    Attack(
        "forge the trajectory",
        "files",
        "open(os.path.join(os.path.dirname(LOGS), 'trajectory.jsonl'), 'a').write('{}')",
    ),
    Attack("write /etc/passwd", "files", "open('/etc/passwd', 'a')"),
    Attack("write /etc/ld.so.preload", "files", "open('/etc/ld.so.preload', 'w')"),
    Attack("write /etc/cron.d/evil", "files", "open('/etc/cron.d/evil', 'w')"),
    Attack("write /root/.bashrc", "files", "open('/root/.bashrc', 'a')"),
    Attack("write /root/.ssh/authorized_keys", "files", "open('/root/.ssh/authorized_keys', 'a')"),
    Attack("write /usr/bin/evil", "files", "open('/usr/bin/evil', 'w')"),
    Attack("write /lib/evil.so", "files", "open('/lib/evil.so', 'w')"),
    Attack("write /bin/evil", "files", "open('/bin/evil', 'w')"),
    Attack("write /var/tmp/evil", "files", "open('/var/tmp/evil', 'w')"),
    Attack("write /run/evil", "files", "open('/run/evil', 'w')"),
    Attack("write /home/evil", "files", "open('/home/evil', 'w')"),
    Attack("write /evil", "files", "open('/evil', 'w')"),
    Attack("write /dev/evil", "files", "open('/dev/evil', 'w')"),
    Attack("write /dev/tty", "files", "open('/dev/tty', 'w')"),
    Attack("write /dev/ptmx", "files", "open('/dev/ptmx', 'r+')"),
    Attack("write /dev/console", "files", "open('/dev/console', 'w')"),
    Attack("write /dev/kmsg", "files", "open('/dev/kmsg', 'w')"),
    Attack("write /dev/vda", "files", "open('/dev/vda', 'r+')"),
    Attack("write /proc/self/oom_score_adj", "files", "open('/proc/self/oom_score_adj', 'w')"),
    Attack("write /proc/self/mem", "files", "open('/proc/self/mem', 'r+')"),
    Attack("write /proc/sysrq-trigger", "files", "open('/proc/sysrq-trigger', 'w')"),
    Attack("write /proc/sys/kernel/core_pattern", "files", "open('/proc/sys/kernel/core_pattern', 'w')"),
    Attack(
        "write /sys/kernel/mm/transparent_hugepage/enabled",
        "files",
        "open('/sys/kernel/mm/transparent_hugepage/enabled', 'w')",
    ),
    Attack("write /sys/power/state", "files", "open('/sys/power/state', 'w')"),
    Attack("write /sys/fs/cgroup/cgroup.procs", "files", "open('/sys/fs/cgroup/cgroup.procs', 'w')"),
    Attack(
        "plant a .pth beside numpy",
        "files",
        "open(os.path.join(os.path.dirname(os.path.dirname(numpy.__file__)), 'evil.pth'), 'w')",
    ),
    Attack(
        "plant a sitecustomize",
        "files",
        "open(os.path.join(os.path.dirname(os.path.dirname(numpy.__file__)), 'sitecustomize.py'), 'w')",
    ),
    Attack(
        "plant a usercustomize in HOME's library",
        "files",
        "(os.makedirs(os.path.join(os.path.dirname(c4s.__file__), '..', 'usercustomize')))",
    ),
    Attack("replace the package c4s", "files", "os.rename(os.path.dirname(c4s.__file__), 'c4s')"),
    Attack("delete a part of c4s", "files", "os.unlink(os.path.join(os.path.dirname(c4s.__file__), 'errors.py'))"),
    Attack("empty a part of c4s", "files", "os.truncate(os.path.join(os.path.dirname(c4s.__file__), 'errors.py'), 0)"),
    Attack("make a folder beside the truth", "files", "os.mkdir(TRUTH + '.d')"),
    Attack("delete the withheld folder", "files", "os.rmdir(os.path.dirname(TRUTH))"),
    Attack("swap the content folder for another", "files", "os.rename(CONTENT, CONTENT + '.old')"),
    Attack("put scratch in the place of the content", "files", "os.rename(os.getcwd(), CONTENT)"),
    Attack(
        "move content out of its folder",
        "files",
        "(open(CONTENT + '/x', 'w').close(), os.rename(CONTENT + '/x', ROOT + '/x'))",
    ),
    Attack("write another attempt's submission", "files", "open(os.path.join(ROOT, 'other', 'submission', 'x'), 'w')"),
    Attack(
        "read another attempt's trajectory", "files", "open(os.path.join(ROOT, 'other', 'trajectory.jsonl')).read()"
    ),
    Attack("write the attempt's outcome", "files", "open(os.path.join(os.path.dirname(CONTENT), 'outcome.json'), 'w')"),
    Attack(
        "write the attempt's manifest", "files", "open(os.path.join(os.path.dirname(CONTENT), 'manifest.json'), 'w')"
    ),
    Attack("delete the logs", "files", "os.rmdir(LOGS)"),
    Attack("write into the pack", "files", "open(os.path.join(PACK, 'pack.json'), 'a')"),
    Attack("delete from the pack", "files", "os.unlink(os.path.join(PACK, 'pack.json'))"),
    Attack("add to the pack", "files", "open(os.path.join(PACK, 'evil.glb'), 'w')"),
    Attack("move a file of the pack", "files", "os.rename(os.path.join(PACK, 'pack.json'), 'pack.json')"),
    Attack("map a pack's file for writing", "files", "os.open(os.path.join(PACK, 'pack.json'), os.O_RDWR)"),
]
