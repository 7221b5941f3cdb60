"""What was written to a cluster last, so that who reads next sees it, whichever member and whichever program.

A cluster's followers are behind its leader for a while. A bookmark names the last transaction that a program wrote; a
member that is given it answers once it has that transaction. The driver keeps them for one program; here they are kept
among what all programs of this user keep (:mod:`foon_kg.model.kept`): ``foon plan`` reads what ``foon load`` wrote.
"""

from __future__ import annotations

import json
from pathlib import Path

import neo4j
from neo4j.api import BookmarkManager, Bookmarks

from foon_kg.model import kept
from foon_kg.store.settings import ConnectionSettings

_FOLDER = "bookmarks"


def bookmark_folder() -> Path:
    """Return the folder in which bookmarks are kept."""
    return kept.cache_folder() / _FOLDER


def bookmarks_of(settings: ConnectionSettings) -> BookmarkManager:
    """Return what keeps the bookmarks of the database of these ``settings``."""
    asked = json.dumps([settings.uri, settings.database])

    def read() -> Bookmarks:
        body = kept.find(_FOLDER, asked)
        return Bookmarks.from_raw_values(json.loads(body) if body else ())

    def write(bookmarks: Bookmarks) -> None:
        body = json.dumps(sorted(bookmarks.raw_values))
        if body != kept.find(_FOLDER, asked):
            kept.keep(_FOLDER, asked, body)

    return neo4j.GraphDatabase.bookmark_manager(bookmarks_supplier=read, bookmarks_consumer=write)
