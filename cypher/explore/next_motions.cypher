// What comes after a motion: the motions of the next steps in the videos that show it, the most frequent first.
// param: motion STRING
// param: most INTEGER
// example: motion=chop
// default: most=10
// column: next
// column: times
// column: videos
// mode: read
MATCH (:Motion {verb: $motion})-[follows:NEXT]->(after:Motion)
WITH after.verb AS next, follows.video AS video ORDER BY video
RETURN next, count(*) AS times, collect(DISTINCT video) AS videos
ORDER BY times DESC, next
LIMIT $most
