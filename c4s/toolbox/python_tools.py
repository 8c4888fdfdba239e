"""Programmatic control: editor Python as background jobs, and reading what they print."""

from __future__ import annotations

from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.tool import Arguments, Tool, ToolResult, number, text
from c4s.toolbox.workbench import JOB_LIMIT_S, ScriptJob, Workbench

GROUP = "Programmatic control"
SYNC_WAIT_S = 60.0
MOST_WAIT_S = 120.0
DEFAULT_BYTES, MOST_BYTES = 20_000, 200_000


def _execute(bench: Workbench, arguments: Arguments) -> ToolResult:
    waiting = arguments.get("execution_mode", "async") == "sync"
    job = bench.start_job(arguments["script"], wait_s=SYNC_WAIT_S if waiting else 0.0)
    started = {"job_id": job.id, "log_path": job.log_path}
    if waiting:
        return ToolResult(started | _state(bench, job, DEFAULT_BYTES, 0.0))
    return ToolResult(started | {"status": "started", "hint": "read_job_log tells the state and the output"})


def _state(bench: Workbench, job: ScriptJob, limit: int, wait_s: float) -> dict[str, object]:
    """State and the last ``limit`` bytes of the output of a job."""
    reply = bench.read_job(job, wait_s=wait_s)
    lines: list[str] = []
    while True:
        lines += reply.result.python_logs
        if not reply.result.more:
            break
        reply = bench.read_job(job, offset=reply.result.next_offset)
    output = "\n".join(lines).encode()
    error = {"error": reply.error} if reply.error is not None else {}
    return {
        "status": "running" if reply.running else "error" if reply.failed else "done",
        **error,
        "output": output[-limit:].decode(errors="replace"),
        "output_bytes": len(output),
        "truncated": len(output) > limit,
    }


def _read(bench: Workbench, arguments: Arguments) -> ToolResult:
    wanted, path = arguments.get("job_id"), arguments.get("log_path")
    if wanted is None and path is None:
        if not bench.jobs:
            raise ToolRefused("no job was started in this run")
        job = list(bench.jobs.values())[-1]
    else:
        found = [job for job in bench.jobs.values() if wanted in (None, job.id) and path in (None, job.log_path)]
        if not found:
            raise ToolRefused(f"no job {wanted or path!r} in this run")
        job = found[-1]
    state = _state(bench, job, arguments.get("max_bytes", DEFAULT_BYTES), arguments.get("wait_s", 0.0))
    return ToolResult({"job_id": job.id, "log_path": job.log_path} | state)


TOOLS = (
    Tool(
        "execute_python_script",
        GROUP,
        "Run Python in the editor (`import unreal`) as a background job. Gives a "
        f"job id and log path at once; read_job_log tells its state and output. A job ends after "
        f"{JOB_LIMIT_S:.0f} s. Names that a script defines are there for the next one.",
        _execute,
        {
            "script": text("Python source."),
            "execution_mode": {
                "enum": ["async", "sync"],
                "description": f"async (default): return at once. sync: wait up to {SYNC_WAIT_S:.0f} s "
                "for the end and give the output too.",
            },
        },
        ("script",),
    ),
    Tool(
        "read_job_log",
        GROUP,
        "State (running, done or error) and output of a job, by default the last.",
        _read,
        {
            "job_id": text("Job id."),
            "log_path": text("Log path, in place of the id."),
            "max_bytes": {
                "type": "integer",
                "minimum": 1,
                "maximum": MOST_BYTES,
                "description": f"How much of the end of the output (default {DEFAULT_BYTES} bytes).",
            },
            "wait_s": number("How long to wait for the end of the job, in seconds.", minimum=0, maximum=MOST_WAIT_S),
        },
    ),
)
