"""Task trees and whole FOONs in the forms of other programs: graphs, recipes, planning problems, behaviour trees.

Every module writes one format and answers its text; nothing here reads or writes files. Equal content gives equal
text, byte for byte (C9).
"""
