"""Plans for other programs and for people: exports, pictures, pages."""
