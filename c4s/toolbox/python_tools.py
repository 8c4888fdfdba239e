"""Programmatic control: editor Python as background jobs, and reading what they print."""

from __future__ import annotations

from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.size import ANSWER_SIZE, AROUND, ASKED_SIZE, clipped, part_that_fits
from c4s.toolbox.tool import MOST_OFFSET, Arguments, Tool, ToolResult, number, text
from c4s.toolbox.workbench import JOBS_LISTED, JobLimits, ScriptJob, Workbench

GROUP = "Programmatic control"
SYNC_WAIT_S = 60.0
MOST_WAIT_S = 120.0
CANCEL_WAIT_S = 2.0
DEFAULT_BYTES, MOST_BYTES = 15_000, 150_000
MAX_BYTES = "max_bytes"
ERROR_BYTES = 4_000
"""Most of an error with its traceback that is told: its beginning and its end."""


def _execute(bench: Workbench, arguments: Arguments) -> ToolResult:
    waiting = arguments.get("execution_mode", "async") == "sync"
    job = bench.start_job(arguments["script"], wait_s=SYNC_WAIT_S if waiting else 0.0)
    started: dict[str, object] = {"job_id": job.id, "log_path": job.log_path}
    if waiting:
        return ToolResult(started | _state(bench, job, {}))
    before = [other.id for other in bench.jobs.values() if other is not job and not other.finished]
    if job.state == "queued" and before:
        return ToolResult(started | {"status": "queued", "behind": before, "hint": f"{HINT}; one job runs at a time"})
    return ToolResult(started | {"status": "started", "hint": HINT})


def _state(bench: Workbench, job: ScriptJob, arguments: Arguments) -> dict[str, object]:
    """State of a job, and the end of its output or the part that was asked for."""
    most = arguments.get(MAX_BYTES, DEFAULT_BYTES)
    reply = bench.read_job(job, wait_s=arguments.get("wait_s", 0.0), offset=arguments.get("offset"), max_bytes=most)
    page = reply.result
    error = {"error": clipped(reply.error, ERROR_BYTES)} if reply.error is not None else {}
    room = (ASKED_SIZE if MAX_BYTES in arguments else ANSWER_SIZE) - AROUND - 2 * ERROR_BYTES * bool(error)
    of_end = "offset" not in arguments
    given = "\n".join(page.python_logs)
    output = part_that_fits(given, room, of_end=of_end)
    left_out = len(given.encode()) - len(output.encode())
    begins = page.offset + (left_out if of_end else 0)
    ends = page.offset + len(output.encode()) if left_out and not of_end else page.next_offset
    total = page.next_offset if page.log_bytes is None else page.log_bytes
    return {
        "status": job.state,
        **error,
        "output": output,
        "output_bytes": total,
        "truncated": begins > 0 or ends < total,
        **({"begins": begins, "next": ends if ends < total else None} if begins or ends < total else {}),
    }


def _named(bench: Workbench, arguments: Arguments) -> ScriptJob:
    wanted, path = arguments.get("job_id"), arguments.get("log_path")
    found = [job for job in bench.jobs.values() if wanted in (None, job.id) and path in (None, job.log_path)]
    if not found:
        known = ", ".join(list(bench.jobs)[-JOBS_LISTED:])
        raise ToolRefused(
            f"no job {wanted or path!r} in this run" if bench.jobs else "no job was started in this run",
            todo=f"the last ones are {known}" if known else "",
        )
    return found[-1]


def _read(bench: Workbench, arguments: Arguments) -> ToolResult:
    action = arguments.get("action", "read")
    if action == "list":
        return ToolResult(_jobs(bench))
    job = _named(bench, arguments)
    if action == "cancel" and not job.finished:
        bench.cancel_job(job)
        state = _state(bench, job, {"wait_s": CANCEL_WAIT_S, **arguments})
        hint = {"hint": "asked to end: it does so at its next Python instruction, or is ended at its time limit"}
        return ToolResult({"job_id": job.id, "log_path": job.log_path} | state | ({} if job.finished else hint))
    return ToolResult({"job_id": job.id, "log_path": job.log_path} | _state(bench, job, arguments))


def _jobs(bench: Workbench) -> dict[str, object]:
    """The jobs that run or wait, and the last ones that ended."""
    unfinished = bench.unfinished()
    ended = [job for job in bench.jobs.values() if job.finished][-JOBS_LISTED:]
    return {
        "jobs": [{"job_id": job.id, "status": job.state} for job in [*unfinished, *reversed(ended)]],
        "running_or_queued": len(unfinished),
        "total": len(bench.jobs),
    }


HINT = "read_job_log tells the state and the output"
TOOLS = (
    Tool(
        "execute_python_script",
        GROUP,
        "Run Python in the editor (`import unreal`) as a background job. Gives a "
        "job id and log path at once, and whether it has started or is queued behind another; read_job_log tells its "
        f"state and output. A job is ended after {JobLimits.script_s:.0f} s; where it cannot be (a loop inside C), the "
        "editor is ended with it, and with that the run. Names that a script defines are there for the next one.",
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
        "State (queued, running, done or error) and the end of the output of a job, by default the last; or the list "
        "of jobs; or end a job.",
        _read,
        {
            "job_id": text("Job id."),
            "log_path": text("Log path, in place of the id."),
            "action": {
                "enum": ["read", "list", "cancel"],
                "description": "read (default). list: the jobs with their states. cancel: end the job.",
            },
            MAX_BYTES: {
                "type": "integer",
                "minimum": 1,
                "maximum": MOST_BYTES,
                "description": f"How much of the output (default {DEFAULT_BYTES} bytes).",
            },
            "offset": {
                "type": "integer",
                "minimum": 0,
                "maximum": MOST_OFFSET,
                "description": "Byte of the output to read from, such as the `next` of the last answer (default: the "
                "end of the output).",
            },
            "wait_s": number("How long to wait for the end of the job, in seconds.", minimum=0, maximum=MOST_WAIT_S),
        },
        asks=MAX_BYTES,
    ),
)
