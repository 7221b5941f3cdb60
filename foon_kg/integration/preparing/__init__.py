"""One food on its own, before it joins: how it is sold, what is asked of it, and what a cook owes it."""
