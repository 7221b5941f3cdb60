"""What a dish is composed of beside its frame: parts made apart, coats, layers, what its name and title promise."""
