// Where foods of one kind join dishes: what is done to the whole there, whether it is heated then or later, whether it is
// the dish's own line or one that joins it, and how often, in which dish types.
// param: kind STRING
// example: kind=oil
// column: work
// column: heated
// column: joins
// column: times
// column: dish_types
// mode: read
MATCH (:Kind {name: 'kind:' + $kind})-[r:JOINS_AT]->(t:StageType)
WITH t, r ORDER BY r.dish_type
WITH t, sum(r.count) AS times, collect(r.dish_type) AS dish_types
RETURN t.work AS work, t.heated AS heated, t.joins AS joins, times, dish_types
ORDER BY times DESC, work, heated, joins
