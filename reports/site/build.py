"""Building the site: pages that are as they were stay, others are written, all of it takes the old one's place."""

from __future__ import annotations

import shutil
from pathlib import Path

from c4s.files import digest, write_text
from c4s.folders import beside, put_folder
from reports.frame import STATIC, SiteContext, SitePage, code_digest, environment, links
from reports.pages import KINDS
from reports.place import MARKER, check_place
from reports.site.ledger import LEDGER, PageMade, SiteLedger, ledger_of
from reports.viewer import three_script
from warehouse.database import held_open
from warehouse.release import refuse_leaks, secrets_of
from warehouse.stamps import case_stamps


def build_site(warehouse: Path, site: Path, suites: Path | None = None) -> Path:
    """Render all pages from the warehouse; returns the leaderboard page. Old pages are replaced.

    Where nothing that decides the pages has changed since they were made, they stay; else those stay of whose parts
    nothing has.

    Of private cases the pages tell means over all of them and nothing else; they are looked through for what such
    cases hold before they are put in their place.

    Args:
        warehouse: what the pages are made of.
        site: where they lie.
        suites: where suites lie, whose files tell more of what must not be published.

    Raises:
        BadInput: the folder holds something else than pages of c4s.
        MachineryFault: a page would tell of a private case; the old pages stay.
    """
    check_place(site)
    with held_open(warehouse):
        return _build(warehouse, site, suites)


def _build(warehouse: Path, site: Path, suites: Path | None) -> Path:
    old, made_of = ledger_of(site), _made_of(warehouse, suites)
    if old is not None and old.made_of == made_of and _is_whole(site, old):
        return site / links.LEADERBOARD
    with beside(site) as scratch:
        secrets = secrets_of(warehouse, suites, [three_script().decode()])
        building = Building(SiteContext(warehouse, scratch / site.name), site, old)
        ledger = building.write(made_of, secrets.digest())
        refuse_leaks(scratch / site.name, secrets, building.looked_through(ledger.secrets))
        put_folder(scratch / site.name, site, marker=MARKER)
    return site / links.LEADERBOARD


def _is_whole(site: Path, ledger: SiteLedger) -> bool:
    """Whether every page is there, and all that pages show."""
    own = {f"static/{path.relative_to(STATIC).as_posix()}" for path in STATIC.rglob("*") if path.is_file()}
    shown = {name for page in ledger.pages.values() for name in page.files}
    return all((site / name).is_file() for name in own | shown | ledger.pages.keys())


def _made_of(warehouse: Path, suites: Path | None) -> str:
    """Digest of all that decides the site."""
    listed = []
    for path in sorted(suites.rglob("*")) if suites is not None else ():
        seen = path.stat()
        listed.append([str(path), seen.st_size, seen.st_mtime_ns])
    return digest([code_digest(), sorted([*key, told] for key, told in case_stamps(warehouse).items()), listed])


class Building:
    """One build: pages in a new folder, those that need not be written anew taken over from the old one."""

    def __init__(self, site: SiteContext, old_folder: Path, old: SiteLedger | None) -> None:
        self._site = site
        self._old_folder = old_folder
        self._old = old
        self._kept: set[str] = set()

    def write(self, made_of: str, secrets: str) -> SiteLedger:
        """Write the folder; returns what lies in it."""
        site = self._site
        site.folder.mkdir()
        write_text(site.folder / MARKER, "Pages made by c4s: `c4s report` replaces this folder.\n")
        shutil.copytree(STATIC, site.folder / "static")
        pages = [page for kind in KINDS for page in kind(site)]
        navigation = [page for page in pages if page.navigation]
        shared = digest([code_digest(), [[page.path, page.navigation] for page in navigation]])
        ledger = SiteLedger(made_of=made_of, secrets=secrets)
        for page in pages:
            told = digest([shared, page.path, page.template, page.made_of])
            ledger.pages[page.path] = self._keep(page, told) or self._write(page, told, navigation)
        ledger.write(site.folder / LEDGER)
        return ledger

    def looked_through(self, secrets: str) -> set[str]:
        """Files that are the old site's, where that was looked through for the same secrets."""
        return self._kept if self._old is not None and self._old.secrets == secrets else set()

    def _keep(self, page: SitePage, made_of: str) -> PageMade | None:
        """Take a page over with what it shows; None where it has to be written."""
        old = None if self._old is None else self._old.pages.get(page.path)
        if old is None or old.made_of != made_of:
            return None
        files = [page.path, *old.files]
        if not all((self._old_folder / name).is_file() for name in files):
            return None
        for name in files:
            self._take(name)
        return old

    def _take(self, name: str) -> None:
        there, here = self._old_folder / name, self._site.folder / name
        if here.exists():
            return
        here.parent.mkdir(parents=True, exist_ok=True)
        try:
            here.hardlink_to(there)
        except OSError:
            shutil.copy2(there, here)
        self._kept.add(name)

    def _write(self, page: SitePage, made_of: str, navigation: list[SitePage]) -> PageMade:
        path = self._site.folder / page.path
        path.parent.mkdir(parents=True, exist_ok=True)
        template = environment().get_template(page.template)
        with self._site.putting() as files:
            written = template.render(root=page.root, page=page, navigation=navigation, **page.values())
        path.write_text(written, encoding="utf-8")
        return PageMade(made_of=made_of, files=sorted(files))
