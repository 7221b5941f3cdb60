"""Facts that can be read and changed: kitchens, names, states."""
