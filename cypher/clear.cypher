// Takes the whole FOON away, the record of the schema apart.
// mode: write
// scans: everything goes
MATCH (n:Object|Motion|Video|DishType|Ingredient|State|Verb)
DETACH DELETE n
