"""Where runs, suites, packs and the warehouse lie for all machines: a folder that they share, or an object store."""

from c4s.run.store.base import STORE, Store
from c4s.run.store.content import send_suite, share_suite, shared_plan
from c4s.run.store.leases import FolderLeases, LeasePlace
from c4s.run.store.opening import open_store
from c4s.run.store.reach import StoreFault

__all__ = [
    "STORE",
    "FolderLeases",
    "LeasePlace",
    "Store",
    "StoreFault",
    "open_store",
    "send_suite",
    "share_suite",
    "shared_plan",
]
