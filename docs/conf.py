"""How the documents become a site: ``make docs``.

Sphinx with MyST and Furo: the configuration may lie beside the documents, docstrings are read without another plug-in,
and one page is one Markdown file that a forge shows as well.
"""

from foon_kg import __version__

project = "foon-kg"
author = "the foon-kg team"
copyright = "the foon-kg team, MIT licence"  # noqa: A001 - the name that Sphinx asks for
release = version = __version__
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 3
exclude_patterns = ["_build", "__pycache__"]
suppress_warnings = ["myst.xref_missing", "misc.highlighting_failure"]
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_type_aliases = {"Paths": "str"}
html_theme = "furo"
html_title = f"foon-kg {version}"
html_show_sourcelink = False
