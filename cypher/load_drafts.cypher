// Makes drafts of recipes, or gives those that are there their new content. They stand apart from all that videos teach.
// param: drafts LIST<MAP>
// mode: write
UNWIND $drafts AS row
MERGE (d:Draft {name: row.name})
SET d = row
