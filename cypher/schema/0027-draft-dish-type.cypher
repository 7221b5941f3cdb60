// Drafts are asked for by dish type.
// mode: write
CREATE INDEX draft_dish_type IF NOT EXISTS FOR (d:Draft) ON (d.dish_type)
