// Foods that operators are done to are found by the name that names are compared by.
// mode: write
CREATE INDEX food_canonical IF NOT EXISTS FOR (m:Food) ON (m.canonical)
