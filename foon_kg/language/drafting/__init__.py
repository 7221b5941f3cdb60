"""From a narration to the draft of a subgraph, with what a FOON knows of such actions; a person reviews it.

``draft()`` is the whole of it: ``actions`` become units one after another in a ``scene`` that remembers where and how
every object is, with ``precedents`` of the FOON for whatever the narration leaves unsaid.
"""

from foon_kg.language.drafting.drafting import draft
from foon_kg.model.drafts import Draft, DraftUnit

__all__ = ["Draft", "DraftUnit", "draft"]
