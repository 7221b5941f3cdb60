// Takes the whole FOON away, its record apart.
// mode: write
// scans: everything goes
MATCH (n:Object|Label|Motion|Video|DishType|Ingredient|State|Verb)
DETACH DELETE n
