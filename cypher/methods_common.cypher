// What of all that was learnt matters to every question, however large the FOON is: the operators with their evidence,
// each with the food that it is most often done to and most often changes (usual_foods) and with all appliances; what they
// give, where they are done and from where they bring what kinds of food; in which states kinds are found; and how often
// foods of each kind join where.
// column: operators
// column: usual
// column: gives
// column: places
// column: appliances
// column: brings
// column: states
// column: stage_types
// column: beside
// column: cooked
// mode: read
// scans: all operators are asked for; there are as many as ways to do something
CALL () {
  MATCH (o:Operator)
  RETURN collect(o) AS found
}
RETURN
  COLLECT {
    MATCH (:Matter {name: 'any:thing'})<-[d:DONE_TO]-(o)
    RETURN [id(o), o.motion, o.tools, [d.units, d.changed, d.seen, d.changes]]
  } AS operators,
  COLLECT {
    UNWIND found AS o
    UNWIND CASE o.most_done WHEN o.most_changed THEN [o.most_done] ELSE [o.most_done, o.most_changed] END AS name
    MATCH (m:Matter {name: name})
    USING INDEX m:Matter(name)
    MATCH (m)<-[d:DONE_TO]-(o)
    RETURN [id(o), m.name, [d.units, d.changed, d.seen, d.changes]]
  } AS usual,
  COLLECT { UNWIND found AS o MATCH (o)-[r:GIVES]->(s) RETURN [id(o), s.name, r.count] } AS gives,
  COLLECT { UNWIND found AS o MATCH (o)-[r:DONE_IN]->(u) RETURN [id(o), u.name, r.count] } AS places,
  COLLECT {
    MATCH (m:Appliance)<-[d:DONE_TO]-(o)
    RETURN [id(o), m.name, [d.units, d.changed, d.seen, d.changes]]
  } AS appliances,
  COLLECT {
    MATCH (m:Kind|Form)<-[r:BRINGS]-(o)
    RETURN [id(o), m.name, r.out_of, r.count]
  } AS brings,
  COLLECT {
    MATCH (m:Kind)-[:FOUND_AS]->(s)
    WITH m, collect(s.name) AS names
    RETURN [m.name, names]
  } AS states,
  COLLECT {
    MATCH (k:Kind)-[r:JOINS_AT]->(t)
    RETURN [k.name, r.dish_type, t.work, t.heated, t.joins, r.count]
  } AS stage_types,
  COLLECT { MATCH (k:Kind)-[r:JOINS_BESIDE]->(other) RETURN [k.name, other.name, r.count] } AS beside,
  COLLECT { MATCH (k:Kind)-[r:COOKED_BY]->(v) RETURN [k.name, v.name, r.count] } AS cooked
