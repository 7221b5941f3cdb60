// How many units the FOON has.
// column: units
// mode: read
RETURN COUNT { (:Motion) } AS units
