"""The page ``/teach``: a draft beside what was said, edited and accepted in place."""
