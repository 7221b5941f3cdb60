"""Task trees as pictures: SVG, PNG and a page that stands on its own. Needs the extra ``pictures``."""
