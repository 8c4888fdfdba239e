"""Collection is put off until the last thread is done, and is never left off or switched on by others."""

from __future__ import annotations

import gc
import threading

from c4s.garbage import put_off


def test_collection_stays_off_until_the_last_block_ends():
    inside, leave = threading.Event(), threading.Event()

    def other() -> None:
        with put_off():
            inside.set()
            leave.wait()

    thread = threading.Thread(target=other)
    with put_off():
        thread.start()
        inside.wait()
    assert not gc.isenabled()
    leave.set()
    thread.join()
    assert gc.isenabled()


def test_what_was_off_stays_off():
    gc.disable()
    try:
        with put_off(), put_off():
            pass
        assert not gc.isenabled()
    finally:
        gc.enable()
