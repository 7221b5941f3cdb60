// The tasks that videos share: units that two or more videos show one right after the other, the longest runs first, in
// how many videos, and the first ten of these.
// param: least INTEGER
// param: most INTEGER
// default: least=3
// default: most=10
// column: steps
// column: motions
// column: foods
// column: videos
// column: first
// mode: read
// scans: which videos share anything is known only from all of them
MATCH (a:Video)
CALL (a) {  // one video after another: what it shares with others is in memory, and not what all share
  MATCH (a)<-[one:SEEN_IN]-(m:Motion)-[two:SEEN_IN]->(b:Video)
  WHERE a.name < b.name
  WITH b, one.position - two.position AS apart, one.position AS step, m ORDER BY b.name, apart, step
  WITH b, apart, collect({step: step, unit: m}) AS shared
  UNWIND range(0, size(shared) - 1) AS place
  WITH b, apart, shared[place] AS it, shared[place].step - place AS run, place ORDER BY place
  WITH b, apart, run, collect(it.unit) AS units
  WHERE size(units) >= $least
  RETURN units, b
}
UNWIND [a.name, b.name] AS video
WITH DISTINCT units, video ORDER BY video
WITH units, collect(video) AS names
WITH units, size(names) AS videos, names[..10] AS first, [m IN units | m.verb] AS motions
ORDER BY size(units) DESC, videos DESC, first, motions
LIMIT $most
RETURN size(units) AS steps, motions, COLLECT {
  UNWIND units AS m
  MATCH (o:Object)-[:INPUT_OF]->(m)
  WHERE EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
  RETURN DISTINCT o.label ORDER BY o.label
} AS foods, videos, first
ORDER BY steps DESC, videos DESC, first, motions
