"""What is read off a finished tree: its result, progress lines, schedule, shopping list, differences; the kitchen."""
