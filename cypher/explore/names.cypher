// Every name by which this graph can be asked: of dishes and all other things, motions, states, videos, dish types and
// kinds of food.
// column: kind
// column: name
// mode: read
// scans: all names are asked for
CALL () {
  MATCH (l:Label) RETURN 'thing' AS kind, l.name AS name
  UNION MATCH (v:Verb) RETURN 'motion' AS kind, v.name AS name
  UNION MATCH (s:State) WHERE s.name <> '' RETURN 'state' AS kind, s.name AS name
  UNION MATCH (v:Video) RETURN 'video' AS kind, v.name AS name
  UNION MATCH (d:DishType) RETURN 'dish type' AS kind, d.name AS name
  UNION MATCH (k:Kind) WHERE k.name STARTS WITH 'kind:' RETURN 'kind of food' AS kind, substring(k.name, 5) AS name
}
RETURN kind, name
ORDER BY kind, name
