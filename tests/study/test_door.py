"""Who gets in: the right key, from this machine, from the server's own pages."""

from __future__ import annotations

import stat
from pathlib import Path
from urllib.parse import urlsplit

import httpx
import pytest

from c4s.human import OpenStudy
from tests.study.conftest import PEOPLE, Serve

RIGHT = {"best": "A", "middle": "B", "worst": "C"}


def origin(link: str) -> str:
    return "{0.scheme}://{0.netloc}".format(urlsplit(link))


def test_a_request_for_another_name_is_refused(serve: Serve) -> None:
    """A site whose name was made to resolve to 127.0.0.1 sends its own name."""
    link = serve("serve", "yards").links[PEOPLE[0]]
    for host in ("evil.example", "127.0.0.1.evil.example", "evil.example:80"):
        assert httpx.get(link, headers={"Host": host}).status_code == 403
    assert httpx.get(link).status_code == 200


@pytest.mark.parametrize("page", ["http://evil.example", "http://127.0.0.1:1", "null", "https://127.0.0.1", None])
def test_an_answer_from_a_page_of_elsewhere_is_refused(serve: Serve, study: OpenStudy, page: str | None) -> None:
    link = serve("serve", "yards").links[PEOPLE[0]]
    headers = {} if page is None else {"Origin": page}
    assert httpx.post(f"{link}1", data=RIGHT, headers=headers).status_code == 403
    assert study.folder.answers.read_text() == ""
    assert httpx.post(f"{link}1", data=RIGHT, headers={"Origin": origin(link)}).status_code == 303
    assert len(study.folder.answers.read_text().splitlines()) == 1


def test_without_a_key_there_is_nothing(serve: Serve) -> None:
    link = serve("serve", "yards").links[PEOPLE[0]]
    for path in ("/", "/favicon.ico", f"/{'x' * 32}/", f"/{'x' * 32}/1", "/static/study.css", "//", "/%00/"):
        assert httpx.get(origin(link) + path).status_code == 404, path


def test_only_this_machine_is_listened_to(serve: Serve) -> None:
    served = serve("serve", "yards")
    assert all(urlsplit(link).hostname == "127.0.0.1" for link in served.links.values())
    port = urlsplit(served.links["organiser"]).port
    listening = [line.split() for line in Path("/proc/net/tcp").read_text().splitlines()[1:]]
    assert {row[1] for row in listening if row[1].endswith(f":{port:04X}") and row[3] == "0A"} == {
        f"0100007F:{port:04X}"
    }


def test_links_are_kept_for_their_owner_alone_and_outlive_the_server(serve: Serve, study: OpenStudy) -> None:
    first = serve("serve", "yards")
    assert stat.S_IMODE(study.folder.access.stat().st_mode) == 0o600
    first.kill()
    assert serve("serve", "yards").links == first.links
    assert len(set(first.links.values())) == len(PEOPLE) + 1


def test_every_answer_forbids_what_lies_outside(serve: Serve) -> None:
    link = serve("serve", "yards").links[PEOPLE[0]]
    for path in ("", "1", "1/A-1.png", "static/study.css", "nosuch", "99999"):
        headers = httpx.get(link + path).headers
        policy = headers["content-security-policy"]
        assert "default-src 'none'" in policy and "unsafe" not in policy and "frame-ancestors 'none'" in policy, path
        assert headers["cache-control"] == "no-store" and headers["x-content-type-options"] == "nosniff", path
        assert not {"set-cookie", "server", "date", "access-control-allow-origin"} & set(headers), path
