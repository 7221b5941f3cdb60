// The surest drafts of each dish type.
// param: dish_types LIST<STRING>
// param: most INTEGER
// column: id
// column: title
// column: dish_type
// column: table
// column: units
// column: left_out
// column: confidence
// mode: read
UNWIND $dish_types AS dish_type
CALL (dish_type) {
  MATCH (d:Draft {dish_type: dish_type})
  RETURN d ORDER BY d.confidence DESC, d.name LIMIT $most
}
RETURN d.id AS id, d.title AS title, d.dish_type AS dish_type, d.table AS table, d.units AS units,
  d.left_out AS left_out, d.confidence AS confidence
